"""Memory that programs took goes back to the system."""

import subprocess
import sys

import pytest

# Blocks of a few MB, freed in another order than they were taken, below one that stays.
TAKEN = """
import ctypes, os
from exoid.fitting.solve.compiled.memory import give_back
{first}
libc = ctypes.CDLL(None)
libc.malloc.restype, libc.free.argtypes = ctypes.c_void_p, [ctypes.c_void_p]
def now():
    return int(open("/proc/self/statm").read().split()[1]) * os.sysconf("SC_PAGESIZE")
libc.free(libc.malloc(30_000_000))  # glibc keeps what is smaller from now on
before = now()
blocks = [libc.malloc(3_000_000) for _ in range(100)]
for each in blocks:
    ctypes.memset(each, 1, 3_000_000)
for each in blocks[:-1]:
    libc.free(each)
print(now() - before)
"""


def kept(first: str) -> int:
    """Bytes that a process keeps of 300 MB, of which it has freed 297."""
    told = subprocess.run(
        [sys.executable, "-c", TAKEN.format(first=first)],
        capture_output=True,
        text=True,
        check=True,
    )
    return int(told.stdout)


@pytest.mark.skipif(sys.platform != "linux", reason="others have no glibc")
def test_what_is_freed_goes_back_to_the_system():
    assert kept("give_back()") < 10e6
    assert kept("") > 200e6  # else the system does it by itself, and nothing is shown
