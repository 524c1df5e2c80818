"""What a clock that counts wrong does to the measures of a drop, and that it is told."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.recording import Recording, Sensors
from legs import drop, fall, recording

STARTS = -0.35
TRUE = fall(start=STARTS, step=1e-3)


def miscounted(rate: float, scale: float = 0.0, **declared) -> Recording:
    """A drop whose times are a factor `rate` too long, by a gyro of this error of its scale."""
    made = drop(start=STARTS)
    assert made.raw_angular_velocity is not None
    gyro = (1 + scale) * made.raw_angular_velocity
    wrong = replace(made, time=rate * made.time, raw_angular_velocity=gyro)
    return recording(wrong, sensors=Sensors(**declared))


@pytest.mark.parametrize("rate", [1.05, 0.93, 1.1])
def test_speeds_by_a_wrong_clock_are_within_their_errors_where_a_gyro_shows_it(rate):
    (found,) = measure_drops(miscounted(rate)).drops
    assert found.note is not None
    assert f"disagree by {100 * (rate - 1):+.0f} % in scale" in found.note
    speed, fastest = found.measures["peak_flexion_velocity"], np.abs(TRUE[2]).max()
    assert speed.value is not None
    assert speed.standard_error is not None
    assert abs(abs(speed.value) - fastest) > 0.03 * fastest
    assert abs(abs(speed.value) - fastest) < 2.5 * speed.standard_error


def test_angles_do_not_go_with_the_clock():
    errors = [
        measure_drops(miscounted(rate)).drops[0].measures["first_flexion_amplitude"]
        for rate in (1.0, 1.05)
    ]
    assert errors[1].standard_error == pytest.approx(errors[0].standard_error, rel=0.1)


@pytest.mark.parametrize(
    "seen",
    [
        miscounted(1.0),
        miscounted(1.0, scale=0.02),  # as gyros are
        miscounted(1.05, clock_uncertainty=1e-4),
    ],
)
def test_nothing_is_said_of_a_usual_gyro_nor_of_a_clock_that_somebody_vouches_for(seen):
    (found,) = measure_drops(seen).drops
    assert found.note is None
    speed = found.measures["peak_flexion_velocity"]
    assert speed.standard_error < 0.01 * abs(speed.value)
