"""Mutants of every format by turns, in processes that are watched, and the table of what came."""

import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from .judge import CLASSES, FAILED, FAULT, HANG
from .worker import LETTERS

TURN = 20.0  # s of one format, beside which the start of its process is short
STANDING = 40.0  # s in which a mutant must be read, on a machine that has other things to do
STARTING = 60.0  # s until the first
LONGEST = 150.0  # s of one mutant as a command reads it: above the limits of other libraries


@dataclass
class Tally:
    """What came of one format."""

    next: int = 0
    seconds: float = 0.0
    counts: Counter = field(default_factory=Counter)
    failures: list[tuple[int, str]] = field(default_factory=list)

    def add(self, kind: str) -> None:
        self.counts[kind] += 1
        if kind in FAILED:
            self.failures.append((self.next, kind))
        self.next += 1


@dataclass(frozen=True)
class Plan:
    """What is damaged, how, and for how long."""

    names: tuple[str, ...]
    seed: int = 0
    seconds: float = 60.0
    most: int = 10**12  # mutants of each format


def fuzz(plan: Plan, told=lambda tallies: None) -> dict[str, Tally]:
    """Every format in turns until the time is over, or all mutants are read; `told` hears how far
    it is after each turn.
    """
    tallies = {name: Tally() for name in plan.names}
    end = time.monotonic() + plan.seconds
    turn = min(TURN, plan.seconds / len(plan.names))
    while any(each.next < plan.most for each in tallies.values()):
        for name in plan.names:
            left = end - time.monotonic()
            if left <= 0:
                return tallies
            take_turn(name, plan, min(turn, left), tallies[name])
            told(tallies)
    return tallies


def take_turn(name: str, plan: Plan, seconds: float, tally: Tally) -> None:
    """Mutants for so long; one that its process does not survive is read once more as it should."""
    with TemporaryDirectory() as folder:
        letters = Path(folder) / "letters"
        letters.touch()
        begin = time.monotonic()
        task = json.dumps([name, plan.seed, tally.next, [seconds, plan.most], str(letters)])
        call = [sys.executable, "-m", f"{__package__}.worker", task]
        process = subprocess.Popen(call, start_new_session=True)
        done = watched(process, letters)
        tally.seconds += time.monotonic() - begin
        for letter in letters.read_text():
            tally.add(CLASSES[LETTERS.index(letter)])
        if not done:
            tally.add(read_apart(name, plan.seed, tally.next))


def watched(process: subprocess.Popen, letters: Path) -> bool:
    """Did it end by itself? It is ended where it stands still."""
    size, moved, allowed = 0, time.monotonic(), STARTING
    while process.poll() is None:
        time.sleep(0.2)
        now = letters.stat().st_size
        if now != size:
            size, moved, allowed = now, time.monotonic(), STANDING
        elif time.monotonic() - moved > allowed:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            return False
    return process.returncode == 0


def read_apart(name: str, seed: int, number: int) -> str:
    """The class of a mutant as a command reads it, where limits hold."""
    recipe = f"{name}:{seed}:{number}"
    call = [sys.executable, "-m", __package__ or "", "--replay", recipe, "--apart"]
    try:
        done = subprocess.run(call, timeout=LONGEST, capture_output=True, text=True, check=False)
    except subprocess.TimeoutExpired:
        return HANG
    kind = done.stdout.split("\n")[0].strip()
    return kind if kind in CLASSES else FAULT


def table(tallies: dict[str, Tally]) -> str:
    """Mutants, classes and pace of every format, and of all."""
    total = Tally(
        sum(each.next for each in tallies.values()),
        sum(each.seconds for each in tallies.values()),
        sum((each.counts for each in tallies.values()), Counter()),
    )
    heads = ["format", "mutants", *CLASSES, "per s"]
    rows = [
        [
            name,
            each.next,
            *(each.counts[kind] for kind in CLASSES),
            round(each.next / max(each.seconds, 1e-9)),
        ]
        for name, each in {**tallies, "all": total}.items()
    ]
    lines = [f"{row[0]:<11}" + "".join(f"{cell:>9}" for cell in row[1:]) for row in [heads, *rows]]
    return "\n".join(lines)
