"""The data set that a command is given."""

from pathlib import Path
from typing import TYPE_CHECKING

from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

if TYPE_CHECKING:
    from exoid.studies.dataset.entry import Dataset

SHOWN = 5  # names in a line


def opened(folder: Path) -> "Dataset":
    """The data set in a folder; what is wrong with it, and which files are left aside, is said."""
    from exoid.recordings.tables.sheet import listed
    from exoid.studies.dataset.open_dataset import open_dataset

    found = patiently(lambda: open_dataset(folder), f"reading {folder.name}")
    for each in found.problems:
        say(f"exoid: {each}", err=True)
    if found.aside:
        names = listed([*found.aside], SHOWN)
        say(f"exoid: left aside, as texts without a table of numbers: {names}", err=True)
    return found
