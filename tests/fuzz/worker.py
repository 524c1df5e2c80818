"""A process that reads mutants of one format, and writes a letter of what it thinks of each."""

import json
import os
import resource
import signal
import sys
import time
from contextlib import nullcontext
from mmap import mmap
from pathlib import Path
from tempfile import TemporaryDirectory

from .here import in_this_process
from .judge import ALONE, ASKED, CLASSES, ENDED, FAULT, HANG, Verdict, format_of, judged, original

LETTERS = "rtspaeWFH"  # of the classes, in their order
MEMORY = 3 << 30  # bytes
SECONDS = 2.0  # of the processor for one mutant: a hundred times what a file of a few kB takes
QUICK = "/dev/shm" if Path("/dev/shm").is_dir() else None  # a folder in memory


def work(name: str, seed: int, begin: int, until: list[float], letters: str) -> None:
    """Until the time is over, or a number is reached. A copy of this process reads; another goes on
    where it ends.

    The length of the file of letters says how far it is.
    """
    seconds, most = until
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)  # libraries in C write there
    mark, end = mmap(-1, 1), time.monotonic() + seconds
    with (
        TemporaryDirectory(dir=QUICK) as folder,
        in_this_process(mark),
        Path(letters).open("ab", buffering=0) as file,
    ):
        for which in range(len(format_of(name).samples)):
            original(name, which, Path(folder))  # loads the libraries
        while time.monotonic() < end and begin + file.tell() < most:
            child = os.fork()
            if child == 0:
                numbers = range(begin + file.tell(), int(most))
                read_on(name, seed, numbers, end, Path(folder), file)
            status = os.waitpid(child, 0)[1]
            file.seek(0, os.SEEK_END)
            if status:
                file.write(letter(ended(status, bool(mark[0]))))
                mark[0] = ASKED[0] = 0
    os._exit(0)  # a library may fail once more as it is freed


def read_on(name: str, seed: int, numbers: range, end: float, folder: Path, file) -> None:
    """These mutants; the system ends the process that takes too long over one."""
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    code = 1
    try:
        for number in numbers:
            signal.setitimer(signal.ITIMER_PROF, SECONDS)
            file.write(letter(judged(name, seed, number, folder).kind))
            if time.monotonic() > end:
                break
        code = 0
    finally:  # what is around it belongs to the other process
        os._exit(code)


def ended(status: int, in_library: bool) -> str:
    """What to think of a mutant over which the process ended."""
    if in_library:
        return ENDED
    if ASKED[0]:
        return ALONE
    late = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGPROF, signal.SIGKILL)
    return HANG if late else FAULT


def letter(kind: str) -> bytes:
    return LETTERS[CLASSES.index(kind)].encode()


def alone(name: str, seed: int, number: int, *, apart: bool) -> Verdict:
    """One mutant; `apart` as a command reads it, other libraries in processes of their own."""
    within = nullcontext() if apart else in_this_process(mmap(-1, 1))
    with TemporaryDirectory() as folder, within:
        return judged(name, seed, number, Path(folder))


if __name__ == "__main__":
    work(*json.loads(sys.argv[1]))
