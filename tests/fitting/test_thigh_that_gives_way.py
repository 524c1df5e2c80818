"""A thigh on a firm cushion gives way by hundredths of a degree, and looks like a tilted seat."""

import numpy as np
from scipy.integrate import solve_ivp

from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.recordings.measured.segment import Segment
from legs import recording

GRAVITY = 9.80665  # m/s^2
MASS, DISTANCE, INERTIA, STIFFNESS, DAMPING = 4.0, 0.25, 0.36, 1.6, 0.19  # of the leg
THIGH, LENGTH = 1.2, 0.4  # kg m^2 about the hip, m
CUSHION, LOSS = 3.6e4, 60.0  # N m/rad, N m s/rad
STARTS = (-0.3, -0.7, -0.1, -0.5)  # rad
WITHIN = 3.3  # standard errors: one in a thousand by chance is farther off


def rates(_, state):
    """Thigh and shank, both about the horizontal, as two rigid bodies."""
    thigh, shank, thigh_rate, shank_rate = state
    between = shank - thigh
    coupled = MASS * LENGTH * DISTANCE
    knee = -STIFFNESS * between - DAMPING * (shank_rate - thigh_rate)
    weight = MASS * GRAVITY
    inertia = [
        [THIGH + MASS * LENGTH**2, coupled * np.cos(between)],
        [coupled * np.cos(between), INERTIA],
    ]
    torque = [
        coupled * np.sin(between) * shank_rate**2
        - CUSHION * thigh
        - LOSS * thigh_rate
        - weight * LENGTH * (np.cos(thigh) - 1)
        - knee,
        -coupled * np.sin(between) * thigh_rate**2 - weight * DISTANCE * np.cos(shank) + knee,
    ]
    return [thigh_rate, shank_rate, *np.linalg.solve(inertia, torque)]


def drop(start, seed):
    """What an encoder at the knee and a gyro on the shank make of it."""
    time = np.arange(0.0, 9.0, 0.01)
    found = solve_ivp(
        rates, (0.0, 9.0), (0.0, start, 0.0, 0.0), t_eval=time, rtol=1e-8, atol=1e-9, method="LSODA"
    )
    thigh, shank, _, shank_rate = found.y
    assert np.degrees(np.ptp(thigh)) < 0.15  # all that it gives way
    random = np.random.default_rng(seed)
    return Segment(
        time,
        raw_angle=shank - thigh + 1e-3 * random.standard_normal(time.size),
        raw_angular_velocity=shank_rate + 5e-3 * random.standard_normal(time.size),
    )


def test_errors_hold_a_thigh_that_gives_way_and_a_level_seat():
    result = fit(recording(*map(drop, STARTS, range(4))), multistart=2)
    ratios, profiled = result.ratios, profiles(result)
    truth = {"gravity": MASS * DISTANCE * GRAVITY / INERTIA, "stiffness": STIFFNESS / INERTIA}
    for name, true in truth.items():
        found = ratios[f"{name}_over_inertia"]
        assert abs(found.value - true) < WITHIN * found.standard_error
        assert found.standard_error < 0.02 * truth["gravity"]  # still worth something
        profile = profiled[f"{name}_over_inertia"]  # looks as far as the error does
        assert profile.lower < true < profile.upper
