"""One recording of a data set: where it lies, whose leg it is."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

Said = str | float | bool | None  # a field of the table of participants


def nothing() -> Mapping[str, Said]:
    return MappingProxyType({})


@dataclass(frozen=True)
class Participant:
    """A row of the table of participants. None means not told.

    `more` holds the other columns as they are: group, sex, diagnosis, dose.
    """

    id: str
    body_mass: float | None = None  # kg
    height: float | None = None  # m
    age: float | None = None  # years
    more: Mapping[str, Said] = field(default_factory=nothing)


@dataclass(frozen=True)
class Entry:
    """A recording as the layout of the folders tells it, before it is read.

    What the layout does not tell is empty; the recording's own sidecar may tell it. Letters of a
    name that cannot be shown are escaped, in all but `path`.
    """

    path: Path  # absolute
    name: str  # relative to the data set, with forward slashes
    participant: str = ""
    session: str = ""
    side: str = ""  # left or right
    task: str = ""
    run: str = ""
    defaults: tuple[Path, ...] = ()  # sidecars of all below their folders, the highest first


@dataclass(frozen=True)
class Dataset:
    """The recordings of a folder in the order of their names, and who the people are.

    `problems` are what is wrong with folders and table, one line each: what of them could not be
    read or is contradictory is not told. `aside` are texts that hold no table, by their names.
    """

    folder: Path
    entries: tuple[Entry, ...]
    participants: Mapping[str, Participant] = field(default_factory=lambda: MappingProxyType({}))
    table: Path | None = None  # where the participants stand
    bids: bool = False
    problems: tuple[str, ...] = ()
    aside: tuple[str, ...] = ()
