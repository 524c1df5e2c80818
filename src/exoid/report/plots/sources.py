"""What determined the numbers: shares of data, prior and bounds, where the starts ended, and the
sets of parameters that move the leg in the same way."""

from textwrap import fill
from typing import Any

import numpy as np
from jaxtyping import Float
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.ticker import MaxNLocator

from exoid.fitting.errors.profile import named
from exoid.fitting.multistart.search import SAME_LOSS
from exoid.fitting.result.fit_result import Estimate, FitResult, MultistartReport
from exoid.report.plots.axis import tick, view
from exoid.report.plots.style import CHOSEN, EXPECTED, MEMBER, SHARE, head, in_words, name_all
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.text import NOT_DETERMINED, counted, on_bound
from exoid.report.words.typeset import mathtext

PAIRS = (("mass", "com_distance"), ("inertia", "stiffness"), ("inertia", "damping"))
NO_REASON = "the recording does not tell"
LINEAR = 10.0  # cost over best cost, up to which a linear axis shows all starts
GAP = 0.6  # of a bar, between parameters and ratios


def draw_sources(figure: SubFigure, result: FitResult) -> None:
    """Shares (and costs, where starts ended at different ones), then the pairs that trade off."""
    head(figure, "What determined the numbers")
    costs = relative_costs(result.multistart)
    differ = costs.size > 0 and costs[-1] > 1 + SAME_LOSS
    pairs = [pair for pair in PAIRS if drawable(result, *pair)]
    panels = list(figure.subplots(1, 1 + differ + len(PAIRS)))
    if differ:
        draw_costs(panels[0], costs, result.multistart)
    draw_shares(panels[int(differ)], result)
    panels[0].set_title(ended(result.multistart), loc="left")
    families = panels[1 + differ :]
    for axes, pair in zip(families, pairs, strict=False):
        draw_family(axes, result, *pair)
    for axes in families[len(pairs) :]:
        axes.set_axis_off()
    if len(pairs) < len(PAIRS):
        why = families[len(pairs)].text(0, 1, missing(result, pairs), va="top")
        why.set_in_layout(False)
    name_all(figure, panels, "outside lower center", 6)


def relative_costs(report: MultistartReport) -> Float[np.ndarray, " start"]:
    """Costs over the best one, sorted; of the starts that came to an end."""
    costs = np.sort(report.loss[np.isfinite(report.loss)])
    return costs / costs[0] if costs.size and costs[0] > 0 else np.zeros(0)


def ended(report: MultistartReport) -> str:
    """How many starts arrived."""
    return (
        f"{report.at_best} of {report.starts} starts at the best cost,\n"
        f"{report.starts - report.succeeded} failed"
    )


def draw_costs(axes: Axes, costs: Float[np.ndarray, " start"], report: MultistartReport) -> None:
    """Cost over best cost, sorted: steps are distinct minima."""
    axes.plot(np.arange(1, costs.size + 1), costs, **MEMBER)
    if costs[-1] > LINEAR:
        axes.set_yscale("log")
    else:
        axes.set_ylim(0, max(2.0, 1.1 * costs[-1]))
    axes.xaxis.set_major_locator(MaxNLocator(5, integer=True))
    axes.set_xlim(0, report.starts + 1)
    axes.set_xlabel("start, sorted [-]")
    axes.set_ylabel("cost / best cost [-]")


def draw_shares(axes: Axes, result: FitResult) -> None:
    """One bar per parameter and ratio: who made its error as small as it is."""
    each = [estimate for _, estimate in named(result)]
    rows = np.arange(len(each)) + GAP * (np.arange(len(each)) >= len(each) - len(result.ratios))
    begin = np.zeros(len(each))
    for source, style in SHARE.items():
        part = np.array([0.0 if e.shares is None else getattr(e.shares, source) for e in each])
        axes.barh(rows, part, 0.75, begin, label=source, edgecolor="black", linewidth=0.5, **style)
        begin = begin + part
    for row, estimate in zip(rows, each, strict=True):
        if estimate.shares is None:
            axes.text(0.02, row, NOT_DETERMINED, va="center", style="italic")
    axes.set_yticks(rows, [mathtext(estimate.symbol) for estimate in each])
    axes.tick_params(axis="y", length=0)
    axes.invert_yaxis()
    axes.set_xlim(0, 1)
    axes.set_xlabel("share of the precision [-]")


def drawable(result: FitResult, across: str, up: str) -> bool:
    """Whether there is a set or a value of this pair."""
    known = all(result.parameters[name].value is not None for name in (across, up))
    return known or {across, up} <= result.multistart.members.keys()


def draw_family(axes: Axes, result: FitResult, across: str, up: str) -> None:
    """Sets that fit equally well, the chosen one with its errors, and what was expected."""
    names, members = (across, up), result.multistart.members
    both = [result.parameters[name] for name in names]
    points = np.array([members[name] for name in names if {across, up} <= members.keys()])
    if points.size:
        axes.plot(*points, **MEMBER, label="fits equally well")
    mark(axes, [(each.expected, each.expected_deviation) for each in both], EXPECTED)
    mark(axes, [(on_bound(each), each.standard_error) for each in both], CHOSEN)
    views = [
        view(marked(each), points[at] if points.size else np.zeros(0))
        for at, each in enumerate(both)
    ]
    axes.set(xlim=views[0], ylim=views[1])
    axes.set_xlabel(f"{in_words(across)} {mathtext(both[0].symbol)} [{tidy(both[0].unit)}]")
    axes.set_ylabel(f"{in_words(up)} {mathtext(both[1].symbol)} [{tidy(both[1].unit)}]")
    names = " and ".join(mathtext(each.symbol) for each in both)
    axes.set_title(f"{names}{outside(points, views)}", loc="left")
    tick(axes.xaxis, 5)
    tick(axes.yaxis, 5)


def marked(each: Estimate) -> list[float]:
    """What must be seen of one quantity: chosen and expected, with their bars."""
    both = ((on_bound(each), each.standard_error), (each.expected, each.expected_deviation))
    return [
        value + sign * (bar or 0.0) for value, bar in both if value is not None for sign in (-1, 1)
    ]


def outside(points: np.ndarray, views: list[tuple[float, float]]) -> str:
    """How many sets the view leaves out."""
    if not points.size:
        return ""
    low, high = np.array(views).T[..., None]
    lost = int(np.sum(np.any((points < low) | (points > high), axis=0)))
    return f" ({counted(lost, 'set')} outside)" if lost else ""


def mark(axes: Axes, both: list[tuple[float | None, float | None]], style: dict[str, Any]) -> None:
    """One point with its error bars, where both coordinates are known."""
    (x, dx), (y, dy) = both
    if x is not None and y is not None:
        axes.errorbar(x, y, xerr=dx, yerr=dy, zorder=3, elinewidth=1, **style)


def missing(result: FitResult, pairs: list[tuple[str, str]]) -> str:
    """What is not shown, and why."""
    lost = {name for pair in PAIRS if pair not in pairs for name in pair}
    unknown = {name: each for name, each in result.parameters.items() if name in lost}
    reasons: dict[str, list[str]] = {}
    for name, each in unknown.items():
        if each.value is None:
            reasons.setdefault(each.reason or NO_REASON, []).append(in_words(name))
    wide = 30 * (len(PAIRS) - len(pairs))
    lines = [f"{', '.join(names)} not determined:\n{reason}" for reason, names in reasons.items()]
    return "\n".join(fill(line, wide) for text in lines for line in text.split("\n"))
