"""A tilted thigh and an encoder whose zero is off look alike: what a fit says of the two."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY

GRAVITY, SPRING, DAMPING = 27.0, 4.0, 0.6  # m l g / J and c / J [1/s^2], d / J [1/s]
STARTS = np.radians((-15.0, -25.0, -35.0))
OFF = float(np.radians(10.0))


def drops(zero: float, tilt: float) -> Recording:
    """By SciPy: an encoder that shows `zero` with the knee extended, a thigh tilted beside it."""
    time, rng = np.arange(0.0, 4.0, 0.01), np.random.default_rng(1)

    def slope(_: float, state: np.ndarray) -> list[float]:
        angle, rate = state
        return [rate, -GRAVITY * np.cos(angle + tilt) - SPRING * angle - DAMPING * rate]

    segments = []
    for start in STARTS:
        solved = solve_ivp(slope, (0.0, 4.0), [start, 0.0], t_eval=time, rtol=1e-9, atol=1e-10)
        angle = solved.y[0] + zero + rng.normal(0.0, 1.7e-3, time.size)
        segments.append(Segment(time, raw_angle=angle))
    return Recording(tuple(segments), BODY, Protocol(kind="passive"))


def told(recording: Recording) -> str:
    said = [each for each in fit(recording, multistart=4).notes if "look nearly alike" in each]
    return said[0] if said else ""


@pytest.mark.parametrize(("zero", "tilt", "whose"), [(-OFF, 0.0, "encoder"), (0.0, OFF, "thigh")])
def test_the_ratios_of_whose_the_angle_truly_is_are_among_those_told(zero, tilt, whose):
    """By a straight line over 10 deg, whose bend is a part in ten of the way of 0.4 1/s^2."""
    said = told(drops(zero, tilt))
    pairs, _, thigh = said.partition("would be ")[2].partition(" 1/s^2 were all the encoder's, ")
    pair = pairs if whose == "encoder" else thigh.partition(" 1/s^2")[0]
    found = [float(each) for each in pair.split(" and ")]
    assert found == pytest.approx([GRAVITY, SPRING], abs=0.08)
    assert "the recording tells the 10 deg between the two" in said
    assert "d / J holds either way" in said


def test_a_level_thigh_and_a_true_zero_are_not_doubted():
    assert told(drops(0.0, 0.0)) == ""
