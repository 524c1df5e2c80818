"""What a clock that counts wrong does to the measures of a drop, and that it is told."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.disagreement import disagreement
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


@pytest.mark.parametrize("rate", [1.015, 1.05, 0.93, 1.1])
def test_speeds_by_a_wrong_clock_are_within_their_errors_where_a_gyro_shows_it(rate):
    (found,) = measure_drops(miscounted(rate)).drops
    assert found.note is not None
    assert f"disagree by {100 * (rate - 1):+.2g} % in scale" in found.note
    speed, fastest = found.measures["peak_flexion_velocity"], np.abs(TRUE[2]).max()
    assert speed.value is not None
    assert speed.standard_error is not None
    assert abs(abs(speed.value) - fastest) > 0.5 * abs(rate - 1) * fastest
    assert abs(abs(speed.value) - fastest) < 2.5 * speed.standard_error


@pytest.mark.parametrize("late", [0.0, 0.012])
def test_a_disagreement_in_scale_is_told_within_its_error_of_a_late_gyro_too(late):
    made = drop(start=STARTS)
    time, rate = made.time, made.raw_angular_velocity
    assert rate is not None
    off = replace(made, raw_angular_velocity=1.004 * np.interp(time - late, time, rate))
    found = disagreement(recording(off))
    assert found is not None
    assert abs(found.value - 0.004) < 3 * found.error
    assert found.error < (0.0004 if late == 0.0 else 0.005)


def test_angles_by_a_wrong_gain_are_within_their_errors_where_a_gyro_shows_it():
    """Nobody knows whether gyro, gain or clock is off, and a ratio of angles goes with none."""
    made = drop(start=STARTS)
    assert made.raw_angle is not None
    wrong = recording(replace(made, raw_angle=1.06 * made.raw_angle))
    (right,), (found,) = (measure_drops(each).drops for each in (recording(made), wrong))
    for name in ("first_flexion_amplitude", "peak_flexion_velocity", "peak_extension_velocity"):
        true, told = right.measures[name].value, found.measures[name]
        assert true is not None
        assert told.value is not None
        assert told.standard_error is not None
        assert told.value == pytest.approx(1.06 * true, rel=2e-3)
        assert abs(told.value - true) < 2.5 * told.standard_error
    index = [each.measures["expected_relaxation_index"].standard_error for each in (right, found)]
    assert index[1] == pytest.approx(index[0], rel=0.1)


@pytest.mark.parametrize("seen", [miscounted(1.0), miscounted(1.0, scale=0.001)])
def test_nothing_is_said_of_sensors_that_agree(seen):
    (found,) = measure_drops(seen).drops
    assert found.note is None
    speed = found.measures["peak_flexion_velocity"]
    assert speed.standard_error < 0.01 * abs(speed.value)


def test_times_hold_nothing_of_a_clock_that_somebody_vouches_for():
    (found,) = measure_drops(miscounted(1.05, clock_uncertainty=1e-4)).drops
    assert found.note is not None
    assert "it is the gyro's, or the encoder's gain, and no" in found.note
    period, swing = (found.measures[name] for name in ("period", "first_flexion_amplitude"))
    assert period.standard_error < 0.01 * period.value
    assert swing.standard_error > 0.01 * swing.value


RELAXED = (26.8, 2.7, 0.8)  # m l g / J and c / J [1/s^2], d / J [1/s]


def by_angle(rate: float, leg=RELAXED, **declared):
    """The drop of a camera whose times are a factor `rate` too long, and its greatest speed."""
    made = drop(leg, STARTS, gyro=False)
    seen = replace(made, time=rate * made.time)
    sensors = Sensors(angle_noise=8e-4, **declared)
    (found,) = measure_drops(recording(seen, sensors=sensors)).drops
    return found, np.abs(fall(leg, STARTS, step=1e-3)[2]).max()


def test_times_that_make_a_drop_slower_than_any_leg_of_its_body_are_in_the_errors():
    """125 samples a second, told as 100: by an angle alone nothing else shows it."""
    found, fastest = by_angle(1.25)
    assert "slower than any leg of this body swings" in found.note
    rate = float(found.note.partition("a sampling rate ")[2].partition(" ")[0])
    assert 1.1 < rate < 1.25  # its spring makes up for a part of it
    speed = found.measures["peak_flexion_velocity"]
    assert abs(speed.value - fastest) > 0.15 * fastest
    assert abs(speed.value - fastest) < 2.5 * speed.standard_error


@pytest.mark.parametrize("rate", [1.14, 1.2])
def test_errors_hold_of_a_slow_drop_what_its_spring_makes_up_for(rate):
    found, fastest = by_angle(rate)
    assert "slower than any leg of this body swings" in found.note
    speed = found.measures["peak_flexion_velocity"]
    assert abs(rate * speed.value - fastest) < 0.02 * fastest
    assert abs(speed.value - fastest) < 2 * speed.standard_error


def test_times_that_make_a_drop_faster_than_any_whole_leg_are_told():
    found, _ = by_angle(0.6)
    assert "of a stump or a light prosthesis all is well" in found.note


@pytest.mark.parametrize(
    ("rate", "leg", "declared"),
    [
        (1.0, RELAXED, {}),
        (1.0, (24.5, 1.2, 0.8), {}),  # of a body of which one in a hundred has as slow a leg
        (1.0, (26.8, 20.0, 5.0), {}),  # stiff
        (1.25, RELAXED, {"clock_uncertainty": 1e-4}),
    ],
)
def test_nothing_is_said_of_times_that_a_leg_of_this_body_may_have(rate, leg, declared):
    found, fastest = by_angle(rate, leg, **declared)
    assert found.note is None
    speed = found.measures["peak_flexion_velocity"]
    assert abs(rate * speed.value - fastest) < 0.02 * fastest
