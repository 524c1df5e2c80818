"""One mutant of a format: how it is made, and what is thought of how it was read."""

import random
import signal
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from mmap import mmap
from pathlib import Path

from exoid.cli.terminal.faults import foreign
from exoid.files.visible import visible

from .draw import Strategy, drawn
from .mutate import mutated
from .reading import Format, Reading, Unread, alike, same

# The modules that hold each kind of formats, and their names.
HOMES = {
    "logs": ("can blf", "can asc", "can log", "can trc", "can csv", "can mf4"),
    "tables": ("own csv", "other csv"),
    "opensim": ("opensim",),
    "archives": ("npz", "mat", "c3d", "xlsx", "parquet"),
    "beside": ("dbc", "sidecar"),
    "saved": ("saved nc", "saved json"),
}
NAMES = tuple(name for names in HOMES.values() for name in names)
MAKERS = {home: home for home in HOMES} | {"saved": "beside"}
OVER = ("took longer than", "broke down", "of memory")  # where a library was ended
INSIDE = 0.3  # the share of mutants that are damaged below their checksum
DRAWN = 0.3  # and of those that hypothesis draws, where it knows the fields

REFUSED, TOLD, SAME, PLAIN, ALONE, ENDED = "refused", "told", "same", "plain", "alone", "ended"
WRONG, FAULT, HANG = "WRONG", "FAULT", "HANG"
CLASSES = (REFUSED, TOLD, SAME, PLAIN, ALONE, ENDED, WRONG, FAULT, HANG)
FAILED = (WRONG, FAULT, HANG)


PATIENCE = 1.0  # s that an oracle has, which may loop where exoid does not
ASKED = mmap(-1, 1)  # 1 while an oracle reads: with whom a process shares it sees what ended it


@contextmanager
def asked() -> Iterator[None]:
    """While another reader is asked, which may break down in its own way."""
    ASKED[0] = 1
    try:
        with within(PATIENCE):
            yield
    finally:
        ASKED[0] = 0


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """**Raises** `TimeoutError` where what is done takes longer, unless it does so in C."""

    def ring(*_) -> None:
        raise TimeoutError

    signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


@dataclass(frozen=True)
class Verdict:
    """Its class, and what was seen."""

    kind: str
    why: str = ""


@cache
def format_of(name: str) -> Format:
    """A format with its sound files, which take a second to make."""
    home = next(home for home, names in HOMES.items() if name in names)
    return getattr(import_module(f"{__package__}.{MAKERS[home]}"), makers(home))()[name]


def makers(home: str) -> str:
    """What makes the formats of a kind is called."""
    return {"logs": "log", "tables": "table", "archives": "archive"}.get(home, home) + "_formats"


def mutant(name: str, seed: int, number: int) -> tuple[bytes, int]:
    """The content of a mutant, and which of the sound files it was."""
    draw = random.Random(f"{name}/{seed}/{number}")
    made = format_of(name)
    which = draw.randrange(len(made.samples))
    content, others = made.samples[which].content, [each.content for each in made.samples]
    if made.drawn is not None and draw.random() < DRAWN:
        found = drawn(strategy_of(name, which), draw)
        if found is not None:
            return found, which
    if made.inside is not None and draw.random() < INSIDE:
        return made.inside(draw, content, others), which
    return mutated(draw, content, others), which


@cache
def strategy_of(name: str, which: int) -> Strategy:
    """What hypothesis makes of one of the sound files."""
    made = format_of(name)
    assert made.drawn is not None
    return made.drawn(made.samples[which])


@cache
def original(name: str, which: int, folder: Path) -> Reading:
    """What is read of the sound file."""
    path = folder / f"sound{format_of(name).suffix}"
    path.write_bytes(format_of(name).samples[which].content)
    return format_of(name).read(path)


def judged(name: str, seed: int, number: int, folder: Path) -> Verdict:
    """Read a mutant, and say what is thought of it."""
    return verdict(name, *mutant(name, seed, number), folder)


def verdict(name: str, content: bytes, which: int, folder: Path) -> Verdict:
    """What is thought of how a file is read that was made of one of the sound ones."""
    made = format_of(name)
    sound_one = original(name, which, folder)
    path = folder / f"mutant{made.suffix}"
    path.write_bytes(content)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = made.read(path)
        except MemoryError:
            return Verdict(HANG, "it takes all memory")
        except Exception as fault:
            return Verdict(*refusal(fault))
    if found.report != sound_one.report:
        return Verdict(TOLD, "; ".join(found.report))
    if same(found.rows, sound_one.rows):
        return Verdict(SAME)
    return Verdict(*compared(made, path, which, found))


def refusal(fault: Exception) -> tuple[str, str]:
    """One line of our own, or a fault of ours."""
    said = str(fault)
    if (
        isinstance(fault, ValueError | OSError)
        and not foreign(fault)
        and visible(said) == said
        and said
    ):
        return (ENDED if any(word in said for word in OVER) else REFUSED), said
    return FAULT, "".join(traceback.format_exception(fault))


def compared(made: Format, path: Path, which: int, found: Reading) -> tuple[str, str]:
    """Other rows, of which nothing was said: by the oracle, else by what a checksum promises."""
    if made.checked:
        return WRONG, "other rows, below a checksum"
    if made.oracle is None:
        return PLAIN, ""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            with asked():
                expected = made.oracle(path, made.samples[which])
        except (Unread, TimeoutError, MemoryError) as fault:
            return ALONE, repr(fault)
        except Exception as fault:  # of any library
            return ALONE if made.stricter else WRONG, f"the oracle refuses it: {fault!r}"
    if alike(found.rows, expected):
        return PLAIN, ""
    return WRONG, f"rows {found.rows}, the oracle {expected}"
