"""All files below a folder, by one walk that reads nothing but the folders."""

import os
from dataclasses import dataclass
from pathlib import Path

from exoid.files.system_errors import told

RESULTS = {"recordings.parquet", "quantities.parquet"}  # a folder with both is what a run has made

HIDDEN = (".", "~$")  # also what Office keeps beside a file that is open
SHOWN = 60  # letters at either end of a long name


@dataclass(frozen=True)
class Walked:
    """Files by their names below the folder, with forward slashes; and what could not be read."""

    names: tuple[str, ...]
    unread: tuple[str, ...]


def walk(folder: Path) -> Walked:
    """The files in the order of their names; hidden ones, and the results of a run, are left out.

    Each folder is entered once, so that links in a circle end.

    **Raises** `OSError` where `folder` itself cannot be read.
    """
    os.scandir(folder).close()
    names, unread, seen, waiting = [], [], set(), [""]
    while waiting:
        below = waiting.pop()
        try:
            for entry in entries_of(folder / below, seen, top=not below):
                if is_folder(entry):
                    waiting.append(f"{below}{entry.name}/")
                elif may_be_read(entry):
                    names.append(f"{below}{entry.name}")
        except OSError as fault:
            unread.append(f"{short(below)}: {told(fault)}")
    return Walked(tuple(sorted(names)), tuple(sorted(unread)))


def short(name: str) -> str:
    """The name of a folder in a line that can be read, however deep it lies."""
    return name if len(name) <= 2 * SHOWN else f"{name[:SHOWN]}...{name[-SHOWN:]}"


def entries_of(folder: Path, seen: set[tuple[int, int]], *, top: bool) -> list[os.DirEntry[str]]:
    """What is in a folder; nothing where it was seen already under another name. Who names a folder
    that holds results, too, wants what is beside them.
    """
    about = folder.stat()
    if (about.st_dev, about.st_ino) in seen:
        return []
    seen.add((about.st_dev, about.st_ino))
    with os.scandir(folder) as found:
        entries = [each for each in found if not each.name.startswith(HIDDEN)]
    if not {each.name for each in entries} >= RESULTS:
        return entries
    return [each for each in entries if each.name not in RESULTS] if top else []


def is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a link to itself
        return False


def may_be_read(entry: os.DirEntry[str]) -> bool:
    """A file, or a link that leads nowhere, of which its reader tells; no pipe and no device."""
    try:
        return entry.is_file() or (entry.is_symlink() and not Path(entry.path).exists())
    except OSError:
        return True
