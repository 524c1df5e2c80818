"""exoid compare: two saved results side by side."""

from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.terms import OwnTerms, loaded, own_terms
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.results import show
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.waiting import patiently


def compare(
    first: Annotated[
        Path, typer.Argument(help="What 'exoid fit' or 'exoid diagnose' saved (.nc, .json).")
    ],
    second: Annotated[Path, typer.Argument(help="Another one.")],
    terms: OwnTerms = None,
    json: Json = None,
    force: Force = False,
) -> None:
    """Show two saved results side by side.

    Two days, two sides, or two settings. Diagnoses are compared where they were saved.

    \b
    Examples:
      exoid fit left.csv --save left.nc
      exoid fit right.csv --save right.nc
      exoid compare left.nc right.nc
      exoid diagnose right.csv --save why.nc
      exoid compare left.nc why.nc
    """
    check_outputs((json, ()), force=force, inputs=[first, second])
    own = own_terms(terms)
    sides = [
        patiently(lambda path=path: loaded(path, own), f"reading {path}")
        for path in (first, second)
    ]
    from exoid.report.tables.compare import compare as compared
    from exoid.report.tables.comparison import comparison_document, print_comparison

    found = compared(*sides)
    show(lambda console: print_comparison(found, sides, console))
    files = Outputs()
    files.put_document(json, lambda: comparison_document(found, sides))
    files.end()
