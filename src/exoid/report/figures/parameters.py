"""Every parameter with its error beside what anatomy expects, on an axis of its own."""

import numpy as np
from plotly.graph_objects import Figure as Drawing

from exoid.fitting.result.fit_result import Estimate
from exoid.report.figures.figure import Figure
from exoid.report.figures.marks import CHOSEN, EXPECTED, LIMIT, put
from exoid.report.figures.style import blank, stacked
from exoid.report.plots.axis import Range, view
from exoid.report.plots.sources import marked
from exoid.report.plots.style import in_words
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.text import on_bound
from exoid.report.words.typeset import formula

ROW, REST = 92, 52  # pixels for each parameter, and for the legend
GAP = 0.55  # of a row, between two
TOP = 86  # pixels, for the legend and the title of the first row
HEIGHTS = {CHOSEN.name: 0.75, EXPECTED.name: 0.25, LIMIT.name: 0.5}  # in a row


def draw_parameters(parameters: dict[str, Estimate]) -> Figure | None:
    """Those that have a value or an expectation; None where none has."""
    rows = {name: each for name, each in parameters.items() if marked(each)}
    if not rows:
        return None
    drawing = blank(ROW * len(rows) + REST, margin={"t": TOP})
    places = stacked([1.0] * len(rows), GAP / len(rows))
    named: set[str] = set()
    for row, ((name, each), place) in enumerate(zip(rows.items(), places, strict=True), start=1):
        seen = view(marked(each), np.zeros(0))
        across = {"range": seen, "anchor": f"y{row}", "nticks": 6}
        up = {"range": [0, 1], "domain": place, "visible": False, "fixedrange": True}
        drawing.update_layout({f"xaxis{row}": across, f"yaxis{row}": up})
        entitle(drawing, tidy(f"{in_words(name)} {formula(each.symbol)} [{each.unit}]"), place[1])
        draw_row(drawing, each, seen, row, named)
    return Figure(
        "parameters-figure",
        "Every parameter with its standard error, beside what anatomy expects: the numbers are in "
        "the table above.",
        "Each parameter on its own scale. Filled diamonds: this fit. Open squares: what anatomy "
        "expects of a person of this size. Upright lines: limits, where they are near.",
        drawing,
    )


def entitle(drawing: Drawing, title: str, height: float) -> None:
    """A title over a row."""
    drawing.add_annotation(
        text=title,
        x=0,
        y=height,
        xref="paper",
        yref="paper",
        xanchor="left",
        yanchor="bottom",
        showarrow=False,
    )


def draw_row(drawing: Drawing, each: Estimate, seen: Range, row: int, named: set[str]) -> None:
    """One parameter; `named` are the marks that the legend has already."""
    kinds = [
        (CHOSEN, on_bound(each), each.standard_error),
        (EXPECTED, each.expected, each.expected_deviation),
        *((LIMIT, limit, None) for limit in (each.lower, each.upper)),
    ]
    for mark, value, error in kinds:
        if value is None or not seen[0] <= value <= seen[1]:
            continue
        put(
            drawing,
            mark,
            ([value], [HEIGHTS[mark.name]]),
            (error, None),
            xaxis=f"x{row}",
            yaxis=f"y{row}",
            showlegend=mark.name not in named,
            hovertemplate=f"%{{x:.4g}} {tidy(each.unit)}",
        )
        named.add(mark.name)
