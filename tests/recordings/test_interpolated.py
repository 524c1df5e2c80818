"""Values on straight lines between those of a slow sensor, and such as are so by themselves."""

import numpy as np
import pytest

from exoid.recordings.conventions.left_out.interpolated import without_interpolated
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from legs import fall

TIME, ANGLE, RATE = fall(duration=5.0)
RANDOM = np.random.default_rng(3)
WRITTEN = 1e-4  # deg


def written(degrees: np.ndarray) -> np.ndarray:
    return np.radians(WRITTEN * np.round(degrees / WRITTEN))


def noisy(noise: float) -> np.ndarray:
    """The angle with noise [deg], in degrees."""
    return np.degrees(ANGLE) + noise * RANDOM.standard_normal(ANGLE.size)


def recorded(angle: np.ndarray, rate: np.ndarray | None = None) -> Recording:
    return Recording((Segment(TIME, raw_angle=angle, raw_angular_velocity=rate),))


@pytest.mark.parametrize("often", [2, 3, 4, 5])
@pytest.mark.parametrize("noise", [0.01, 0.1])
def test_what_was_measured_alone_stays(often, noise):
    slow = noisy(noise)[::often]
    angle = written(np.interp(TIME, TIME[::often], slow))
    made, (note,) = without_interpolated(recorded(angle, RATE))
    assert note.startswith(f"{often - 1} of {often} values of the angle lie on straight lines")
    (segment,) = made.segments
    known = np.flatnonzero(~np.isnan(segment.best_angle))
    measured = np.arange(0, TIME.size, often)
    # at rest one in so many lies on its line by chance; the last is on no line
    assert set(known[:-1]) <= set(measured)
    assert known.size > 0.9 * measured.size
    assert segment.raw_angular_velocity is not None
    assert segment.raw_angular_velocity.tolist() == RATE.tolist()


@pytest.mark.parametrize("noise", [0.0, 0.0005, 0.01, 0.1])
@pytest.mark.parametrize("step", [WRITTEN, 0.09, 0.5])
def test_what_was_measured_at_every_sample_is_left_alone(noise, step):
    angle = np.radians(step * np.round(noisy(noise) / step))
    recording = recorded(angle, RATE)
    assert without_interpolated(recording) == (recording, ())
