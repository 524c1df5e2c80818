"""The figure of a drop whose angle drifts, of which everything is read less that drift."""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.report.pictures.drops import show_drop
from exoid.report.plots.drops import plot_drops
from swings import NOISE, Oscillator, drop, recorded


def test_the_figure_of_an_angle_that_drifts_has_it_as_measured_and_as_it_was_read():
    time = np.arange(0.0, 14.0, 0.01)
    angle = Oscillator().angle(time - 1.0) + np.radians(0.6) * time
    angle += NOISE * np.random.default_rng(1).normal(size=time.size)
    drifting = measure_drops(recorded(angle, time))
    lines = {line.get_label(): line for line in plot_drops(drifting).axes[0].lines}
    assert "measured angle" not in lines
    ends = [lines[name].get_ydata()[-1] for name in ("angle, as measured", "less its drift")]
    # 14 s of a slope that is told within 0.01 deg/s
    assert ends == pytest.approx([np.degrees(angle[-1]), np.degrees(-1.2)], abs=0.5)
    caption = show_drop(drifting.drops[0], 0).caption
    assert "read off the angle less a drift of +0." in caption


def test_the_figure_of_an_angle_that_stays_has_what_was_measured():
    labels = {
        line.get_label() for line in plot_drops(measure_drops(drop(noise=NOISE))).axes[0].lines
    }
    assert "measured angle" in labels
    assert "less its drift" not in labels
