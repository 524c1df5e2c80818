"""exoid diagnose: where simulation and recording part, and which physics was left out."""

from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from exoid.cli.analysis import ask, diagnosed
from exoid.cli.inputs.again import again
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import FlipOption, Seed, ZeroOption
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, as_told, kinds_in, take_all
from exoid.cli.inputs.terms import OwnTerms, own_terms, rivals_in
from exoid.cli.outputs.destination import (
    FIGURES,
    PAGES,
    SAVED,
    Force,
    Json,
    Report,
    check_outputs,
)
from exoid.cli.outputs.origin import inputs, origin_of
from exoid.cli.outputs.page import planned, sources_of, write_report
from exoid.cli.outputs.results import introduce, keep, show, traced
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import in_phases


def diagnose(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables or CAN logs of one leg, analysed together. Without one, the example."
        ),
    ] = None,
    prior: Prior = None,
    bounds: BoundsOption = "body",
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
        typer.Option(
            help="All of it (.nc, .json), for exoid compare and exoid report.", metavar="FILE"
        ),
    ] = None,
    report: Report = None,
    force: Force = False,
) -> None:
    """Say which physics the model lacks, where it shows, and prove it.

    \b
    Examples:
      exoid diagnose drops.csv                       one recording
      exoid diagnose bare.blf loaded.blf             two recordings of one leg, together
      exoid diagnose drops.csv --plot why.pdf        with a figure
      exoid diagnose drops.csv --save why.nc         kept in a file, to show and compare later
      exoid diagnose drops.csv --terms my_terms.py   with terms of your own
    """
    paths = recordings or [EXAMPLE]
    wanted = (plot, FIGURES), (json, ()), (save, SAVED), (report, PAGES)
    check_outputs(*wanted, force=force, inputs=paths)
    body = given_body(body_mass=body_mass, height=height)
    options = {"seed": seed, **assumed(prior, bounds, fix, bound)}
    own = own_terms(terms)
    if not recordings:
        say("No recording given: this is the example that comes with exoid.")
    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    named, taken = take_all(paths, body, **told)
    from exoid.report.document.diagnosis_json import diagnosis_document
    from exoid.report.tables.mismatch.diagnosis import print_diagnosis

    found = in_phases(lambda told: diagnosed(named, own, options, told))
    introduce(named)
    show(lambda console: print_diagnosis(found, console))
    limits = None if bounds == "body" else bounds
    by_hand = {"prior": prior, "bounds": limits, "fix": fix, "bound": bound}
    say(*telling_apart(found, paths, named, again(**told, **body, **by_hand, terms=terms)))
    outputs, files = Outputs(), list(zip(paths, named, strict=True))
    settings = {**options, "terms": terms}
    outputs.put(plot, lambda path: draw(found, path), "drawing")
    outputs.put_document(
        json,
        lambda: diagnosis_document(found, **traced(files), settings=settings | as_told(flip, zero)),
    )
    if save is None and report is None:
        outputs.end(found.follows)
        return
    asked = {**settings, **body, "signal": signal, "dbc": dbc and str(dbc)}
    asked |= {**as_told(flip, zero), "column": column}
    origin = origin_of(inputs(paths, dbc, Path(terms) if terms else None), asked)
    subject = named[0][1].subject
    planning = f"planning what to record next, for {save or report}"
    more = outputs.attempt(lambda: further(found, subject), planning, {"diagnosis": found})
    outputs.put(
        save, lambda path: keep(found.fit, files, asked, path, origin=origin, **more), "saving"
    )
    outputs.put(
        report,
        lambda path: write_report(path, sources_of(taken, named), found.fit, origin, **more),
        "writing the page",
    )
    outputs.end(found.follows)


def telling_apart(found, paths: list[Path], named, more: str) -> list[str]:
    """The command that says which recording tells the suspects apart; nothing of a single one, or
    of a rig that a motor drives, of which no drop is planned.
    """
    rivals, driven = rivals_in(found), set(kinds_in(named)) == {"measured"}
    if len(rivals) < 2 or (driven and named[0][1].subject.kind == "rig"):
        return []
    recorded, names = " ".join(quote(str(path)) for path in paths), ",".join(rivals)
    return [f"Which recording tells them apart: exoid plan {recorded} --between {names}{more}", ""]


def draw(found, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.diagnosis import plot_diagnosis
    from exoid.report.plots.fit import save_figure

    save_figure(plot_diagnosis(found), path)


def further(found, subject) -> dict:
    """The diagnosis, what the recording told, and what to record next."""
    return {"diagnosis": found, "told": ask(found.fit), "plan": planned(found.fit, subject)}
