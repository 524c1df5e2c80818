"""What a model misses is in the error of d / J: drops of two legs, and dry friction."""

from functools import partial

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.recordings.measured.segment import Segment
from legs import recording

STARTS = np.radians([-15.0, -40.0, -25.0, -50.0])
WITHIN = 3.3  # standard errors: one in a thousand by chance is farther off
LEG = (25.5, 3.0, 0.6)  # m l g / J and c / J [1/s^2], d / J [1/s]
FRICTION = 0.25  # 1/s^2, over J: a hundredth of gravity
HEAVIER = 1.34  # times J, by 1 kg at 0.38 m of a leg of 0.42 kg m^2
PULL = 9.81 * 0.38 / 0.42  # 1/s^2, of that mass over J


def dropped(seed, start, leg=LEG, friction=0.0) -> Segment:
    gravity, stiffness, damping = leg

    def slope(_, state):
        angle, speed = state
        drag = damping * speed + friction * np.tanh(speed / 0.02)
        return speed, -gravity * np.cos(angle) - stiffness * angle - drag

    time, random = np.arange(0.0, 6.0, 0.01), np.random.default_rng(seed)
    seen = solve_ivp(slope, (0.0, 6.0), (start, 0.0), t_eval=time, rtol=1e-8, max_step=0.02).y
    noise = np.array([[8e-4], [3e-3]]) * random.standard_normal(seen.shape)
    return Segment(time, *(seen + noise))


def session(each):
    return recording(
        *(one(seed, start) for seed, (one, start) in enumerate(zip(each, STARTS, strict=True)))
    )


BARE = dropped
LOADED = partial(dropped, leg=((LEG[0] + PULL) / HEAVIER, LEG[1] / HEAVIER, LEG[2] / HEAVIER))
RUBBED = partial(dropped, friction=FRICTION)


def of_damping(each):
    """The estimate of d / J less the truth, and its error."""
    found = fit(session(each), multistart=2).ratios["damping_over_inertia"]
    assert found.value is not None
    assert found.standard_error is not None
    return abs(found.value - LEG[2]), found.standard_error


@pytest.mark.parametrize("each", [[BARE, LOADED] * 2, [RUBBED] * 4])
def test_what_is_missed_is_within_the_error(each):
    away, error = of_damping(each)
    assert away < WITHIN * error


def test_the_error_where_nothing_is_missed_is_as_small_as_ever():
    away, error = of_damping([BARE] * 4)
    assert away < WITHIN * error
    assert error < 0.005 * LEG[2]
