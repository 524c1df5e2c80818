"""A figure for print: one session in time, and the residual torques of everybody."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
import numpy as np
from benchmarks.closed_loop.carrying import LIMIT
from benchmarks.closed_loop.host import ENABLED
from benchmarks.closed_loop.measure import Outcome
from benchmarks.closed_loop.script import Script
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from exoid.report.plots.style import TEXT

DOTS = 200  # per inch
BLUE, ORANGE = "#0072B2", "#D55E00"  # of Okabe and Ito
SHOWN = {
    "off": "motor off",
    "frame": "frame\ncarried",
    "anatomy": "J by\nanatomy",
    "weighed": "J by\nweight",
    "unnoticed": "another leg,\nunnoticed",
    "anatomy again": "learned\nagain",
    "weighed again": "J by weight\nagain",
}


def draw(script: Script, every: Sequence[Outcome], path: Path) -> None:
    """Save the figure: that session, and the spread of these."""
    with mpl.rc_context(TEXT):
        figure = Figure(figsize=(9.0, 7.2), layout="constrained")
        angle, torque, residual, spread = figure.subplots(4, 1, height_ratios=(1.0, 1.0, 1.0, 1.5))
        course(script, (angle, torque, residual))
        boxes(spread, every)
        figure.savefig(path, dpi=DOTS)


def course(script: Script, axes: tuple[Axes, Axes, Axes]) -> None:
    """Angle, command and residual in time, with what the motor carries behind them."""
    table = script.session.log.table
    angle, torque, residual = axes
    time, changed = table["time"], script.changed
    angle.plot(time, np.degrees(table["angle"]), color=BLUE, linewidth=0.7)
    angle.set_ylabel("leg / deg")
    torque.plot(time, table["command"], color=BLUE, linewidth=0.7)
    for limit in (LIMIT, -LIMIT):
        torque.axhline(limit, color="0.5", linewidth=0.7, linestyle="--")
    torque.set_ylabel("command / N m")
    moving = np.full(time.size, np.nan)
    for one in script.moved:
        moving[one.rows] = table["residual"][one.rows]
    residual.plot(time, moving, color=ORANGE, linewidth=0.7)
    residual.set_ylabel("residual / N m")
    residual.set_xlabel("time / s; shaded: the motor carries; dotted: another person sits down")
    for one in axes:
        low, high = one.get_ylim()
        on = table["permit"] == ENABLED
        one.fill_between(time, low, high, where=on, color="0.9", linewidth=0, zorder=0)
        one.set_ylim(low, high)
        one.set_xlim(0.0, time[-1])
        one.axvline(changed, color="black", linewidth=0.9, linestyle=":")


def boxes(axes: Axes, every: Sequence[Outcome]) -> None:
    """The residual of everybody, by movement: quartiles, and all of them as dots."""
    names = [name for name in SHOWN if any(name in one.efforts for one in every)]
    rows = [
        [
            one.efforts[name].residual
            for one in every
            if name in one.efforts and (one.efforts[name].carried or name.startswith("off"))
        ]
        for name in names
    ]
    spread = np.random.default_rng(0)
    for place, row in enumerate(rows, start=1):
        beside = place + spread.uniform(-0.15, 0.15, len(row))
        axes.plot(beside, row, ".", color=BLUE, markersize=3, alpha=0.5)
    axes.boxplot(rows, widths=0.5, showfliers=False, medianprops={"color": ORANGE})
    axes.set_xticks(range(1, len(names) + 1), [SHOWN[name] for name in names])
    axes.set_ylim(0.0, None)
    axes.set_ylabel("residual rms / N m")
    axes.set_title(f"{len(every)} people", loc="left")
