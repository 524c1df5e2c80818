"""exoid fit: from recordings to the leg's parameters."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.analysis import ask, check_posterior, compute, profiled, write_posterior
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import Clip, FlipOption, Method, Misfit, Reading, Seed, ZeroOption
from exoid.cli.inputs.near import near
from exoid.cli.inputs.reading import EXAMPLE, Columns, Dbc, Signals, Strict, as_told, take_all
from exoid.cli.inputs.terms import (
    Model,
    OwnTerms,
    With,
    loaded,
    model_in,
    names_of,
    own_terms,
    terms_asked,
    undecided_in,
)
from exoid.cli.outputs.destination import (
    DRAWS,
    FIGURES,
    PAGES,
    SAVED,
    Force,
    Json,
    Report,
    check_outputs,
)
from exoid.cli.outputs.origin import inputs, origin_of, sha256_of
from exoid.cli.outputs.page import sources_of, write_report
from exoid.cli.outputs.results import introduce, keep, show, traced
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

HEAVIEST_PRIOR = 1e6  # it decides alone long before


def fit(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables (.csv .xlsx .mot .c3d ...) or CAN logs (.blf .asc ...) of one leg, fitted "
            "together. Without one, the example that comes with exoid."
        ),
    ] = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Number of starts.")] = 64,
    seed: Seed = 0,
    prior: Prior = None,
    weight: Annotated[
        float,
        typer.Option("--lambda", min=0.0, max=HEAVIEST_PRIOR, help="Weight of the prior, Eq. 11."),
    ] = 1.0,
    bounds: BoundsOption = "body",
    fix: Fix = None,
    bound: Bound = None,
    body_mass: BodyMass = None,
    height: Height = None,
    with_term: With = None,
    terms: OwnTerms = None,
    model: Model = None,
    each: Annotated[
        bool, typer.Option("--each", help="Fit every segment alone, then average the ratios.")
    ] = False,
    method: Annotated[
        Method, typer.Option(help="lm: all starts at once. slsqp: SciPy's, as a reference.")
    ] = "lm",
    smooth: Annotated[
        int,
        typer.Option(min=1, help="Samples of the moving average, Eq. 3, on data and simulation."),
    ] = 1,
    torque_frequency: Annotated[
        Reading | None, typer.Option(help="Reading of Eq. 4; without it both are tried.")
    ] = None,
    misfit: Annotated[
        Misfit, typer.Option(help="paper: Eq. 11 as printed, angle only, prior unscaled.")
    ] = "weighted",
    clip: Annotated[
        Clip,
        typer.Option(help="free: what moved freely. paper: the ends below 20 deg/s are cut off."),
    ] = "free",
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    strict: Strict = False,
    plot: Annotated[
        Path | None, typer.Option(help="Figure: measured, simulated, starts.", metavar="FILE")
    ] = None,
    json: Json = None,
    posterior: Annotated[
        Path | None,
        typer.Option(help="Draws of every quantity for ArviZ (.nc); a minute.", metavar="FILE"),
    ] = None,
    save: Annotated[
        Path | None,
        typer.Option(help="The fit (.nc, .json), for exoid compare and report.", metavar="FILE"),
    ] = None,
    report: Report = None,
    force: Force = False,
) -> None:
    """Find a leg's mass, inertia, damping, stiffness and torque.

    Its COM distance, too, and the error of each.

    \b
    Examples:
      exoid fit                                   the example that comes with exoid
      exoid fit drop.csv --multistart 64          one recording
      exoid fit bare.blf loaded.blf --plot a.pdf  two recordings of one leg, with a figure
      exoid fit drop.csv --save drop.nc           kept in a file, to compare with another
      exoid fit drop.csv --fix stiffness=0 --bound damping=0:20 --prior damping=3+-1
      exoid fit drops.csv --with coulomb_friction  with dry friction in the model
      exoid fit drops.csv --model why.nc          with what 'exoid diagnose --save why.nc' found
      exoid fit log.asc --dbc my.dbc --signal raw_angle=Knee.Angle --body-mass 77 --height 1.8
    """
    paths = recordings or [EXAMPLE]
    outputs = (plot, FIGURES), (json, ()), (posterior, DRAWS), (save, SAVED), (report, PAGES)
    check_outputs(*outputs, force=force, inputs=[*paths, *([model] if model else [])])
    if posterior is not None:
        check_posterior(each)
    body = given_body(body_mass=body_mass, height=height)
    by_hand = assumed(prior, bounds, fix, bound)
    own = own_terms(terms)
    saved = loaded(model, own) if model else None
    chosen = terms_asked(with_term, own, model_in(saved, model).terms if model else ())
    if not recordings:
        say("No recording given: this is the example that comes with exoid, a simulated leg.")
    reading = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    known = {"torque_frequency": torque_frequency} if torque_frequency else {}
    named, taken = take_all(paths, body, known, strict=strict, **reading)
    options = {
        "multistart": multistart,
        "seed": seed,
        **by_hand,
        "weight": weight,
        "method": method,
        "smooth": smooth,
        "misfit": misfit,
        "clip": clip,
    }
    options |= {"terms": chosen} if chosen else {}
    alone = saved is not None and not each and not with_term
    begun = near(saved, [*map(sha256_of, paths)], as_told(flip, zero)) if alone else {}
    result = patiently(
        lambda: compute(named, each, options | begun),
        f"fitting {multistart} starts; the first run of a new shape compiles for some seconds",
    )
    undecided = undecided_in(saved, model) if model else None
    if undecided:
        result = replace(result, notes=[undecided, *result.notes])
    files = Outputs()
    asking = "asking what the recording told"
    told = None if each else files.attempt(lambda: ask(result), asking, None)
    from exoid.report.document.fit_json import fit_document
    from exoid.report.tables.fit import print_fit

    introduce(named)
    show(lambda console: print_fit(result, console, told))
    settings = {"lambda": options.pop("weight"), **options, "each": each}
    settings |= {"terms": names_of(chosen)} if chosen else {}
    settings |= as_told(flip, zero)
    asked = {
        **settings,
        "torque_frequency": torque_frequency,
        **body,
        "signal": signal,
        "column": column,
        "dbc": dbc and str(dbc),
    }
    others = [Path(terms)] if terms and terms.endswith(".py") else []
    others += [model] if model else []
    origin = origin_of(inputs(paths, dbc, *others), asked) if save or report else None
    wanted = (plot is not None or json is not None) and not each and result.follows
    beside = "fitting anew beside every number for its profile, which --json and --plot show"
    profiles = files.attempt(lambda: profiled(result), beside, None) if wanted else None
    sources, more = list(zip(paths, named, strict=True)), {"told": told, "profiles": profiles}
    files.put(
        save, lambda path: keep(result, sources, asked, path, origin=origin, **more), "saving"
    )
    files.put(plot, lambda path: draw(result, profiles, path), "drawing")
    files.put_document(
        json, lambda: fit_document(result, **traced(sources), settings=settings, **more)
    )
    files.put(
        report,
        lambda path: write_report(path, sources_of(taken, named), result, origin, told=told),
        "writing the page",
    )
    files.put(posterior, lambda path: write_posterior(result, seed, path), "drawing from the fit")
    files.end(result.follows)


def draw(result, profiles, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.fit import plot_fit, save_figure

    save_figure(plot_fit(result, profiles), path)
