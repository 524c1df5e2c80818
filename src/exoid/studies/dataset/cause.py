"""Why recordings of a study cannot be read or measured: what many of them have in common."""

import re

from exoid.studies.dataset.motion_bids.labels import SUFFIX
from exoid.studies.dataset.open_dataset import DEFAULTS

NUMBER = re.compile(r"[-+]?\d+(?:[.,]\d+)*(?:e[-+]?\d+)?")
COLUMN = re.compile(r'\bsay columns=\{"(\w+)": NAME\}')
KEYS = re.compile(r'(\bsay )?((?:flip|zero)="[a-z]+"(?: and zero="[a-z]+")?)')


def cause(said: str) -> str:
    """A reason without its numbers: alike for all that have one cause."""
    return NUMBER.sub("#", said)


def for_all(said: str, name: str) -> str:
    """A reason whose keywords of one recording are said as keys for a whole data set."""
    said = COLUMN.sub(rf'write \1 = "NAME" in [columns] of {DEFAULTS}', said)
    own, all_of = "[sensors] of its sidecar", DEFAULTS
    if name.endswith(SUFFIX):
        own, all_of = "sensors of exoid in its _motion.json", "task-NAME_motion.json"
    where = f"{own}, or, where all are like this, of {all_of} at the top of the data set"

    def told(found: re.Match[str]) -> str:
        return f"write {keys(found[2])} in {where}" if found[1] else keys(found[2])

    return KEYS.sub(told, said)


def keys(keywords: str) -> str:
    """`flip="angle" and zero="hanging"` as a sidecar has it."""
    return keywords.replace("=", " = ")
