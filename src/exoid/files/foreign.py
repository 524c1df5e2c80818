"""Files that another library parses: read where an endless loop or a lack of memory can be ended.

A damaged link in a binary file can send its library round for ever, or make it ask for all memory.
The reader runs in a process of its own with a limit of time and one of memory, both growing with
the file, and hands back plain arrays; nothing is unpickled, and nothing it prints is seen. The time
is the processor's: a loop spends it at once, and a machine that is busy or slow to load the library
takes none of it away from a sound file.
"""

import faulthandler
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from io import BytesIO
from pathlib import Path

import numpy as np

from exoid.files.library_faults import is_ours, plain

SECONDS, BYTES_PER_SECOND = 3.0, 50e3  # a tenth of what openpyxl takes, the slowest of them
WAITING = 60.0  # s more by the clock: to start, and beside what else the machine does
MEMORY, MEMORY_PER_BYTE = 2**30, 100  # bytes; the libraries themselves take 150 MB
FAULT = "fault"  # in place of arrays: why there are none
DIED_WITH_PARENT = 1  # prctl's PR_SET_PDEATHSIG
OUT_OF_TIME = getattr(signal, "SIGPROF", 0)  # ends a process in a loop of C as well; 0 on Windows

Arrays = dict[str, np.ndarray]


class ForeignError(ValueError):
    """A file that its library cannot read, in one line: what is wrong, where, and what to do."""


def read_apart(
    reader: Callable[[Path], Arrays], path: Path, advice: str, *, library: str = "numpy"
) -> Arrays:
    """What `reader(path)` gives, from a process of its own; it starts in the time of its imports.

    `reader` is a function of a module, which imports the `library` inside, and no more of exoid
    than it needs: the process imports it anew. Its arrays hold no Python objects, so texts have a
    fixed length. `advice` says what to do with a file that is damaged.

    **Raises** `ForeignError` where the reader fails, is not done in time, or runs out of memory;
    `OSError` when the file cannot be opened.
    """
    with path.open("rb") as file:  # a missing or locked file is not a damaged one
        size = os.fstat(file.fileno()).st_size
    seconds, memory = SECONDS + size / BYTES_PER_SECOND, MEMORY + MEMORY_PER_BYTE * size
    task = [[library, reader.__module__, reader.__name__], str(path), seconds, memory]
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-W", "ignore", "-m", __name__, json.dumps(task)],
            env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "OPENBLAS_NUM_THREADS": "1"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=seconds + WAITING,
        )
    except subprocess.TimeoutExpired as fault:
        raise too_slow(path, seconds + WAITING, advice) from fault
    if OUT_OF_TIME and done.returncode == -OUT_OF_TIME:
        raise too_slow(path, seconds, advice)
    broken = {FAULT: np.array(f"its reader broke down ({done.returncode})")}
    arrays = broken if done.returncode else unpacked(done.stdout)
    return sound(arrays, path, advice)


def sound(arrays: Arrays, path: Path, advice: str) -> Arrays:
    if FAULT in arrays:
        raise ForeignError(f"{path} cannot be read: {arrays[FAULT]}. {advice}")
    return arrays


def too_slow(path: Path, seconds: float, advice: str) -> ForeignError:
    return ForeignError(
        f"{path}: reading it took longer than {seconds:.0f} s: it is damaged, or larger than "
        f"its reader can take. {advice}"
    )


def packed(arrays: Arrays) -> bytes:
    content = BytesIO()
    np.savez(content, allow_pickle=False, **arrays)
    return content.getvalue()


def unpacked(content: bytes) -> Arrays:
    with np.load(BytesIO(content), allow_pickle=False) as arrays:
        return dict(arrays)


def serve(places: list[str], path: str, seconds: float, memory: int) -> None:
    """Read in this process, within its limits, and write the arrays to what was its stdout.

    `places` are the library, the module of the reader and its name there.
    """
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what the library prints must not come between
    limit(seconds + WAITING, memory)

    def reader(file: Path) -> Arrays:
        library, module, name = places
        import_module(library)
        found = getattr(import_module(module), name)
        limit_processor(seconds)
        return found(file)

    with output:
        output.write(tried(reader, Path(path), memory))


def tried(reader: Callable[[Path], Arrays], path: Path, memory: int) -> bytes:
    """What the reader gives, packed, or why it fails."""
    try:
        return packed(reader(path))
    except MemoryError:
        return packed({FAULT: np.array(f"it takes more than {memory / 1e9:.1f} GB of memory")})
    except Exception as fault:  # a library may raise anything over a file that is damaged
        words = plain(str(fault)) if is_ours(fault) else "it is damaged, or not what its name says"
        return packed({FAULT: np.array(words)})


def limit(seconds: float, memory: int) -> None:
    """End this process at a limit, with the one that started it, and at once by Ctrl-C."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    faulthandler.dump_traceback_later(seconds, exit=True)  # even out of a loop in C
    with suppress(ImportError):  # Windows; there and on macOS only time is limited
        import resource

        for kind, most in ((resource.RLIMIT_DATA, memory), (resource.RLIMIT_CORE, 0)):
            hard = resource.getrlimit(kind)[1]
            most = most if hard == resource.RLIM_INFINITY else min(most, hard)
            resource.setrlimit(kind, (most, most))
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(DIED_WITH_PARENT, signal.SIGKILL)


def limit_processor(seconds: float) -> None:
    """End this process once it has computed for so long; Windows knows only its clock."""
    if sys.platform != "win32":
        signal.signal(OUT_OF_TIME, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_PROF, seconds)


if __name__ == "__main__":
    serve(*json.loads(sys.argv[1]))
