"""A leg that is pushed as it is let go: what gravity and springs do not do says so."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.pendulum.drops import measure_drops
from hands import Knee
from swings import HOLD, NOISE, recorded

STEP = 0.01  # s
TIME = np.arange(0.0, HOLD + 9.0, STEP)


def note(pull, spring, damping, *, push=0.0, lasting=0.05, noise=NOISE, tight=0.0):
    """What is said of a leg under gravity [1/s^2], a spring [1/s^2] about -40 deg and damping
    [1/s], let go at -10 deg, pushed by so much [rad/s] and drawn down by tight hamstrings [1/s^2].
    """

    def acceleration(time, state):
        angle, speed = state
        hand = push / lasting if time < lasting else 0.0
        own = -pull * np.cos(angle) - spring * (angle + 0.7) - damping * speed
        hamstrings = tight * np.exp((angle - begin[0]) / 0.15)
        return [speed, own - hand - hamstrings]

    begin = [np.radians(-10.0), 0.0]
    ends = {"rtol": 1e-8, "atol": 1e-10, "max_step": STEP, "dense_output": True}
    swing = solve_ivp(acceleration, (0.0, TIME[-1] - HOLD), begin, **ends).sol
    angle = swing(np.maximum(TIME - HOLD, 0.0))[0]
    angle = angle + noise * np.random.default_rng(1).normal(size=TIME.size)
    (found,) = measure_drops(recorded(angle, TIME, noise=noise)).drops
    assert found.reason is None
    return found.note or ""


def test_a_push_of_a_hand_is_told_by_what_no_leg_does_from_rest():
    said = note(26.0, 4.0, 0.8, push=0.9)
    assert "it was pushed" in said
    assert "± does not hold" in said


def test_where_hamstrings_draw_it_down_they_are_named_beside_a_push():
    said = note(26.0, 4.0, 0.8, tight=25.0)
    assert "it was pushed, a muscle or tight tissue draws it down there" in said


@pytest.mark.parametrize(
    "leg",
    [(26.0, 4.0, 0.8), (8.0, 35.0, 0.6), (26.0, 5.0, 4.0)],
    ids=["relaxed", "by a spring almost alone", "damped"],
)
def test_a_leg_that_is_let_go_at_rest_was_not_pushed(leg):
    assert "pushed" not in note(*leg)


def test_noise_that_hides_a_push_leaves_it_unsaid():
    assert "pushed" not in note(26.0, 4.0, 0.8, push=0.3, noise=0.005)


def on_a_hand(growth, held=-0.3, hold=0.3):
    """A drop onto a soft hand that sinks by `growth` t^3 [rad/s^3] under the leg."""
    knee, time = Knee(), np.arange(0.0, 6.0, 0.01)

    def slope(since, state):
        angle, speed = state
        below = held - growth * since**3 - angle
        hand = 700.0 * below + 14.0 * (-3 * growth * since**2 - speed)
        return speed, knee.pull(angle, speed) + (max(hand, 0.0) if growth else 0.0)

    since = np.maximum(time - hold, 0.0)
    ends = {"rtol": 1e-8, "atol": 1e-8, "max_step": 0.01, "dense_output": True}
    angle = solve_ivp(slope, (0.0, since[-1]), (held, 0.0), **ends).sol(since)[0]
    noisy = angle + 5e-4 * np.random.default_rng(0).standard_normal(angle.size)
    return measure_drops(recorded(noisy, time, noise=5e-4)).drops[0]


@pytest.mark.parametrize("growth", [0.0, 4.0, 6.0, 8.0])
def test_a_hand_that_goes_along_with_the_leg_as_it_sinks_ever_faster_is_told(growth):
    drop = on_a_hand(growth)
    told = "goes along with it" in (drop.note or "") or drop.landmarks.held is not None
    assert told == bool(growth)
