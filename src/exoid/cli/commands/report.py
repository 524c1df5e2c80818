"""exoid report: everything about a recording on one page."""

from pathlib import Path
from typing import Annotated, Any

import typer

from exoid.cli.analysis import ask, compute, diagnosed
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import FlipOption, Seed, ZeroOption
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, as_told, take_all
from exoid.cli.inputs.terms import OwnTerms, own_terms
from exoid.cli.outputs.destination import PAGES, SAVED, Force, check_outputs
from exoid.cli.outputs.origin import inputs, origin_of
from exoid.cli.outputs.page import planned, sources_of, write_report
from exoid.cli.outputs.saved_page import retell
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import in_phases

STARTS = 64


def report(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables or CAN logs of one leg, analysed together, or one saved result (.nc, "
            ".json). Without one, the example."
        ),
    ] = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Page to write (.html).", metavar="FILE")
    ] = Path("report.html"),
    prior: Prior = None,
    bounds: BoundsOption = "body",
    fix: Fix = None,
    bound: Bound = None,
    body_mass: BodyMass = None,
    height: Height = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Number of starts.")] = STARTS,
    seed: Seed = 0,
    terms: OwnTerms = None,
    diagnosis: Annotated[
        bool, typer.Option("--diagnosis/--no-diagnosis", help="Look for missing physics.")
    ] = True,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    force: Force = False,
) -> None:
    """Fit and diagnose a leg, and write one page about it.

    To look at, print and pass on. The page holds its figures, and needs no network.

    \b
    Examples:
      exoid report                                   the example that comes with exoid
      exoid report drop.csv -o drop.html             one recording
      exoid report bare.blf loaded.blf -o leg.html   two recordings of one leg, together
      exoid report drop.csv --no-diagnosis           the fit alone, in seconds
      exoid report why.nc -o why.html                what --save kept, without computing it again
    """
    paths = recordings or [EXAMPLE]
    check_outputs((output, PAGES), force=force, inputs=paths)
    if terms is not None and not diagnosis:
        raise ValueError("--terms are causes for the diagnosis: leave out --no-diagnosis.")
    own = own_terms(terms)
    if any(path.suffix.lower().lstrip(".") in SAVED for path in paths):
        given = {
            "--prior": bool(prior),
            "--bounds": bounds != "body",
            "--fix": bool(fix),
            "--bound": bool(bound),
            "--body-mass": body_mass is not None,
            "--height": height is not None,
            "--multistart": multistart != STARTS,
            "--seed": seed != 0,
            "--no-diagnosis": not diagnosis,
            "--dbc": dbc is not None,
            "--signal": bool(signal),
            "--column": bool(column),
            "--flip": flip is not None,
            "--zero": zero is not None,
        }
        retell(paths, output, [option for option, asked in given.items() if asked], own)
        return
    body = given_body(body_mass=body_mass, height=height)
    by_hand = assumed(prior, bounds, fix, bound)
    if not recordings:
        say("No recording given: this is the example that comes with exoid.")
    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    named, taken = take_all(paths, body, **told)
    options = {"multistart": multistart, "seed": seed, **by_hand}
    tested = own if diagnosis else None
    result, found = in_phases(lambda told: analysed(named, options, tested, told))
    script = Path(terms) if terms is not None else None
    settings = {**options, "terms": terms, "diagnosis": diagnosis, **body, "signal": signal}
    settings |= {"dbc": dbc and str(dbc), **as_told(flip, zero), "column": column}
    origin = origin_of(inputs(paths, dbc, script), settings)
    sources = sources_of(taken, named)
    written = Outputs()
    written.put(
        output,
        lambda path: write_report(path, sources, result, origin, **found),
        "writing the page",
    )
    written.end((found.get("diagnosis") or result).follows)


def analysed(named, options: dict, own, told) -> tuple[Any, dict[str, Any]]:
    """The fit, and what else was found; `own` terms are None where no diagnosis is wanted."""
    if own is None:
        told(f"fitting {options['multistart']} starts")
        result = compute(named, False, options)
        told("asking what the recording told")
        return result, {"told": ask(result)}
    diagnosis = diagnosed(named, own, options, told)
    told("asking what the recording told")
    found = {"told": ask(diagnosis.fit), "diagnosis": diagnosis}
    told("planning what to record next")
    return diagnosis.fit, {**found, "plan": planned(diagnosis.fit, named[0][1].subject)}
