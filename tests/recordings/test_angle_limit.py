"""An angle that goes beyond its sensor's range, and those that turn, stop or stand; by SciPy."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.conventions.left_out.angle_limit import without_clipped
from exoid.recordings.conventions.left_out.held_values import without_held

TIME = 0.01 * np.arange(500)
STEP = 360.0 / 4096  # deg, of an encoder of 12 bit


def swing(start: float, stop: float = -200.0, give: float = 60.0) -> np.ndarray:
    """A leg's angle [deg] that is let go after 0.5 s, above a `stop` that gives or not."""

    def slope(_, state):
        angle, rate = state
        into = max(np.radians(stop) - angle, 0.0)
        met = max(3000.0 * into - give * rate, 0.0) if into else 0.0
        return rate, -26.5 * np.cos(angle) - 2.2 * angle - 0.7 * rate + met

    exact = {"rtol": 1e-9, "atol": 1e-10, "dense_output": True, "max_step": 0.01}
    found = solve_ivp(slope, (0.0, 5.0), [np.radians(start), 0.0], **exact).sol
    return np.degrees(found(np.maximum(TIME - 0.5, 0.0))[0])


def measured(*angles: np.ndarray, step: float = STEP, noise: float = 0.03) -> exoid.Recording:
    """Angles [deg] by a sensor that comes in steps."""
    random, segments = np.random.default_rng(0), []
    for each in angles:
        seen = each + noise * random.normal(size=each.size)
        seen = np.round(seen / step) * step if step else seen
        segments.append(exoid.Segment(TIME, raw_angle=np.radians(seen)))
    return exoid.Recording(tuple(segments))


def bounded(recording: exoid.Recording, low: float, high: float) -> exoid.Recording:
    """As a sensor tells it whose range [deg] ends there."""
    ends = np.radians(low), np.radians(high)
    segments = (replace(each, raw_angle=each.raw_angle.clip(*ends)) for each in recording.segments)
    return replace(recording, segments=tuple(segments))


@pytest.mark.parametrize("step", [0.0, STEP])
@pytest.mark.parametrize("low", [-85.0, -95.0, -105.0, -115.0])
def test_what_stands_at_the_end_of_a_range_is_left_out(low, step):
    clipped = bounded(measured(swing(-12.0), swing(-20.0), step=step), low, 0.0)
    mended, (note,) = without_clipped(clipped)
    for before, after in zip(clipped.segments, mended.segments, strict=True):
        beyond = before.raw_angle == np.radians(low)
        assert beyond.sum() > 5
        gone = np.isnan(after.raw_angle)
        assert gone[beyond].all()
        assert (before.raw_angle[gone] < np.radians(low + 0.5)).all()
    assert f"the angle stands at {low:.4g} deg while the leg moves on" in note


@pytest.mark.parametrize("high", [-20.0, -30.0])
def test_a_leg_that_is_let_go_beyond_the_range_is_first_seen_when_it_falls(high):
    clipped = bounded(measured(swing(-6.0), swing(-9.0)), -200.0, high)
    mended, notes = without_clipped(clipped)
    assert len(notes) == 1
    for each in mended.segments:
        assert np.isnan(each.raw_angle[:55]).all()
        assert not np.isnan(each.raw_angle[75:]).any()


def test_the_end_of_a_range_is_no_value_that_a_logger_repeats():
    clipped = bounded(measured(swing(-12.0), swing(-20.0)), -95.0, 0.0)
    assert without_held(clipped)[1] == ()


@pytest.mark.parametrize("step", [0.0, STEP, 0.5, 1.0])
@pytest.mark.parametrize("stop", [-200.0, -100.0, -60.0])
@pytest.mark.parametrize("give", [3.0, 60.0])
def test_a_leg_that_turns_or_meets_a_stop_ends_no_range(step, stop, give):
    recording = measured(swing(-12.0, stop, give), swing(-20.0, stop, give), step=step, noise=0.01)
    assert without_clipped(recording) == (recording, ())


@pytest.mark.parametrize("play", [0.4, 0.8, 1.6, 3.0])
def test_play_ends_no_range(play):
    """It comes to stand as slowly as the leg turns, and leaves faster."""
    truth = swing(-12.0)
    angle, half = truth.copy(), play / 2
    for k in range(1, angle.size):
        angle[k] = np.clip(angle[k - 1], truth[k] - half, truth[k] + half)
    recording = measured(angle, angle, noise=0.0)
    assert without_clipped(recording) == (recording, ())


@pytest.mark.parametrize("count", [2, 5, 8])
def test_a_slow_sensor_that_is_held_ends_no_range(count):
    held = swing(-12.0)[np.arange(TIME.size) // count * count]
    recording, _ = without_held(measured(held, noise=0.0))
    assert without_clipped(recording) == (recording, ())


def test_what_a_logger_repeats_at_the_lowest_is_none_of_its_range():
    """It leaves by a jump."""
    angle = swing(-12.0)
    lowest = int(np.argmin(angle))
    angle[lowest - 10 : lowest + 15] = angle[lowest]
    recording = measured(angle, noise=0.0)
    assert without_clipped(recording) == (recording, ())
