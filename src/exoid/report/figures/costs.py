"""Where the starts of the search ended: their costs, sorted."""

import numpy as np

from exoid.fitting.result.fit_result import MultistartReport
from exoid.report.figures.figure import Figure
from exoid.report.figures.marks import MEMBER, put
from exoid.report.figures.style import blank
from exoid.report.plots.sources import LINEAR, ended, relative_costs

HEIGHT = 300  # pixels


def draw_costs(report: MultistartReport) -> Figure | None:
    """Every start's cost over the best, sorted: steps are distinct minima; None if all failed."""
    costs = relative_costs(report)
    if not costs.size:
        return None
    drawing = blank(HEIGHT, showlegend=False, margin={"t": 12})
    starts = np.arange(1.0, costs.size + 1)
    put(drawing, MEMBER, (starts, costs), hovertemplate="start %{x}: %{y:.4g} times the best")
    drawing.update_xaxes(title_text="start, sorted", range=[0, report.starts + 1])
    drawing.update_yaxes(title_text="cost / best cost")
    if costs[-1] > LINEAR:
        drawing.update_yaxes(type="log")
    else:
        drawing.update_yaxes(range=[0, max(2.0, 1.1 * costs[-1])])
    said = ended(report).replace("\n", " ")
    return Figure(
        "costs",
        f"The cost of every start of the search over the best one, sorted: {said}.",
        f"{said}. A level line is one solution that many starts found; steps are others.",
        drawing,
    )
