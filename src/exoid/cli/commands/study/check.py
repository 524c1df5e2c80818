"""exoid study check: a data set before it is run."""

from dataclasses import asdict
from typing import Annotated

import typer

from exoid.cli.commands.study.init import Folder
from exoid.cli.outputs.checked_study import lines
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import in_phases, patiently

READ = 1000  # recordings, in about ten seconds


def check(
    dataset: Folder,
    read: Annotated[
        int, typer.Option(min=0, help="How many recordings are read, spread over all.")
    ] = READ,
    json: Json = None,
    force: Force = False,
) -> None:
    """Say what a data set holds, what is missing, what contradicts.

    All names, sidecars and the table of participants are compared, and files that hold the same are
    found. Exit code 0: it can be run. 1: something listed under errors must be mended first.

    \b
    Examples:
      exoid study check study
      exoid study check archive --read 100000 --json found.json
    """
    check_outputs((json, ()), force=force)
    from exoid.studies.dataset.check.check import check_dataset
    from exoid.studies.dataset.open_dataset import open_dataset

    found = patiently(lambda: open_dataset(dataset), f"reading {dataset.name}")
    checked = in_phases(lambda told: check_dataset(found, read, told), "looking at recordings")
    say(*lines(str(dataset), checked))
    files = Outputs()
    files.put_document(json, lambda: {**asdict(checked), "folder": str(dataset)})
    files.end(follows=not checked.errors)
