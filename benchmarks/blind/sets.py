"""Sets of blind cases: those beside the repository, and our own."""

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import jax

from exoid.recording.load import load
from exoid.recording.recording import Recording

from .cases import draw_case, name_of_case
from .deck import deal

SHARED = Path(__file__).parents[3] / "shared" / "data"
FOLDERS = (SHARED / "concealed", SHARED / "real")
TRUTH = "truth.json"
OWN = "own"
KEPT = 8  # own cases, whose programs are kept at once

# What careful searches made of the real recordings, whose truth nobody knows.
SUPPOSED = {
    "knee-drop": "(cannot tell, or weakly dry friction)",
    "motor-ringing": "(dry friction)",
    "motor-swing": "(dry friction)",
    "servo-drop": "(dry friction, and something that hardens)",
}


@dataclass(frozen=True)
class Blind:
    """A case to be diagnosed; its truth is None where nobody knows it."""

    name: str
    load: Callable[[], Recording]
    truth: Mapping[str, Any] | None
    of: str  # the set

    @property
    def concealed(self) -> str:
        """What is in it, for a table."""
        return self.truth["effect"] if self.truth else SUPPOSED.get(self.name, "(unknown)")


def stored(folder: Path) -> list[Blind]:
    """The recordings of a folder; its truth file, where there is one, says which are cases."""
    listed = folder / TRUTH
    if listed.exists():
        truths = {truth["id"]: truth for truth in json.loads(listed.read_text(encoding="utf-8"))}
    else:
        truths = dict.fromkeys(path.stem for path in sorted(folder.glob("*.csv")))
    return [
        Blind(name, partial(recording, folder / f"{name}.csv"), truth, folder.name)
        for name, truth in truths.items()
    ]


def recording(path: Path) -> Recording:
    return load(path).recording


def own(count: int, seed: int) -> Iterator[Blind]:
    """Our own cases, each the same however many follow.

    Make them all before anything else is compiled: what they compiled is thrown away with the rest.
    """
    for number, card in enumerate(deal(count, seed)):
        name = name_of_case(seed, number)
        try:
            case = draw_case(card, seed, number)
            yield Blind(name, partial(as_it_is, case.recording), case.truth, OWN)
        except ArithmeticError as fault:  # the other cases must run
            yield Blind(name, partial(refuse, fault), None, OWN)
        if number % KEPT == KEPT - 1:
            jax.clear_caches()  # a program for every set of terms would fill the memory


def as_it_is(recording: Recording) -> Recording:
    return recording


def refuse(fault: Exception) -> Recording:
    raise fault
