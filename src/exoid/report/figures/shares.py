"""Who determined the numbers: shares of data, prior and bounds in the precision of each."""

from plotly.graph_objects import Bar

from exoid.fitting.errors.profile import named
from exoid.fitting.result.fit_result import FitResult
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import SHARE_LOOK, blank
from exoid.report.words.text import NOT_DETERMINED
from exoid.report.words.typeset import formula

ROW, REST = 30, 90  # pixels for each quantity, and for legend and axis


def draw_shares(result: FitResult) -> Figure:
    """One bar per parameter and ratio."""
    each = [estimate for _, estimate in named(result)]
    drawing = blank(ROW * len(each) + REST, barmode="stack")
    labels = [f"{formula(one.symbol)}{'' if one.shares else f', {NOT_DETERMINED}'}" for one in each]
    for source, look in SHARE_LOOK.items():
        parts = [0.0 if one.shares is None else getattr(one.shares, source) for one in each]
        drawing.add_trace(
            Bar(
                x=parts,
                y=labels,
                orientation="h",
                name=source,
                marker={"line": {"color": "#000000", "width": 0.5}, **look},
                hovertemplate="%{x:.0%}",
            )
        )
    drawing.update_yaxes(autorange="reversed", ticks="", showgrid=False)
    drawing.update_xaxes(range=[0, 1.005], tickformat=".0%", title_text="share of the precision")
    return Figure(
        "shares",
        "Bars that show for every parameter and ratio which part of its precision came from the "
        "data, the prior and a bound; the same is in the column 'set by' of the parameters.",
        "Blue: this recording. White, striped: the anatomical prior. Red, crossed: a limit. "
        "Without a bar: nothing determines it.",
        drawing,
    )
