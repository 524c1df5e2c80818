"""One process that reads mutants of one format, and writes a letter of what it thinks of each."""

import json
import os
import resource
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

from .judge import CLASSES, ENDED, Verdict, in_this_process, judged

LETTERS = "rtspeWFH"  # of the classes, in their order
MEMORY = 3 << 30  # bytes
QUICK = "/dev/shm" if Path("/dev/shm").is_dir() else None  # a folder in memory


def work(name: str, seed: int, begin: int, seconds: float, letters: str) -> None:
    """Until the time is over; the length of the file of letters says how far it is."""
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)  # libraries in C write there
    with (
        TemporaryDirectory(dir=QUICK) as folder,
        in_this_process(),
        Path(letters).open("ab", buffering=0) as file,
    ):
        end, number = time.monotonic() + seconds, begin
        while time.monotonic() < end:
            kind = judged(name, seed, number, Path(folder)).kind
            file.write(LETTERS[CLASSES.index(kind)].encode())
            number += 1
    os._exit(0)  # a library may fail once more as it is freed


def alone(name: str, seed: int, number: int, *, apart: bool) -> Verdict:
    """One mutant; `apart` as a command reads it, other libraries in processes of their own."""
    with TemporaryDirectory(dir=QUICK) as folder:
        if not apart:
            with in_this_process():
                return judged(name, seed, number, Path(folder))
        found = judged(name, seed, number, Path(folder))
        over = "took longer than" in found.why or "broke down" in found.why
        return Verdict(ENDED, found.why) if over else found


if __name__ == "__main__":
    work(*json.loads(sys.argv[1]))
