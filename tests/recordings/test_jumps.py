"""Jumps of an angle that no gyro shows, and what is none."""

import numpy as np
import pytest

from exoid.recordings.conventions.jumps import jumping, jumps, jumps_of
from exoid.recordings.measured.segment import Segment

NOISE = 4e-4  # rad
TIME = 0.01 * np.arange(500)


def swing(seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """A damped swing of 60 deg as both sensors show it."""
    random = np.random.default_rng(seed)
    phase, fall = 5.0 * TIME, np.exp(-0.6 * TIME)
    angle = np.cos(phase) * fall
    rate = -(5.0 * np.sin(phase) + 0.6 * np.cos(phase)) * fall
    return angle + NOISE * random.normal(size=TIME.size), rate + 2e-3 * random.normal(
        size=TIME.size
    )


def test_a_frame_that_slips_jumps_once_and_by_as_much():
    angle, rate = swing()
    angle[200:] += np.radians(2.5)
    (found,) = jumps(TIME, angle, rate, NOISE)
    assert found.time == pytest.approx(2.0)
    assert np.degrees(found.size) == pytest.approx(2.5, abs=0.3)  # five times the noise of a step


def test_samples_that_are_lost_where_the_leg_moves_are_seen():
    angle, rate = swing()
    kept = np.delete(np.arange(TIME.size), np.arange(100, 104))
    (found,) = jumps(TIME[: kept.size], angle[kept], rate[kept], NOISE)
    assert found.time == pytest.approx(1.0)
    said = jumping({"0": [found], "1": []})
    assert said is not None
    assert said.startswith("in segment 0 the angle jumps by")
    assert jumping({"0": []}) is None


def test_an_encoder_that_stands_still_jumps_when_it_goes_on():
    angle, rate = swing()
    angle[150:190] = angle[150]
    (found,) = jumps(TIME, angle, rate, NOISE)
    assert found.time == pytest.approx(1.9)


@pytest.mark.parametrize("fault", ["nothing", "scale", "bias", "late", "spike", "coarse", "held"])
def test_what_a_sensor_does_all_the_time_and_a_spike_are_none(fault):
    angle, rate = swing()
    if fault == "scale":
        rate = 1.2 * rate
    if fault == "bias":
        rate = rate + 0.1
    if fault == "late":
        rate = np.roll(rate, 4)[10:]
        angle = angle[10:]
    if fault == "spike":
        angle[200] += 0.5
    if fault == "coarse":
        angle = np.radians(1.0) * np.round(angle / np.radians(1.0))
    if fault == "held":  # an encoder that is read every fourth time
        angle = np.repeat(angle[::4], 4)
    assert jumps(TIME[: angle.size], angle, rate, NOISE) == []


def test_a_strike_is_in_the_rate_and_no_jump():
    angle, rate = swing()
    rate[250:] = -0.5 * rate[250:]
    angle[250:] = angle[249] + np.cumsum(rate[250:]) * 0.01
    assert jumps(TIME, angle, rate, NOISE) == []


def test_a_gap_of_which_the_times_tell_is_none():
    angle, rate = swing()
    kept = np.delete(np.arange(TIME.size), np.arange(100, 226))  # a whole period
    assert jumps(TIME[kept], angle[kept], rate[kept], NOISE) == []


def test_without_a_gyro_a_jump_is_told_from_the_steps_beside_it():
    angle, _ = swing()
    assert jumps(TIME, angle, None, NOISE) == []
    angle[200:] += np.radians(8.0)
    (found,) = jumps(TIME, angle, None, NOISE)
    assert np.degrees(found.size) == pytest.approx(8.0, abs=0.5)  # of a step that bends by 0.1


@pytest.mark.parametrize("gyro", [True, False])
@pytest.mark.parametrize("missing", [199, 200])
def test_a_sample_that_is_missing_beside_a_jump_does_not_hide_it(missing, gyro):
    angle, rate = swing()
    angle[200:] += np.radians(8.0)
    angle[missing] = np.nan
    (found,) = jumps(TIME, angle, rate if gyro else None, NOISE)
    assert found.time == pytest.approx(2.0, abs=0.011)


def test_of_a_segment_that_was_cut_a_jump_is_told_by_the_clock_of_the_recording():
    angle, rate = swing()
    angle[200:] += np.radians(2.5)
    segment = Segment(TIME, raw_angle=angle, raw_angular_velocity=rate, begins=1.9)
    (found,) = jumps_of(segment, NOISE)
    assert found.time == pytest.approx(3.9)
