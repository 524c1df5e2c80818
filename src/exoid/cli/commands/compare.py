"""exoid compare: two saved results side by side."""

from contextlib import suppress
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.own_terms import own_terms
from exoid.cli.inputs.terms import OwnTerms
from exoid.cli.outputs.destination import Json, check_apart, check_destination
from exoid.cli.terminal.waiting import patiently


def compare(
    first: Annotated[
        Path, typer.Argument(help="What --save of 'exoid fit' or 'exoid diagnose' wrote (.nc).")
    ],
    second: Annotated[Path, typer.Argument(help="Another one.")],
    terms: OwnTerms = None,
    json: Json = None,
) -> None:
    """Show two saved results side by side: two days, two sides, or two settings.

    Diagnoses are compared where they were saved.

    \b
    Examples:
      exoid fit left.csv --save left.nc
      exoid fit right.csv --save right.nc
      exoid compare left.nc right.nc
      exoid diagnose right.csv --save why.nc
      exoid compare left.nc why.nc
    """
    check_destination(json)
    check_apart([json], [first, second])
    own = own_terms(terms) if terms is not None else ()
    sides = [
        patiently(lambda path=path: loaded(path, own), f"reading {path}")
        for path in (first, second)
    ]
    from rich.console import Console

    from exoid.report.tables.compare import compare as compared
    from exoid.report.tables.comparison import comparison_document, print_comparison

    found = compared(*sides)
    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        print_comparison(found, sides, Console())
    if json is not None:
        from exoid.report.document.plain_json import write_json

        write_json(comparison_document(found, sides), json)
        typer.echo(f"wrote {json}", err=True)


def loaded(path: Path, own):
    """A result as it was saved, with a user's own terms."""
    from exoid.report.saved.saved_result import load_result

    return load_result(path, terms=own)
