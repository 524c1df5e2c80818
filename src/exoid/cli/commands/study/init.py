"""exoid study init: what a data set lacks, written to be filled in."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from exoid.cli.inputs.data_set import opened
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

if TYPE_CHECKING:
    from exoid.studies.dataset.writing.init import Begun

Folder = Annotated[Path, typer.Argument(help="The folder of a data set.", metavar="DATASET")]
SHOWN = 8  # ids or names in a line


def init(dataset: Folder) -> None:
    """Write the table of participants that a data set lacks.

    Who was recorded is told by names and sidecars; body mass, height, age and groups are for you to
    fill in. A Motion-BIDS data set also gets its description. Nothing that is there is replaced.

    \b
    Examples:
      exoid study init study
    """
    from exoid.studies.dataset.writing.init import begin_study

    found = opened(dataset)
    begun = patiently(lambda: begin_study(found), "asking the sidecars")
    tell(dataset, begun)


def tell(dataset: Path, begun: "Begun") -> None:
    """What was written, and what is left to be filled in."""
    from exoid.files.counted import counted
    from exoid.recordings.tables.sheet import listed

    for path in begun.written:
        say(f"wrote {path}")
    if begun.of_nobody:
        count = counted(len(begun.of_nobody), "recording")
        names = listed([*begun.of_nobody], SHOWN)
        say(f"{count} of nobody: put an id into the name or the sidecar: {names}")
    if begun.table in begun.written:
        say(
            f"Fill in {begun.table.name}: body mass and height give masses and torques; without "
            "them only ratios are told. Columns of your own (dose, diagnosis) are kept."
        )
    elif begun.absent:
        say(f"{begun.table} is kept as it is. It lacks rows for: {listed([*begun.absent], SHOWN)}")
    elif not begun.written:
        say(
            f"{dataset}: all files and rows are there. Which cells are empty, 'exoid study check "
            f"{dataset}' says."
        )
