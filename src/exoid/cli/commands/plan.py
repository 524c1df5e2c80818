"""exoid plan: what to record next."""

from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.commands.analysis import compute, prepare
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.body import BodyMass, Height, given_body
from exoid.cli.inputs.choices import Bounds, FlipOption, ZeroOption
from exoid.cli.inputs.reading import Columns, read
from exoid.cli.outputs.destination import check_apart, check_destination
from exoid.cli.outputs.results import end, introduce
from exoid.cli.terminal.waiting import patiently


class Goal(StrEnum):
    """What a plan is to narrow."""

    inertia = "inertia"
    damping = "damping"
    stiffness = "stiffness"
    mass = "mass"
    com_distance = "com_distance"
    gravity_over_inertia = "gravity_over_inertia"
    stiffness_over_inertia = "stiffness_over_inertia"
    damping_over_inertia = "damping_over_inertia"


def plan(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="What was recorded of this leg so far; nothing plans the first session."
        ),
    ] = None,
    goal: Annotated[Goal, typer.Option(help="What to narrow.")] = Goal.inertia,
    prior: Prior = None,
    bounds: BoundsOption = Bounds.body,
    fix: Fix = None,
    bound: Bound = None,
    body_mass: BodyMass = None,
    height: Height = None,
    column: Columns = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Starts of the fit.")] = 64,
    seed: Annotated[int, typer.Option(min=0, help="Of the starts.")] = 0,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    json: Annotated[
        Path | None, typer.Option(help="Everything for machines.", metavar="FILE")
    ] = None,
) -> None:
    """Say which recording would narrow a quantity most, and how far.

    \b
    Examples:
      exoid plan --body-mass 77 --height 1.80     the first session of a person
      exoid plan drop.csv                         what to add for the inertia
      exoid plan drop.csv --goal damping          for the damping
    """
    check_destination(json)
    check_apart([json], recordings or [])
    body = given_body(body_mass=body_mass, height=height)
    from exoid.recordings.recording import Subject

    named = []
    for path in recordings or []:
        told = {"column": column, "flip": flip, "zero": zero}
        loaded = read(path, None, None, False, **told)
        named.append((path.name, replace(loaded, subject=replace(loaded.subject, **body))))
    subject = named[0][1].subject if named else replace(Subject(kind="leg"), **body)
    options = {"multistart": multistart, "seed": seed, **assumed(prior, bounds, fix, bound)}
    result, found = patiently(
        lambda: planned(named, subject, goal.value, options),
        "planning; the first run of a new shape compiles for some seconds",
    )
    introduce(named)
    if result is not None and not result.follows:
        typer.echo(f"{result.notes[0]}\n")
    from rich.console import Console

    from exoid.report.tables.plan import plan_document, print_plan

    print_plan(found, Console())
    if json is not None:
        from exoid.report.document.plain_json import write_json

        write_json(plan_document(found, result, subject), json)
        typer.echo(f"wrote {json}", err=True)
    end(result is None or result.follows)


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
