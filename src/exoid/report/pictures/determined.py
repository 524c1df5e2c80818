"""Who determined the numbers: shares of data, prior and bounds; every parameter with its error."""

import numpy as np

from exoid.fitting.errors.profile import named
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Bars, Note, Panel, Picture, Points
from exoid.report.pictures.role import Role
from exoid.report.pictures.search import marked
from exoid.report.words.estimate import on_bound
from exoid.report.words.text import NOT_DETERMINED, in_words

SOURCES = {"data": Role.DATA, "prior": Role.PRIOR, "bound": Role.BOUND}
GAP = 0.6  # of a bar, between parameters, ratios and what terms have
BAR, ROW = 0.47, 0.8  # sizes of a bar and of a parameter's panel
AVERAGED = "mean of the segments"  # each fitted by itself
HEIGHTS = {Role.CHOSEN: 0.75, Role.EXPECTED: 0.25, Role.LIMIT: 0.5}  # in a row


def shares_of(result: FitResult) -> Panel:
    """One bar per parameter and ratio: who made its error as small as it is."""
    names, each = zip(*named(result), strict=True)
    groups = [(name in result.ratios) + 2 * (name in result.of_terms) for name in names]
    rows = np.arange(len(each)) + GAP * np.array(groups)
    begin, bars = np.zeros(len(each)), []
    for source, role in SOURCES.items():
        part = np.array([0.0 if e.shares is None else getattr(e.shares, source) for e in each])
        bars.append(Bars(role, rows, part, begin))
        begin = begin + part
    untold = [
        Note(NOT_DETERMINED if one.value is None else AVERAGED, 0.02, float(row))
        for row, one in zip(rows, each, strict=True)
        if one.shares is None
    ]
    labels = tuple((float(row), f"`{one.symbol}`") for row, one in zip(rows, each, strict=True))
    return Panel(
        Axis("share of the precision", "-", (0.0, 1.0)),
        Axis(ticks=labels, reversed=True),
        (*bars, *untold),
        size=BAR * len(each),
    )


def show_shares(result: FitResult) -> Picture:
    return Picture(
        "shares",
        "Bars that show for every parameter and ratio which part of its precision came from the "
        "data, the prior and a bound; the same is in the column 'set by' of the parameters.",
        "Blue: this recording. White, striped: the anatomical prior. Red, crossed: a limit. "
        "Without a bar: nothing determines it.",
        (shares_of(result),),
    )


def show_parameters(parameters: dict[str, Estimate]) -> Picture | None:
    """Those that have a value or an expectation; None where none has."""
    rows = {name: each for name, each in parameters.items() if marked(each)}
    if not rows:
        return None
    return Picture(
        "parameters-figure",
        "Every parameter with its standard error, beside what anatomy expects: the numbers are in "
        "the table above.",
        "Each parameter on its own scale. Filled diamonds: this fit. Open squares: what anatomy "
        "expects of a person of this size. Upright lines: limits, where they are near.",
        tuple(parameter_of(name, each) for name, each in rows.items()),
    )


def parameter_of(name: str, each: Estimate) -> Panel:
    """One parameter with what was expected of it, on an axis of its own."""
    seen = view(marked(each), np.zeros(0))
    known = [
        (Role.CHOSEN, on_bound(each), each.standard_error),
        (Role.EXPECTED, each.expected, each.expected_deviation),
        *((Role.LIMIT, limit, None) for limit in (each.lower, each.upper)),
    ]
    points = tuple(
        Points(role, np.array([value]), np.array([HEIGHTS[role]]), error)
        for role, value, error in known
        if value is not None and seen[0] <= value <= seen[1]
    )
    across = Axis(f"{in_words(name)} `{each.symbol}`", each.unit, seen)
    return Panel(across, Axis(limits=(0.0, 1.0), hidden=True), points, size=ROW)
