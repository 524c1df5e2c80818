"""File names of BIDS: entities with labels of letters and digits, in their order."""

import re
from itertools import combinations
from pathlib import Path

NOT_IN_A_LABEL = re.compile(r"[^0-9a-zA-Z+]")
ENTITIES = ("sub", "ses", "task", "tracksys", "acq", "run")
SUFFIX = "_motion.tsv"


def label(text: str) -> str:
    """A text as a label: what is neither letter nor digit is left out."""
    return NOT_IN_A_LABEL.sub("", text)


def motion_file(labels: dict[str, str]) -> str:
    """The name of a motion file below the data set; an entity without a label is left out."""
    told = {entity: labels[entity] for entity in ENTITIES if labels.get(entity)}
    folders = [f"{entity}-{told[entity]}" for entity in ("sub", "ses") if entity in told]
    name = "_".join(f"{entity}-{each}" for entity, each in told.items())
    return "/".join([*folders, "motion", f"{name}{SUFFIX}"])


def beside(motion: Path, ending: str) -> Path:
    """What belongs to a motion file: `_channels.tsv`, `_events.tsv`, `_motion.json`."""
    return motion.with_name(motion.name.removesuffix(SUFFIX) + ending)


def inherited(motion: Path, ending: str) -> list[Path]:
    """The files of that ending that hold for a motion file, the most general first.

    BIDS lets what holds for many stand above them: those in its folder, and in the folders up to
    the data set's, whose entities are among its own.
    """
    words = motion.name.removesuffix(SUFFIX).split("_")
    folders = [motion.parent]
    while not folders[0].name.startswith("sub-") and folders[0] != folders[0].parent:
        folders.insert(0, folders[0].parent)
    found = []
    for folder in (folders[0].parent, *folders):
        fixed = [word for word in words if word in folder.parts]
        free = [word for word in words if word not in fixed and not word.startswith("sub-")]
        subsets = (each for n in range(len(free) + 1) for each in combinations(free, n))
        names = ("_".join([*fixed, *chosen]) + ending for chosen in subsets)
        found += [path for name in names if (path := folder / name.removeprefix("_")).is_file()]
    return found
