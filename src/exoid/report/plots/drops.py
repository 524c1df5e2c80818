"""The pendulum test as one figure: every drop with its measures marked on the curves."""

from math import ceil

from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.pendulum.drop import PendulumTest
from exoid.report.pictures.drops import drop_of
from exoid.report.plots.arrange import draw_bands
from exoid.report.plots.style import TEXT

ACROSS = 3  # drops side by side
SHOWN = 12  # drops; the first ones
WIDE = 3.6  # inches of a drop
NARROWEST = 6.4  # inches, in which the legend finds room
TALL = 5.6  # inches of its three panels


def plot_drops(test: PendulumTest) -> Figure:
    """Angle, angular velocity and angular acceleration of every drop over time, with release,
    peaks, plateau and rest; spans name the amplitudes A1 and A0, the period T and the time to rest.

    **Raises** `ValueError` where no segment could be read.

    >>> exoid.plot_drops(exoid.measure_drops("drops.csv")).savefig("drops.png")
    """
    readable = [each for each in test.drops if each.landmarks is not None]
    drops = readable[:SHOWN]
    if not drops:
        raise ValueError("no segment could be read as a drop: there is nothing to draw.")
    bands = ceil(len(drops) / ACROSS)
    across = ceil(len(drops) / bands)
    size = max(WIDE * across, NARROWEST), TALL * bands + 0.5
    with rc_context(TEXT):
        figure = Figure(figsize=size, layout=ConstrainedLayoutEngine(w_pad=0.05, h_pad=0.05))
        (part,) = figure.subfigures(1, 1, squeeze=False)[:, 0]
        draw_bands(part, [drop_of(drop) for drop in drops], across)
        if len(drops) < len(readable):
            figure.suptitle(f"The first {len(drops)} of {len(readable)} drops")
    return figure
