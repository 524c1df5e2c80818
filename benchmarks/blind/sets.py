"""Sets of blind cases: those beside the repository, and our own."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from exoid.recordings.loading.load import load
from exoid.recordings.recording import Recording

from .cases import draw_case, name_of_case
from .deck import Card

SHARED = Path(__file__).parents[3] / "shared" / "data"
FOLDERS = (SHARED / "concealed", SHARED / "real")
TRUTH = "truth.json"
OWN = "own"

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


def own(card: Card, seed: int, number: int) -> Blind:
    """A case of our own; one that cannot be drawn refuses to load."""
    name = name_of_case(seed, number)
    try:
        case = draw_case(card, seed, number)
    except ArithmeticError as fault:
        return Blind(name, partial(refuse, str(fault)), None, OWN)
    return Blind(name, partial(as_it_is, case.recording), case.truth, OWN)


def as_it_is(recording: Recording) -> Recording:
    return recording


def refuse(fault: str) -> Recording:
    raise ArithmeticError(fault)
