"""Sets of parameters that move the leg in the same way, by the pairs that trade off."""

import numpy as np

from exoid.fitting.result.fit_result import Estimate, FitResult
from exoid.report.figures.figure import Figure
from exoid.report.figures.marks import CHOSEN, EXPECTED, MEMBER, put
from exoid.report.figures.style import blank
from exoid.report.plots.axis import view
from exoid.report.plots.sources import PAIRS, drawable, marked, outside
from exoid.report.plots.style import in_words
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.text import on_bound
from exoid.report.words.typeset import formula

HEIGHT = 340  # pixels


def draw_families(result: FitResult) -> list[Figure]:
    """Of every pair for which there is a set or a value."""
    return [draw_family(result, pair) for pair in PAIRS if drawable(result, *pair)]


def draw_family(result: FitResult, pair: tuple[str, str]) -> Figure:
    """The chosen set with its errors, what was expected, and the sets that fit equally well."""
    both = [result.parameters[name] for name in pair]
    members = result.multistart.members
    known = members.keys() >= set(pair)
    points = np.array([members[name] for name in pair]) if known else np.zeros((2, 0))
    drawing, hover = blank(HEIGHT), hovering(both)
    if points.size:
        put(drawing, MEMBER, (points[0], points[1]), hovertemplate=hover)
    expected = [(each.expected, each.expected_deviation) for each in both]
    chosen = [(on_bound(each), each.standard_error) for each in both]
    for mark, coordinates in ((EXPECTED, expected), (CHOSEN, chosen)):
        (x, dx), (y, dy) = coordinates
        if x is not None and y is not None:
            put(drawing, mark, ([x], [y]), (dx, dy), hovertemplate=hover)
    views = [view(marked(each), row) for each, row in zip(both, points, strict=True)]
    titles = [
        tidy(f"{in_words(n)} {formula(e.symbol)} [{e.unit}]")
        for n, e in zip(pair, both, strict=True)
    ]
    drawing.update_xaxes(range=views[0], title_text=titles[0])
    drawing.update_yaxes(range=views[1], title_text=titles[1])
    names = " and ".join(map(in_words, pair)).capitalize()
    lost = outside(points, views) if points.size else ""
    return Figure(
        f"family-{'-'.join(pair)}",
        f"{names} of all sets that fit the motion equally well, with the chosen and the expected.",
        f"{names}: every dot fits the motion as well as the diamond does{lost}.",
        drawing,
    )


def hovering(both: list[Estimate]) -> str:
    """What is told of a point."""
    parts = zip("xy", both, strict=True)
    return tidy(
        ", ".join(f"{formula(each.symbol)} %{{{axis}:.4g}} {each.unit}" for axis, each in parts)
    )
