"""exoid drops: what clinicians read off a drop, the measures of the pendulum test."""

from contextlib import suppress
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.choices import FlipOption, ZeroOption
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, read
from exoid.cli.outputs.destination import FIGURES, Json, check_apart, check_destination
from exoid.cli.outputs.results import introduce
from exoid.cli.terminal.waiting import patiently


def drops(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables or CAN logs of one leg, averaged together. Without one, the example."
        ),
    ] = None,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    plot: Annotated[
        Path | None, typer.Option(help="Figure: every measure on its curve.", metavar="FILE")
    ] = None,
    json: Json = None,
) -> None:
    """Read the pendulum-test measures off every passive drop: no model, no fit, no diagnosis.

    Relaxation index, plateau angle, period, decrements, peak velocities and accelerations, each
    with its error, or with the reason why this recording does not allow it.

    \b
    Examples:
      exoid drops                                    the example that comes with exoid
      exoid drops drop.csv                           one recording
      exoid drops left.blf --plot left.pdf           with the measures marked on the curves
      exoid drops monday.csv friday.csv --json a.json
    """
    paths = recordings or [EXAMPLE]
    check_destination(plot, FIGURES)
    check_destination(json)
    check_apart([plot, json], paths)
    if not recordings:
        typer.echo("No recording given: this is the example that comes with exoid.")
    told = {"column": column, "flip": flip, "zero": zero}
    named = [(path.name, read(path, dbc, signal, False, **told)) for path in paths]
    test = patiently(lambda: measured(named), "reading the drops")
    introduce(named)
    show(test)
    if json is not None:
        write(test, zip(paths, named, strict=True), json)
        typer.echo(f"wrote {json}", err=True)
    if plot is not None and all(each.reason for each in test.drops):
        typer.echo(f"exoid: no segment could be read: {plot} was not drawn.", err=True)
    elif plot is not None:
        patiently(lambda: draw(test, plot), "drawing")
        typer.echo(f"wrote {plot}", err=True)


def measured(named):
    """The measures of every drop."""
    from exoid.pendulum.drops import measure_drops

    return measure_drops(named)


def show(test) -> None:
    """The tables, on stdout."""
    from rich.console import Console

    from exoid.report.tables.drops import print_drops

    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        print_drops(test, Console())


def draw(test, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.drops import plot_drops
    from exoid.report.plots.fit import save_figure

    save_figure(plot_drops(test), path)


def write(test, recordings, path: Path) -> None:
    """The document for machines."""
    from importlib.metadata import version

    from exoid.cli.outputs.results import described
    from exoid.report.document.drops_json import drops_document
    from exoid.report.document.plain_json import write_json

    document = drops_document(test, version=version("exoid"), recordings=described(recordings))
    write_json(document, path)
