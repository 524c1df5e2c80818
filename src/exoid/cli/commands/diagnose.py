"""exoid diagnose: where simulation and recording part, and which physics was left out."""

from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.commands.analysis import ask, diagnosed
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import Bounds, FlipOption, Seed, ZeroOption
from exoid.cli.inputs.own_terms import own_terms
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, as_told, take_all
from exoid.cli.inputs.terms import OwnTerms, rivals_in
from exoid.cli.outputs.destination import FIGURES, Json, Report, check_apart, check_destination
from exoid.cli.outputs.origin import inputs, origin_of
from exoid.cli.outputs.page import PAGES, planned, sources_of, write_report
from exoid.cli.outputs.results import described, end, introduce, keep
from exoid.cli.terminal.waiting import in_phases, patiently


def diagnose(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables or CAN logs of one leg, analysed together. Without one, the example."
        ),
    ] = None,
    prior: Prior = None,
    bounds: BoundsOption = Bounds.body,
    fix: Fix = None,
    bound: Bound = None,
    body_mass: BodyMass = None,
    height: Height = None,
    terms: OwnTerms = None,
    seed: Seed = 0,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    plot: Annotated[
        Path | None, typer.Option(help="Figure: where, which, before and after.", metavar="FILE")
    ] = None,
    json: Json = None,
    save: Annotated[
        Path | None,
        typer.Option(help="All of it (.nc), for exoid compare and exoid report.", metavar="FILE"),
    ] = None,
    report: Report = None,
) -> None:
    """Say where simulation and recording part, which physics was left out, and prove it.

    \b
    Examples:
      exoid diagnose drops.csv                       one recording
      exoid diagnose bare.blf loaded.blf             two recordings of one leg, together
      exoid diagnose drops.csv --plot why.pdf        with a figure
      exoid diagnose drops.csv --save why.nc         kept in a file, to show and compare later
      exoid diagnose drops.csv --terms my_terms.py   with terms of your own
    """
    paths = recordings or [EXAMPLE]
    check_destination(plot, FIGURES)
    check_destination(json)
    check_destination(save, ("nc",))
    check_destination(report, PAGES)
    check_apart([plot, json, save, report], paths)
    body = given_body(body_mass=body_mass, height=height)
    options = {"seed": seed, **assumed(prior, bounds, fix, bound)}
    own = own_terms(terms) if terms is not None else ()
    if not recordings:
        typer.echo("No recording given: this is the example that comes with exoid.")
    told = {"column": column, "flip": flip, "zero": zero}
    named, taken = take_all(paths, body, dbc=dbc, signal=signal, **told)
    found = in_phases(lambda told: diagnosed(named, own, options, told))
    introduce(named)
    show(found)
    rivals = rivals_in(found)
    if len(rivals) > 1:
        files, names = " ".join(map(str, paths)), ",".join(rivals)
        typer.echo(f"Which recording tells them apart: exoid plan {files} --between {names}\n")
    if plot is not None:
        patiently(lambda: draw(found, plot), "drawing")
        typer.echo(f"wrote {plot}", err=True)
    if json is not None:
        settings = {**options, "terms": terms, **as_told(flip, zero)}
        write(found, described(zip(paths, named, strict=True)), settings, json)
        typer.echo(f"wrote {json}", err=True)
    if save is None and report is None:
        end(found.follows)
        return
    asked = {**options, "terms": terms, **body, "signal": signal, "dbc": dbc and str(dbc)}
    asked |= {**as_told(flip, zero), "column": column}
    origin = origin_of(inputs(paths, dbc, Path(terms) if terms else None), asked)
    more = patiently(lambda: further(found, named[0][1].subject), "planning what to record next")
    if save is not None:
        files = zip(paths, named, strict=True)
        patiently(lambda: keep(found.fit, files, asked, save, origin=origin, **more), "saving")
        typer.echo(f"wrote {save}", err=True)
    if report is not None:
        sources = sources_of(taken, named)
        patiently(
            lambda: write_report(report, sources, found.fit, origin, **more), "writing the page"
        )
        typer.echo(f"wrote {report}", err=True)
    end(found.follows)


def show(found) -> None:
    """The answer, on stdout."""
    from contextlib import suppress

    from rich.console import Console

    from exoid.report.tables.diagnosis import print_diagnosis

    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        print_diagnosis(found, Console())


def draw(found, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.diagnosis import plot_diagnosis
    from exoid.report.plots.fit import save_figure

    save_figure(plot_diagnosis(found), path)


def write(found, recordings, settings: dict, path: Path) -> None:
    """The document for machines."""
    from importlib.metadata import version

    from exoid.report.document.diagnosis_json import diagnosis_document
    from exoid.report.document.plain_json import write_json

    document = diagnosis_document(
        found, version=version("exoid"), recordings=recordings, settings=settings
    )
    write_json(document, path)


def further(found, subject) -> dict:
    """The diagnosis, what the recording told, and what to record next."""
    return {"diagnosis": found, "told": ask(found.fit), "plan": planned(found.fit, subject)}
