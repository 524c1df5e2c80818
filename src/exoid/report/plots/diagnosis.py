"""A diagnosis as one figure: where they part, which cause explains it, before and after."""

from textwrap import fill

from matplotlib import rc_context
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.pictures.mismatch.causes import causes_of
from exoid.report.pictures.mismatch.proof import proof_of
from exoid.report.pictures.mismatch.torque import (
    called_in,
    parting_of,
    plane_of,
    shown_of,
    torque_of,
    worst,
)
from exoid.report.plots.arrange import draw_rows, head
from exoid.report.plots.draw import draw
from exoid.report.plots.style import TEXT
from exoid.report.words.diagnosis.remainder import by_what
from exoid.report.words.diagnosis.verdict import verdict
from exoid.report.words.text import in_degrees

WIDE, TALL = 10.5, 9.4  # inches
WIDEST = 120  # letters of a heading


def plot_diagnosis(found: Diagnosis) -> Figure:
    """Missing torque over time and over the phase plane; the causes by what they leave; the
    residual of every held-out segment without and with what was found.

    >>> exoid.plot_diagnosis(exoid.diagnose("drops.csv", multistart=4)).savefig("why.png")
    """
    with rc_context(TEXT):
        layout = ConstrainedLayoutEngine(w_pad=0.07, h_pad=0.05)
        figure = Figure(figsize=(WIDE, TALL), layout=layout)
        parts = figure.subfigures(3, 1, squeeze=False, height_ratios=[1.0, 1.15, 1.0])[:, 0]
        head(parts[0], parting(found))
        draw_rows(
            parts[0],
            [[torque_of(parting_of(found), number, called_in(found)) for number in worst(found)]],
        )
        draw_causes(parts[1], found)
        head(parts[2], proof(found))
        draw_rows(parts[2], [[proof_of(found, number) for number in worst(found)]])
        figure.suptitle(verdict(found), fontweight="bold")
    return figure


def parting(found: Diagnosis) -> str:
    """What the torques over time are, and which of them are not drawn."""
    chosen = f"; {shown}" if (shown := shown_of(found)) else ""
    lacks = f"the {called_in(found).noun} that Eq. 9 lacks once the leg swings free"
    return f"Where they part: {lacks}{chosen}"


def draw_causes(figure: SubFigure, found: Diagnosis) -> None:
    """Where in the phase plane a torque is missing, and what explains it."""
    plane, bars = figure.subplots(1, 2, width_ratios=[1.0, 1.2])
    draw(plane, plane_of(parting_of(found), called_in(found)))
    draw(bars, causes_of(found))
    for axes in (plane, bars):
        axes.set_title(axes.get_title(loc="left"), loc="left", fontweight="bold")


def proof(found: Diagnosis) -> str:
    """How well held-out data are predicted, without and with what was found."""
    before, after, floor = (
        in_degrees(each)
        for each in (found.proof.before.total, found.proof.after.total, found.proof.noise_floor)
    )
    told = f"{before} deg before, {after} deg{by_what(found) or ' after'}"
    if not found.changed:
        told = f"{after} deg"
    return fill(f"On held-out data: angle RMSE {told}, noise floor {floor} deg", WIDEST)
