"""What a start is tied to moves as the leg does."""

import numpy as np
import pytest

from exoid.fitting.data.guide import GUIDE_WIDTH, OF_SLOPE, twiced
from exoid.recordings.signal.local_line import local_line

TIME = np.arange(2048) / 1024  # s, in binary steps: every window holds as many samples
PACE = 7.0  # rad/s, of a light pendulum
INSIDE = slice(100, -100)  # no window is cut there
CUT = (GUIDE_WIDTH * PACE) ** 2 / 24  # of a swing, by the mean over a window


def test_lines_cut_a_swing_and_twiced_ones_by_the_square_of_that():
    """What is left of a swing once is 1 - cut, twice 1 - cut^2."""
    swing = np.cos(PACE * TIME)
    once, twice = (smooth(TIME, swing, GUIDE_WIDTH)[0] for smooth in (local_line, twiced))
    lost, less = (np.abs(each - swing)[INSIDE].max() for each in (once, twice))
    assert lost == pytest.approx(CUT, rel=0.05)  # the next power of the width, and whole samples
    assert less == pytest.approx(lost**2, rel=0.05)


def test_so_does_a_twiced_slope():
    rate = -PACE * np.sin(PACE * TIME)
    slopes = [smooth(TIME, np.cos(PACE * TIME), GUIDE_WIDTH)[1] for smooth in (local_line, twiced)]
    lost, less = (np.abs(each - rate)[INSIDE].max() for each in slopes)
    assert lost == pytest.approx(OF_SLOPE * CUT * PACE, rel=0.05)
    assert less < 2 * CUT * lost
