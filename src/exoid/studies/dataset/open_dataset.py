"""A folder of recordings as a data set: told by names and one small table, no recording read."""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from pathlib import Path, PurePosixPath

from exoid.files.system_errors import told
from exoid.files.visible import visible
from exoid.recordings.can.logs.log_files import FORMATS
from exoid.recordings.defaults import DEFAULTS
from exoid.recordings.formats.sheets import READERS
from exoid.studies.dataset.entry import Dataset, Entry
from exoid.studies.dataset.layout import entry_of
from exoid.studies.dataset.motion_bids.labels import SUFFIX
from exoid.studies.dataset.participants import ENDINGS, Table, read_participants
from exoid.studies.dataset.prose import is_prose
from exoid.studies.dataset.walk import walk

READABLE = {*FORMATS, *READERS}
PARTICIPANTS = "participants"
ABOUT = {"readme", "changes", "license", "licence", "citation", PARTICIPANTS}  # beside recordings
DESCRIPTION = "dataset_description.json"


def open_dataset(folder: str | Path) -> Dataset:
    """The recordings below a folder, and who the people are.

    Motion-BIDS where it holds `dataset_description.json` or `sub-*_motion.tsv`, else any files
    that `load` reads, in any folders, whose names say whose they are (`layout.py`). A table
    `participants.csv`, `.tsv`, `.parquet` or `.xlsx` tells of the people. No recording is opened,
    but for the first lines of a `.txt`, which may be a note: 10^5 take about as long as listing
    their folders.

    **Raises** `ValueError` (one line) where there is no folder, no recording in it, or a table of
    participants that cannot be read. Lesser faults are the `problems` of what is returned.
    """
    folder = Path(folder)
    if not folder.is_dir():
        what = "this is a file" if folder.exists() else "there is no such folder"
        raise ValueError(f"{folder}: {what}. Name the folder of a data set.")
    try:
        found = walk(folder.absolute())
    except OSError as fault:
        raise ValueError(f"{folder}: {told(fault)}") from fault
    bids = DESCRIPTION in found.names or any(map(is_motion, found.names))
    names = [name for name in found.names if (is_motion(name) if bids else is_recording(name))]
    aside = {name: visible(name) for name in names if is_prose(folder / name)}
    names = [name for name in names if name not in aside]
    if not names:
        raise ValueError(none_found(folder, bids, found.unread))
    table = the_table(folder, found.names)
    people = Table() if table is None else read_participants(table)
    ids = frozenset(people.participants)
    entries = tuple(entry_of(folder.absolute(), name, ids) for name in names)
    problems = (*map(visible, found.unread), *people.problems)
    if not bids:
        entries = with_defaults(folder.absolute(), entries, found.names)
    about = (people.participants, table, bids, problems, tuple(aside.values()))
    return Dataset(folder.absolute(), entries, *about)


def with_defaults(
    folder: Path, entries: tuple[Entry, ...], names: Iterable[str]
) -> tuple[Entry, ...]:
    """The entries with the `defaults.toml` of their folders; BIDS has a way of its own."""
    there = {path.parent for each in names if (path := PurePosixPath(each)).name == DEFAULTS}
    if not there:
        return entries

    @cache
    def above(place: Path) -> tuple[Path, ...]:
        inside = PurePosixPath(place.relative_to(folder).as_posix())
        ways = [*reversed(inside.parents), inside]
        return tuple(folder / each / DEFAULTS for each in ways if each in there)

    return tuple(replace(each, defaults=above(each.path.parent)) for each in entries)


def is_motion(name: str) -> bool:
    """Is this a recording of Motion-BIDS, and not derived from one?"""
    return name.startswith("sub-") and name.endswith(SUFFIX)


def is_recording(name: str) -> bool:
    """May this be a recording, by its ending?"""
    stem, dot, ending = name.rpartition("/")[2].lower().rpartition(".")
    return f"{dot}{ending}" in READABLE and stem not in ABOUT


def none_found(folder: Path, bids: bool, unread: tuple[str, ...]) -> str:
    if unread:
        return f"{folder}: no recording was found, and {len(unread)} folders not read. {unread[0]}"
    kinds = f"a table or a CAN log ({' '.join(sorted(READABLE))})"
    wanted = f"sub-*{SUFFIX}, as Motion-BIDS has it" if bids else kinds
    return f"{folder}: no recording was found in it. One is {wanted}."


def the_table(folder: Path, names: tuple[str, ...]) -> Path | None:
    """The table of participants at the top of the folder; of several none is taken."""
    found = [name for name in names if name.lower() in {f"{PARTICIPANTS}{e}" for e in ENDINGS}]
    if len(found) > 1:
        raise ValueError(f"{folder}: {' and '.join(found)} are two tables. Keep one.")
    return folder / found[0] if found else None
