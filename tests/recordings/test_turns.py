"""How fast a signal moves, by where it turns."""

import numpy as np
import pytest

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.turns import coarse, pace

TIME = np.arange(0, 10, 0.01)


@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_an_oscillation_has_its_own_angular_frequency(noise):
    """To a sample in half a period; noise of 2 % of the amplitude moves a turn, and makes none."""
    wobble = noise * np.random.default_rng(0).normal(size=TIME.size)
    for frequency in (0.5, 2.0):
        found = pace(TIME, np.sin(2 * np.pi * frequency * TIME) + wobble)
        step = 2 * frequency * 0.01 * (1 if noise == 0 else 8)
        assert found == pytest.approx(2 * np.pi * frequency, rel=step)


def test_what_never_turns_has_no_pace():
    assert pace(TIME, TIME) == 0.0


def test_only_few_samples_a_period_are_coarse_and_never_of_what_moves_as_a_leg():
    assert not coarse(TIME, np.sin(2 * np.pi * 1.0 * TIME))
    assert not coarse(TIME[::10], np.sin(2 * np.pi * 2.0 * TIME[::10]))  # few samples, but slow
    assert coarse(TIME, np.sin(2 * np.pi * 11.0 * TIME))


def test_a_declared_noise_stands_where_neighbours_see_the_motion():
    """Nine samples a period: the quintic through six of them is off by far more than the noise."""
    angle = 0.1 * np.sin(2 * np.pi * 11.3 * TIME)
    recording = Recording(
        (Segment(TIME, raw_angle=angle),),
        Subject(kind="rig"),
        Protocol(),
        Sensors(angle_noise=1e-6),
    )
    cleaned = clean(recording)
    assert cleaned.angle.level == 1e-6
    assert cleaned.angle.tone is None  # the motion is no hum that could be taken out
    np.testing.assert_array_equal(cleaned.recording.segments[0].raw_angle, angle)
