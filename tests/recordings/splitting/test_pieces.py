"""What the movements of a continuous recording are, by how they go."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import BPoly

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.signal import signal_of, smoothed, speed_error
from exoid.recordings.splitting.pieces import find_pieces
from exoid.recordings.splitting.split import kept_parts

STEP = 0.01  # s
LIFTED = 15.0  # s, when a hand begins to lift the leg
REST, HELD = np.radians(-76.0), np.radians(-12.0)


def session(rng: np.random.Generator) -> np.ndarray:
    """Two drops that swing out to rest, and between them a hand that lifts the leg [rad]."""
    hold, lift = np.full(100, HELD), np.linspace(0, 1, 300)
    time = np.arange(0.0, 14.0, STEP)
    drop = REST + (HELD - REST) * np.exp(-0.4 * time) * np.cos(5 * time)
    raised = drop[-1] + (HELD - drop[-1]) * (10 * lift**3 - 15 * lift**4 + 6 * lift**5)
    angle = np.concatenate([hold, drop, raised, hold, drop])
    return angle + np.radians(0.1) * rng.normal(size=angle.size)


def log_of(angle):
    return Segment(STEP * np.arange(angle.size), raw_angle=angle)


def found_in(angle):
    return find_pieces(log_of(angle), Sensors(), None)


def pieces_of(angle):
    return [each.name for each in found_in(angle)]


@pytest.mark.parametrize("seed", range(3))
def test_a_lift_lies_between_two_drops(seed):
    assert pieces_of(session(np.random.default_rng(seed))) == ["a drop", "a lift", "a drop"]


@pytest.mark.parametrize("seed", range(3))
def test_a_drop_of_the_other_sign_is_no_hands_lift(seed):
    """What rings was let go, whichever way it went; only a check of the signs may judge it."""
    names = pieces_of(REST - session(np.random.default_rng(seed)))
    assert [each for each in names if each == "a drop upwards"] == ["a drop upwards"] * 2


@pytest.mark.parametrize("seed", range(5))
def test_a_drop_ends_before_the_hand_that_lifts_the_leg_softly(seed):
    log = log_of(session(np.random.default_rng(seed)))
    first, _ = kept_parts(log, find_pieces(log, Sensors(), None))
    assert LIFTED - 1.0 < log.time[first.stop - 1] <= LIFTED


def test_empty_cells_between_the_samples_of_an_angle_tell_nothing_of_it():
    angle = session(np.random.default_rng(3))
    fine = np.full((angle.size, 4), np.nan)
    fine[:, 0] = angle
    time = STEP / 4 * np.arange(fine.size)
    sparse = signal_of(Segment(time, raw_angle=fine.ravel()), Sensors())
    plain = signal_of(log_of(angle), Sensors())
    for width in (0.05, 0.4):
        assert speed_error(sparse, width) == pytest.approx(speed_error(plain, width))
        assert smoothed(sparse, width)[1] == pytest.approx(smoothed(plain, width)[1])
    assert sparse.averaged(STEP).angle_noise == pytest.approx(plain.angle_noise)


def swung(start: float, seconds: float, speed: float = 0.0) -> np.ndarray:
    """Angle and speed of a relaxed leg, by SciPy: (channel, sample)."""

    def moved(_, state):
        angle, rate = state
        return rate, -27.0 * np.cos(angle) - 2.0 * angle - 0.5 * rate

    time = np.arange(0.0, seconds, STEP)
    return solve_ivp(moved, (0.0, seconds), (start, speed), t_eval=time, rtol=1e-8).y


def taken(leg: np.ndarray, to: float, seconds: float = 1.5) -> np.ndarray:
    """What a hand does that takes a leg as it swings, and brings it to rest at an angle."""
    path = BPoly.from_derivatives([0.0, seconds], [[*leg[:, -1], 0.0], [to, 0.0, 0.0]])
    return path(np.arange(0.0, seconds, STEP))


def measured(parts: list[np.ndarray]) -> np.ndarray:
    angle = np.concatenate(parts)
    return angle + np.radians(0.05) * np.random.default_rng(1).normal(size=angle.size)


def test_a_small_drop_is_one_however_far_a_hand_then_lifts_the_leg_that_still_swings():
    parts = []
    for start, later in ((-20, -40), (-40, -55), (-55, -20), (-20, -55), (-55, -10)):
        leg = swung(np.radians(start), 7.0)
        hand = taken(leg, np.radians(later))
        parts += [np.full(100, leg[0, 0]), leg[0], hand]
    assert pieces_of(measured([*parts, np.full(100, hand[-1])])) == ["a drop"] * 5


def test_a_leg_that_a_hand_pushes_in_its_swings_is_left_out():
    first = swung(np.radians(-55), 2.0)
    hand = taken(first, np.radians(-20), 0.4)
    pushed = [np.full(100, first[0, 0]), first[0], hand, swung(hand[-1], 15.0)[0]]
    assert [each.kind for each in found_in(measured(pushed))] == [None]
