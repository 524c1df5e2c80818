"""Looks at a sound study, and at what was done to it."""

from pathlib import Path

from exoid.studies.dataset.check.check import Checked, check_dataset
from exoid.studies.dataset.open_dataset import open_dataset

NAMES = [f"P{p:02d}/{side}_{k}.csv" for p in (1, 2) for side in ("left", "right") for k in (1, 2)]
PEOPLE = "id,body_mass_kg,height_m,age_years\nP01,77,1.80,30\nP02,61,1.65,40\n"


def checked(folder: Path, most: int = 1000) -> Checked:
    return check_dataset(open_dataset(folder), most, lambda word: None)


def found(folder: Path, kind: str) -> list[tuple[str, str, str]]:
    """Level, place and words of all findings of a kind."""
    return [(e.level, e.where, e.says) for e in checked(folder).findings if e.kind == kind]


def only(folder: Path, kind: str) -> tuple[str, str, str]:
    """The one finding of a kind, where nothing else is an error."""
    (one,) = found(folder, kind)
    assert {each.kind for each in checked(folder).findings if each.level == "error"} <= {kind}
    return one
