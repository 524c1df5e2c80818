"""Play that an angle alone shows, and legs by sensors without any; by SciPy."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.signal.play_at_turns import play_at_turns

NOISE = np.radians(0.03)


@cache
def swings(rate: float, friction: float, stop: float = -9.0) -> list[np.ndarray]:
    """Angles [rad] of a leg that is let go from three."""

    def slope(_, state):
        angle, speed = state
        met = max(3000.0 * (stop - angle) - 3.0 * speed, 0.0) if angle < stop else 0.0
        rubs = friction * np.tanh(speed / 0.003)
        return speed, -26.5 * np.cos(angle) - 2.2 * angle - 0.7 * speed - rubs + met

    times, found = np.arange(0.0, 5.0, 1 / rate), []
    for start in np.radians([-12.0, -20.0, -25.0]):
        exact = {"rtol": 1e-8, "atol": 1e-9, "t_eval": times, "method": "LSODA", "max_step": 0.02}
        found.append(solve_ivp(slope, (0.0, 5.0), [start, 0.0], **exact).y[0])
    return found


def shown(angle: np.ndarray, play: float) -> np.ndarray:
    """By a sensor with play [deg]."""
    seen, half = angle.copy(), np.radians(play) / 2
    for k in range(1, seen.size):
        seen[k] = np.clip(seen[k - 1], angle[k] - half, angle[k] + half)
    return seen


def told(angles: list[np.ndarray], rate: float, play: float) -> float | None:
    random, signals = np.random.default_rng(0), []
    for each in angles:
        seen = shown(each, play) + NOISE * random.standard_normal(each.size)
        signals.append((np.arange(each.size) / rate, seen))
    found = play_at_turns(signals, NOISE)
    return None if found is None else float(np.degrees(found))


@pytest.mark.parametrize("rate", [50.0, 100.0, 200.0])
@pytest.mark.parametrize("friction", [0.0, 0.4])
@pytest.mark.parametrize("play", [0.8, 1.6])
def test_play_is_told_by_where_the_leg_turns(rate, friction, play):
    """To a step of the widths that are asked for, a quarter."""
    found = told(swings(rate, friction), rate, play)
    assert found is not None
    assert found == pytest.approx(play, rel=0.26)


@pytest.mark.parametrize("rate", [50.0, 100.0, 200.0])
@pytest.mark.parametrize(("friction", "stop"), [(0.0, -9.0), (0.4, -9.0), (1.5, -9.0), (0.0, -1.9)])
def test_a_sensor_without_play_shows_none(rate, friction, stop):
    """Where friction turns the leg, and where a stop does."""
    assert told(swings(rate, friction, stop), rate, 0.0) is None


def test_drops_say_that_play_is_more_than_their_errors_hold():
    random, rate, segments = np.random.default_rng(0), 100.0, []
    for each in swings(rate, 0.0):
        held = np.concatenate([np.full(50, each[0]), each])
        seen = shown(held, 0.8) + NOISE * random.standard_normal(held.size)
        segments.append(exoid.Segment(np.arange(held.size) / rate, raw_angle=seen))
    test = exoid.measure_drops(exoid.Recording(tuple(segments)))
    assert all("as behind 0.8 deg of play" in str(each.note) for each in test.drops)
