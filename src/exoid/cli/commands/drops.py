"""exoid drops: what clinicians read off a drop, the measures of the pendulum test."""

from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.choices import FlipOption, ZeroOption
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, take_all
from exoid.cli.outputs.destination import FIGURES, Force, Json, check_outputs
from exoid.cli.outputs.results import introduce, show, traced
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
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
    force: Force = False,
) -> None:
    """Read the pendulum-test measures off every passive drop.

    No model, no fit, no diagnosis. Relaxation index, plateau angle, period, decrements, peak
    velocities and accelerations, each with its error, or with the reason why this recording does
    not allow it.

    \b
    Examples:
      exoid drops                                    the example that comes with exoid
      exoid drops drop.csv                           one recording
      exoid drops left.blf --plot left.pdf           with the measures marked on the curves
      exoid drops monday.csv friday.csv --json a.json
    """
    paths = recordings or [EXAMPLE]
    check_outputs((plot, FIGURES), (json, ()), force=force, inputs=paths)
    if not recordings:
        say("No recording given: this is the example that comes with exoid.")
    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    named, _ = take_all(paths, {}, **told)
    from exoid.pendulum.drops import measure_drops
    from exoid.report.document.drops_json import drops_document
    from exoid.report.tables.drops import print_drops

    test = patiently(lambda: measure_drops(named), "reading the drops")
    introduce(named)
    show(lambda console: print_drops(test, console))
    files = Outputs()
    recorded = list(zip(paths, named, strict=True))
    files.put_document(json, lambda: drops_document(test, **traced(recorded)))
    read = any(each.measured for each in test.drops)
    if plot is not None and not read:
        say(f"exoid: no segment could be read: {plot} was not drawn.", err=True)
    else:
        files.put(plot, lambda path: draw(test, path), "drawing")
    files.end(follows=read)


def draw(test, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.drops import plot_drops
    from exoid.report.plots.fit import save_figure

    save_figure(plot_drops(test), path)
