"""exoid plan: what to record next."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.analysis import compute, prepare
from exoid.cli.inputs.again import again
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import FlipOption, Seed, ZeroOption
from exoid.cli.inputs.reading import Columns, Dbc, Signals, kinds_in, take_all
from exoid.cli.inputs.terms import (
    Between,
    Model,
    OwnTerms,
    With,
    own_terms,
    rivals_asked,
    saved_model,
    suspected_in,
    terms_asked,
)
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.results import introduce, show
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.waiting import patiently

INERTIA = "inertia"
GOALS = (
    INERTIA,
    "damping",
    "stiffness",
    "mass",
    "com_distance",
    "gravity_over_inertia",
    "stiffness_over_inertia",
    "damping_over_inertia",
)


def plan(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="What was recorded of this leg so far; nothing plans the first session."
        ),
    ] = None,
    goal: Annotated[
        str | None,
        typer.Option(
            help="What to narrow: inertia, damping, stiffness (or J, d, c), gravity_over_inertia, "
            "damping_over_inertia, stiffness_over_inertia, or a term's as coulomb_friction.level; "
            f"{INERTIA} by default.",
            metavar="QUANTITY",
            show_default=False,
        ),
    ] = None,
    between: Between = None,
    with_term: With = None,
    terms: OwnTerms = None,
    model: Model = None,
    prior: Prior = None,
    bounds: BoundsOption = "body",
    fix: Fix = None,
    bound: Bound = None,
    body_mass: BodyMass = None,
    height: Height = None,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Starts of the fit.")] = 64,
    seed: Seed = 0,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    json: Json = None,
    force: Force = False,
) -> None:
    """Say what to record next, and how much it would tell.

    What narrows a quantity most, or tells rival causes apart.

    \b
    Examples:
      exoid plan --body-mass 77 --height 1.80     the first session of a person
      exoid plan drop.csv                         what to add for the inertia
      exoid plan drop.csv --goal damping          for the damping
      exoid plan drop.csv --with coulomb_friction --goal coulomb_friction.level
      exoid plan drop.csv --model why.nc          after 'exoid diagnose drop.csv --save why.nc'
      exoid plan drop.csv --between coulomb_friction,hysteresis    to tell which of them acts
    """
    goal = goal and by_name(goal)
    read = [*(recordings or []), *([model] if model else [])]
    check_outputs((json, ()), force=force, inputs=read)
    own = own_terms(terms)
    rivals, chosen = asked(between, goal, with_term, own, model)
    if (rivals or chosen) and not recordings:
        raise ValueError("terms need a recording: a first session is planned for Eq. 9 alone.")
    body = given_body(body_mass=body_mass, height=height)
    from exoid.recordings.declared.subject import Subject

    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    named, _ = take_all(recordings or [], body, **told)
    subject = named[0][1].subject if named else replace(Subject(kind="leg"), **body)
    options = {"multistart": multistart, "seed": seed, **assumed(prior, bounds, fix, bound)}
    check_planned(named, subject, rivals)
    if rivals:
        tell_apart(named, subject, rivals, options, json)
        return
    result, found = patiently(
        lambda: planned(
            named, subject, goal or INERTIA, options | ({"terms": chosen} if chosen else {})
        ),
        "planning; the first run of a new shape compiles for some seconds",
    )
    introduce(named)
    from exoid.report.tables.plan import plan_document, print_plan

    same = again(terms=terms, **{"with": with_term}, model=model)
    show(lambda console: print_plan(found, console, same, first=result is None))
    files = Outputs()
    files.put_document(json, lambda: plan_document(found, result, subject))
    files.end(result is None or result.follows)


def asked(
    between: str | None, goal: str | None, given: list[str] | None, own: tuple, model: Path | None
) -> tuple[tuple, tuple]:
    """The rival terms between which to tell, or the terms of the model that is planned for.

    After a diagnosis that could not tell, the rivals are those that it suspects.

    **Raises** `ValueError` where both are asked for, or the goal is none of that model.
    """
    if between is not None:
        if goal or given or model:
            raise ValueError("--between tells causes apart: leave --goal, --with and --model out.")
        return rivals_asked(between, own), ()
    suspected = suspected_in(model, own) if model and not given and not goal else []
    if len(suspected) > 1:
        return rivals_asked(",".join(suspected), own), ()
    chosen = terms_asked(given, own, saved_model(model, own).terms if model else ())
    check_goal(goal or INERTIA, chosen)
    return (), chosen


def check_planned(named, subject, rivals: tuple) -> None:
    """Refuse a rig of which nothing can be planned, before anything is computed."""
    from exoid.planning.plan import check_subject
    from exoid.planning.plan_between import check_let_go

    if not rivals:
        check_subject(subject)
        return
    each = [term if isinstance(term, type) else type(term) for term in sum(rivals, ())]
    check_let_go(subject, kinds_in(named), dict.fromkeys(each))


def by_name(goal: str) -> str:
    """The quantity that a symbol stands for, as J for the inertia."""
    from exoid.fitting.model.user_values import SYMBOLS

    return SYMBOLS.get(goal, goal)


def check_goal(goal: str, chosen: tuple) -> None:
    """Refuse what is no quantity of the model, before anything is computed."""
    from exoid.fitting.model.term_parameters import parameters_of, ratio_name
    from exoid.physics.library import library
    from exoid.physics.term import name_of

    classes = [each if isinstance(each, type) else type(each) for each in chosen]
    declared = parameters_of(classes)
    ratios = [ratio_name(name, each) for name, each in declared if each.inertia_power]
    goals = [*GOALS, *(name for name, _ in declared), *ratios]
    if goal in goals:
        return
    term = goal.partition(".")[0]
    more = f"; for this one, add --with {term}" if term in map(name_of, library()) else ""
    raise ValueError(f"--goal {goal}: it can be {', '.join(goals)}{more}.")


def tell_apart(named, subject, rivals: tuple, options: dict, json: Path | None) -> None:
    """Fit with each of the rivals, and print what would tell them apart."""
    from exoid.planning.plan_between import plan_between
    from exoid.report.tables.plan_between import contrast_document, print_contrast

    def work():
        fits = [compute(named, False, {**options, "terms": rival}) for rival in rivals]
        return fits, plan_between(fits, subject)

    fits, found = patiently(work, "planning; the first run of a new shape compiles for a minute")
    introduce(named)
    show(lambda console: print_contrast(found, console))
    files = Outputs()
    files.put_document(json, lambda: contrast_document(found, subject))
    files.end(any(each.follows for each in fits))


def planned(named, subject, goal: str, options: dict):
    """The fit of what there is, None where there is nothing, and the plan after it."""
    from exoid.planning.plan import plan as make

    if not named:
        prepare()
        return None, make(None, subject, goal, assumed=assumptions(options))
    result = compute(named, False, options)
    return result, make(result, subject, goal)


def assumptions(options: dict):
    """What a plan takes for granted before any fit."""
    from exoid.fitting.model.assumptions import Assumptions, by_hand

    said = by_hand([], *(options.get(name) for name in ("fix", "bound", "expect")))
    return Assumptions(prior=options["prior"], bounds=options["bounds"], by_hand=said)
