"""The smallest possible errors are what repeated fits by SciPy scatter by."""

import numpy as np
import pytest
from benchmarks.others.bound import (
    RATIOS,
    ZERO_KNOWN,
    Levels,
    Swing,
    refit,
    remaining,
    simulate,
    smallest_errors,
)
from scipy.optimize import least_squares

TRUE = dict(zip(RATIOS, (26.0, 6.2, 0.78), strict=True))
NOISE = Levels(np.radians(0.3), 0.01)
REPEATS = 60


def swing(ratios=TRUE, start=(-0.2, -0.3), *, gyro=False, rate=60.0, duration=5.0):
    """Without noise."""
    time = 0.004 + np.arange(0, duration, 1 / rate)
    none = np.array([])
    empty = Swing(time, none, time if gyro else none, none, start)
    shown = simulate(np.array([ratios[k] for k in RATIOS]), 0.0, np.array(start), empty)
    return Swing(time, shown[: time.size], empty.gyro_time, shown[time.size :], start)


@pytest.mark.proof
def test_repeated_fits_scatter_by_the_smallest_errors():
    clean = [swing(), swing(start=(-0.7, 0.0))]
    bound = smallest_errors(TRUE, clean, NOISE)
    rng = np.random.default_rng(0)
    found = []
    for _ in range(REPEATS):
        zero = rng.normal(0, ZERO_KNOWN)
        noisy = [
            Swing(
                s.time,
                s.angle + zero + rng.normal(0, NOISE.angle, s.time.size),
                s.gyro_time,
                s.velocity,
                s.start,
            )
            for s in clean
        ]

        def rest(x, noisy=noisy):
            return remaining(x[:3], x[3], x[4:].reshape(-1, 2), noisy, NOISE)

        first = np.array([*TRUE.values(), 0.0, -0.2, -0.3, -0.7, 0.0])
        found.append(least_squares(rest, first, x_scale=np.maximum(np.abs(first), 0.1)).x[:3])
    errors = np.array(found) - list(TRUE.values())
    scatter = np.sqrt(np.mean(errors**2, axis=0))
    # a standard deviation from 60 draws is known to 9 %: three of these
    np.testing.assert_allclose(scatter, list(bound.values()), rtol=0.28)


def test_more_drops_and_a_gyro_tell_more():
    one = smallest_errors(TRUE, [swing()], NOISE)
    two = smallest_errors(TRUE, [swing(), swing(start=(-0.7, 0.0))], NOISE)
    sensed = smallest_errors(TRUE, [swing(gyro=True)], NOISE)
    for name in RATIOS:
        assert two[name] < one[name]
        assert sensed[name] < one[name]


def test_half_the_noise_is_half_the_error_of_damping():
    # the ratio of damping hardly rests on the zero, whose prior does not shrink
    fine = smallest_errors(TRUE, [swing()], Levels(NOISE.angle / 2, NOISE.velocity))
    coarse = smallest_errors(TRUE, [swing()], NOISE)
    assert fine[RATIOS[2]] == pytest.approx(coarse[RATIOS[2]] / 2, rel=0.02)


def test_a_refit_finds_another_leg_of_eq_9_and_leaves_nothing():
    near = dict(zip(RATIOS, (25.7, 6.5, 0.80), strict=True))
    found = refit(near, [swing(gyro=True), swing(start=(-0.7, 0.0), gyro=True)], NOISE)
    assert found.left < 0.1
    for name in RATIOS:
        assert found.ratios[name] == pytest.approx(TRUE[name], rel=1e-3)


def test_a_motion_that_runs_away_is_infinitely_far_from_what_was_measured():
    driven = np.array([26.0, 6.2, -5e3])  # 1/s, so much that it overflows within a second
    left = remaining(driven, 0.0, np.array([[-0.2, -0.3]]), [swing(gyro=True)], NOISE)
    assert left @ left == np.inf
