"""What drops are worth that pass the threshold of a stretch reflex, or stay below it."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from exoid.fitting.model.coordinates import Shared
from exoid.mismatch.conclude.verdict.past_threshold import (
    PLAIN,
    Drop,
    fastest_from,
    of_drops,
    passing_from,
)

LEGS = [(27.1, 9.0, 1.3), (35.2, 12.5, 1.25), (25.0, 4.0, 0.6), (40.0, 3.0, 2.4)]  # over J
THRESHOLD = 1.8  # rad/s


def leg(gravity: float, stiffness: float, damping: float) -> Shared:
    """Its ratios, of 1 kg m^2."""
    each = (0.0, gravity, stiffness, damping)
    return Shared(*map(np.asarray, each))


def fastest(start: float, gravity: float, stiffness: float, damping: float) -> float:
    """By SciPy's integrator."""

    def rates(_, state):
        angle, rate = state
        return rate, -gravity * np.cos(angle) - stiffness * angle - damping * rate

    return -solve_ivp(rates, (0.0, 1.5), (start, 0.0), max_step=0.005, rtol=1e-8).y[1].min()


@pytest.mark.parametrize("ratios", LEGS)
def test_the_angle_from_which_a_drop_passes_a_threshold_is_that_of_an_integrator(ratios):
    true = brentq(lambda start: fastest(start, *ratios) - THRESHOLD, -1.1, 0.0, xtol=1e-4)
    found = passing_from(leg(*ratios), THRESHOLD)
    # Damping is that of a linear oscillator: 0.4 deg at most of 60 legs, drawn as these are.
    assert found == pytest.approx(true, abs=np.radians(0.5))


def test_no_drop_passes_a_threshold_that_the_leg_does_not_reach():
    slow = leg(25.0, 4.0, 0.6)
    assert passing_from(slow, 1.01 * float(fastest_from(np.zeros(1), slow)[0])) is None


def test_advice_counts_the_drops_that_are_there():
    """As four that all pass 102 deg/s: more angles are of no use, lower ones are."""
    high = [Drop(str(k), np.radians(start), 3.0) for k, start in enumerate((-10, -25, -40))]
    said = of_drops(high, THRESHOLD, np.radians(-48.0))
    assert "from -40 deg and higher, passed its threshold of 103 deg/s" in said
    assert "from about -48 deg on: add some from -53 deg or lower; EMG" in said
    both = [*high, Drop("3", np.radians(-55.0), 1.2)]
    assert "segment 3 stayed below" in of_drops(both, THRESHOLD, np.radians(-48.0))
    assert of_drops(high, THRESHOLD, None) == PLAIN
