"""Start and first acceleration of legs that a hand moves before it lets go, by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.stats import chi2

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import ADULT

RATE, HOLD, LASTING = 100.0, 1.5, 12.0  # Hz, s, s
STEP = np.radians(360 / 4096)  # of an encoder with 12 bits
MANY = 16  # drops of a hand


def let_go(sway: float, hertz: float, seed: int, fading: float = 0.0):
    """A drop from a hand that sways by `sway` deg, and the angle [rad] and the greatest
    acceleration [rad/s^2] with which it begins to fall; its torque fades in so many s.
    """
    rng = np.random.default_rng(seed)
    phase, start, late = rng.uniform(0, 2 * np.pi), rng.uniform(-0.6, -0.2), rng.uniform(0, 1)
    size, speed = np.radians(sway), 2 * np.pi * hertz

    def hand(t):
        return start + size * np.sin(speed * t + phase)

    begin = np.array([hand(0.0), size * speed * np.cos(phase)])
    carried = -size * speed**2 * np.sin(phase) - ADULT.pull(*begin)

    def slope(t, y):
        kept = max(1 - t / fading, 0.0) if fading else 0.0
        return y[1], ADULT.pull(*y) + kept * carried

    time = (np.arange((HOLD + LASTING) * RATE) + late) / RATE - HOLD
    leg = solve_ivp(slope, (0, LASTING + 1), begin, rtol=1e-8, max_step=0.02, dense_output=True)
    angle = np.where(time < 0, hand(time), leg.sol(np.maximum(time, 0))[0])
    seen = STEP * np.round((angle + rng.normal(0, STEP / 3, time.size)) / STEP)
    recording = Recording(
        (Segment(time + HOLD, raw_angle=seen),), Subject(kind="leg"), Protocol(kind="passive")
    )
    fallen = leg.sol(np.linspace(0, 0.3, 301))
    steepest = max(-slope(t, y)[1] for t, y in zip(np.linspace(0, 0.3, 301), fallen.T, strict=True))
    return recording, begin[0], steepest


@pytest.mark.parametrize(("sway", "hertz"), [(0.0, 1.0), (0.2, 0.7), (2.0, 0.7), (0.1, 6.0)])
def test_errors_hold_how_a_hand_moved_the_leg(sway, hertz):
    off = []
    for seed in range(MANY):
        recording, *truth = let_go(sway, hertz, seed)
        (found,) = measure_drops(recording).drops
        each = [found.measures[name] for name in ("start_angle", "peak_flexion_acceleration")]
        off.append(
            [(one.value - is_) / one.standard_error for one, is_ in zip(each, truth, strict=True)]
        )
    # More happens once in a thousand times.
    assert (np.square(off).sum(axis=0) < chi2.ppf(0.999, MANY)).all()


@pytest.mark.parametrize("fading", [0.3, 0.35, 0.4])
def test_a_hand_that_takes_a_third_of_a_second_to_let_go_is_noticed_mostly(fading):
    """What is read of it is of a leg that was kept back: noise hides that in one of eight."""
    drops = [measure_drops(let_go(0.0, 1.0, seed, fading=fading)[0]).drops[0] for seed in range(8)]
    reasons = [str(each.measures["first_flexion_amplitude"].reason) for each in drops]
    assert sum("no free fall" in each for each in reasons) >= 7


@pytest.mark.parametrize("fading", [0.0, 0.05, 0.1])
def test_a_hand_that_lets_go_at_once_keeps_no_leg_back(fading):
    for seed in range(8):
        (found,) = measure_drops(let_go(0.0, 1.0, seed, fading=fading)[0]).drops
        assert found.measures["first_flexion_amplitude"].value is not None
