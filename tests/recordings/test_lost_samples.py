"""Values that are repeated where nobody measured, and those of a leg at rest."""

import numpy as np
import pytest

import exoid
from exoid.recordings.conventions.left_out.lost_samples import lost, without_lost_samples, zeros

TIME = 0.01 * np.arange(500)
PHASE, FALL = 5.0 * TIME, np.exp(-0.6 * TIME)
ANGLE = np.cos(PHASE) * FALL - 1.5
RATE = -(5.0 * np.sin(PHASE) + 0.6 * np.cos(PHASE)) * FALL
HOLE = slice(150, 190)


def recorded(angle: np.ndarray, **subject: str) -> exoid.Recording:
    segment = exoid.Segment(TIME, raw_angle=angle)
    return exoid.Recording((segment,), subject=exoid.Subject(**subject))


@pytest.mark.parametrize("value", [0.0, -3.0])
def test_a_value_that_the_angle_jumps_to_is_none(value):
    angle = ANGLE.copy()
    angle[HOLE] = value
    assert np.flatnonzero(lost(TIME, angle, None)).tolist() == list(range(500))[HOLE]


def test_an_encoder_that_stands_still_is_told_by_its_gyro_or_by_where_it_goes_on():
    angle = ANGLE.copy()
    angle[HOLE] = angle[HOLE.start]
    for rate in (RATE, None):
        assert np.flatnonzero(lost(TIME, angle, rate)).tolist() == list(range(500))[HOLE]


def stuttering(code: float, seed: int = 0) -> tuple[exoid.Segment, list[int]]:
    """Encoder [code in deg] and gyro of a logger that writes one row of twelve twice, or three
    times, and which of the rows where the leg is fast.
    """
    rng = np.random.default_rng(seed)
    noisy = ANGLE + rng.normal(0.0, 1e-3, TIME.size), RATE + rng.normal(0.0, 5e-3, TIME.size)
    angle, rate = np.radians(code) * np.round(noisy[0] / np.radians(code)), noisy[1]
    again = np.sort(rng.choice(np.arange(1, TIME.size), 40, replace=False))
    for row in again:
        angle[row], rate[row] = angle[row - 1], rate[row - 1]
    fast = [int(row) for row in again if abs(RATE[row]) > 1.2 and 5 < row < 494]
    return exoid.Segment(TIME, raw_angle=angle, raw_angular_velocity=rate), fast


@pytest.mark.parametrize("code", [0.01, 360 / 4096, 0.1])
def test_a_row_that_is_written_again_while_the_leg_moves_is_none(code):
    segment, fast = stuttering(code)
    (found,) = without_lost_samples(exoid.Recording((segment,)))[0].segments
    assert len(fast) >= 8
    assert np.isnan(found.raw_angle[fast]).all()
    assert np.isnan(found.raw_angular_velocity[fast]).all()
    assert np.isnan(found.raw_angle).sum() <= 40


@pytest.mark.parametrize("code", [0.01, 360 / 4096, 0.2, 1.0])
def test_no_row_of_a_leg_is_taken_for_one_that_is_written_again(code):
    """Nor of one that is held at first, and hits a stop."""
    rng = np.random.default_rng(1)
    held = np.concatenate([np.full(100, ANGLE[0]), np.maximum(ANGLE, -1.9)[:400]])
    rate = np.round(np.gradient(held, 0.01), 3)
    shown = np.radians(code) * np.round((held + rng.normal(0, 1e-4, 500)) / np.radians(code))
    segment = exoid.Segment(TIME, raw_angle=shown, raw_angular_velocity=rate)
    recording = exoid.Recording((segment,))
    assert without_lost_samples(recording) == (recording, ())


@pytest.mark.parametrize("play", [1.0, 3.0, 6.0, 10.0])
def test_an_encoder_that_play_holds_where_the_leg_turns_back_stays(play):
    """It stands while its gyro turns through the play, and goes on from there without a jump."""
    angle, half = ANGLE.copy(), np.radians(play) / 2
    for k in range(1, angle.size):
        angle[k] = np.clip(angle[k - 1], ANGLE[k] - half, ANGLE[k] + half)
    assert (np.diff(angle) == 0.0).sum() > 10
    assert not lost(TIME, angle, RATE).any()


def test_what_a_coarse_encoder_shows_at_rest_stays():
    held = np.concatenate([np.full(100, ANGLE[0]), ANGLE[:400]])
    held[420:] = held[420]  # caught while it moves
    resting = np.round(np.degrees(held)) * np.radians(1.0)
    assert not lost(TIME, resting, np.full(TIME.size, np.radians(5.0))).any()  # a gyro's bias


def test_a_slow_camera_on_a_leg_that_is_caught_loses_nothing():
    angle = ANGLE[::5].copy()
    angle[30:] = angle[29]
    assert not lost(TIME[::5], angle, None).any()


def test_it_is_said_where_and_a_rig_is_left_alone():
    angle = ANGLE.copy()
    angle[HOLE] = 0.0
    mended, (note,) = without_lost_samples(recorded(angle))
    assert np.isnan(mended.segments[0].best_angle).sum() == 40
    assert note.startswith("samples (40 of the angle) between 1.50 and 1.89 s repeat a value")
    same, notes = without_lost_samples(recorded(angle, kind="rig"))
    assert notes == ()
    assert same.segments[0].best_angle[HOLE.start] == 0.0


@pytest.mark.parametrize("count", [1, 2, 5])
def test_zeros_of_a_gyro_that_turns_before_and_after_are_none(count):
    """Whatever the encoder shows there."""
    random = np.random.default_rng(0)
    fast = np.flatnonzero(np.abs(RATE) > 1.0)[5::40]
    for empty in (False, True):
        angle, rate = ANGLE + 2e-3 * random.normal(size=TIME.size), RATE.copy()
        gone = np.zeros(TIME.size, dtype=bool)
        for at in fast:
            gone[at : at + count] = True
        rate[gone] = 0.0
        angle[gone & empty] = 0.0
        assert zeros(TIME, angle, rate).tolist() == gone.tolist()


def test_true_zeros_of_a_gyro_stay():
    """Of a coarse one where the leg turns, and of one that rests before and after a blow."""
    coarse = np.round(RATE / 0.3) * 0.3
    assert (coarse == 0.0).sum() > 50
    assert not zeros(TIME, ANGLE, coarse).any()
    struck = np.where((TIME > 1.0) & (TIME < 1.05), 5.0, 0.0)
    turned = np.where(TIME > 1.0, np.minimum(5.0 * (TIME - 1.0), 0.25), 0.0) - 1.0
    assert not zeros(TIME, turned, struck).any()


def test_it_is_said_of_a_gyro_and_what_it_holds_with_the_angle_goes_too():
    angle, rate = ANGLE.copy(), RATE.copy()
    angle[HOLE], rate[HOLE] = angle[HOLE.start], rate[HOLE.start]
    segment = exoid.Segment(TIME, raw_angle=angle, raw_angular_velocity=rate)
    mended, (note,) = without_lost_samples(exoid.Recording((segment,)))
    assert note.startswith("samples (40 of the angle and 39 of the gyro) between 1.50 and")
    seen = mended.segments[0].raw_angular_velocity
    assert seen is not None
    assert np.isnan(seen).sum() == 39
