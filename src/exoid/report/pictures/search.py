"""Where the starts of a search ended, and the sets of parameters that move the leg alike."""

import numpy as np
from jaxtyping import Float

from exoid.files.counted import counted
from exoid.fitting.multistart.search_result import SAME_LOSS
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult, MultistartReport
from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Mark, Panel, Picture, Points, Range
from exoid.report.pictures.role import Role
from exoid.report.words.estimate import on_bound
from exoid.report.words.text import by_reason, in_words

PAIRS = (("mass", "com_distance"), ("inertia", "stiffness"), ("inertia", "damping"))
NO_REASON = "the recording does not tell"
LINEAR = 10.0  # cost over best cost, up to which a linear axis shows all starts
SIZE = 4.0
FAMILY = 30.0  # times the chosen one with its errors: a tenfold m or J is in it
Known = tuple[float | None, float | None]  # a value and its error


def relative_costs(report: MultistartReport) -> Float[np.ndarray, " start"]:
    """Costs over the best one, sorted; of the starts that came to an end."""
    costs = np.sort(report.loss[np.isfinite(report.loss)])
    return costs / costs[0] if costs.size and costs[0] > 0 else np.zeros(0)


def differ(report: MultistartReport) -> bool:
    """Did starts end at different costs?"""
    costs = relative_costs(report)
    return costs.size > 0 and bool(costs[-1] > 1 + SAME_LOSS)


def ended(report: MultistartReport) -> str:
    """How many starts arrived."""
    return (
        f"{report.at_best} of {report.starts} starts at the best cost,\n"
        f"{report.starts - report.succeeded} failed"
    )


def costs_of(report: MultistartReport) -> Panel:
    """Cost over best cost, sorted: steps are distinct minima."""
    costs = relative_costs(report)
    wide = bool(costs[-1] > LINEAR)
    limits = None if wide else (0.0, max(2.0, 1.1 * float(costs[-1])))
    starts = np.arange(1.0, costs.size + 1)
    return Panel(
        Axis("start, sorted", "-", (0.0, report.starts + 1.0)),
        Axis("cost / best cost", "-", limits, wide),
        (Points(Role.START, starts, costs),),
        size=SIZE,
    )


def show_costs(report: MultistartReport) -> Picture | None:
    """Of every start; None if all failed."""
    if not relative_costs(report).size:
        return None
    said = ended(report).replace("\n", " ")
    return Picture(
        "costs",
        f"The cost of every start of the search over the best one, sorted: {said}.",
        f"{said}. A level line is one solution that many starts found; steps are others.",
        (costs_of(report),),
    )


def pairs_of(result: FitResult) -> list[tuple[str, str]]:
    """Those of which there is a set or a value."""
    members = result.multistart.members.keys()
    return [
        pair
        for pair in PAIRS
        if all(result.parameters[name].value is not None for name in pair) or {*pair} <= members
    ]


def family_of(result: FitResult, pair: tuple[str, str]) -> Panel:
    """Sets that fit equally well, the chosen one with its errors, and what was expected."""
    members, both = result.multistart.members, [result.parameters[name] for name in pair]
    known = members.keys() >= {*pair}
    points = np.array([members[name] for name in pair]) if known else np.zeros((2, 0))
    sets = (Points(Role.MEMBER, points[0], points[1]),) if points.size else ()
    views = [view(marked(each), row, FAMILY) for each, row in zip(both, points, strict=True)]
    axes = [
        Axis(f"{in_words(name)} `{each.symbol}`", each.unit, seen)
        for name, each, seen in zip(pair, both, views, strict=True)
    ]
    expected = [(each.expected, each.expected_deviation) for each in both]
    chosen = [(on_bound(each), each.standard_error) for each in both]
    marks = (*sets, *at(Role.EXPECTED, *expected), *at(Role.CHOSEN, *chosen))
    names = " and ".join(f"`{each.symbol}`" for each in both)
    return Panel(axes[0], axes[1], marks, f"{names}{outside(points, views)}", SIZE)


def show_family(result: FitResult, pair: tuple[str, str]) -> Picture:
    """Of one pair."""
    names, panel = " and ".join(map(in_words, pair)).capitalize(), family_of(result, pair)
    lost = panel.title.partition(" (")[2]
    return Picture(
        f"family-{'-'.join(pair)}",
        f"{names} of all sets that fit the motion equally well, with the chosen and the expected.",
        f"{names}: every dot fits the motion as well as the diamond does{lost and f' ({lost}'}.",
        (panel,),
    )


def at(role: Role, across: Known, up: Known) -> tuple[Mark, ...]:
    """One point with its errors, where both coordinates are known."""
    (x, dx), (y, dy) = across, up
    if x is None or y is None:
        return ()
    return (Points(role, np.array([x]), np.array([y]), dx, dy),)


def marked(each: Estimate) -> list[float]:
    """What must be seen of one quantity: chosen and expected, with their errors."""
    both = ((on_bound(each), each.standard_error), (each.expected, each.expected_deviation))
    return [
        value + sign * (error or 0.0)
        for value, error in both
        if value is not None
        for sign in (-1, 1)
    ]


def outside(points: Float[np.ndarray, "2 set"], views: list[Range]) -> str:
    """How many sets the view leaves out."""
    low, high = np.array(views).T[..., None]
    lost = int(np.sum(np.any((points < low) | (points > high), axis=0)))
    return f" ({counted(lost, 'set')} outside)" if lost else ""


def missing(result: FitResult) -> list[str]:
    """Which parameters are not shown in a pair, and why."""
    lost = {name for pair in PAIRS if pair not in pairs_of(result) for name in pair}
    reasons = by_reason(
        (in_words(name), each.reason or NO_REASON)
        for name, each in result.parameters.items()
        if name in lost and each.value is None
    )
    return [f"{', '.join(names)} not determined:\n{reason}" for reason, names in reasons.items()]
