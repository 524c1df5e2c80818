"""Where the solver stops: not before the step is negligible, and not long after."""

import jax.numpy as jnp
import lineax as lx
import numpy as np
import optimistix as optx
import pytest

from exoid.fit.least_squares import NegligibleStep

TIME = jnp.linspace(0, 2, 20)
MEASURED = 3 * jnp.exp(-1.5 * TIME)


def solved(residual, start, tolerance, steps=200):
    inner = optx.LevenbergMarquardt(1e-14, 1e-14, linear_solver=lx.Normal(lx.Cholesky()))
    return optx.least_squares(
        lambda y, _: residual(y),
        NegligibleStep(inner, jnp.asarray(tolerance)),
        jnp.asarray(start, float),
        max_steps=steps,
        throw=False,
    )


def decay(y):
    return y[0] * jnp.exp(-y[1] * TIME) - MEASURED


def test_at_the_end_no_residual_would_change_by_more_than_the_tolerance():
    for tolerance in (1e-1, 1e-3, 1e-6):
        end = solved(decay, (1.0, 0.2), tolerance)
        assert end.result == optx.RESULTS.successful
        assert np.abs(decay(end.value)).max() < 3 * tolerance  # the first order is not all


def test_a_finer_tolerance_takes_more_steps():
    counts = [int(solved(decay, (1.0, 0.2), t).stats["num_steps"]) for t in (1e-1, 1e-4, 1e-9)]
    assert counts[0] < counts[1] < counts[2]


def test_a_start_at_the_minimum_is_left_at_once():
    end = solved(decay, (3.0, 1.5), 1e-6)
    assert int(end.stats["num_steps"]) == 1
    assert np.array_equal(end.value, [3.0, 1.5])


def test_no_step_is_taken_where_every_step_is_negligible():
    end = solved(decay, (1.0, 0.2), np.inf)
    assert int(end.stats["num_steps"]) == 1
    assert np.array_equal(end.value, [1.0, 0.2])


def test_an_optimum_with_a_residual_that_stays_is_recognised():
    """The loss there changes by rounding alone, and its decrease says nothing."""
    end = solved(lambda y: jnp.array([1e3, y[0] - 1, 1e-3 * (y[0] ** 2 - 4)]), (9.0,), 1e-9)
    assert end.result == optx.RESULTS.successful
    assert int(end.stats["num_steps"]) < 30
    x = float(end.value[0])
    assert (x - 1) + 2e-6 * x * (x**2 - 4) == pytest.approx(0.0, abs=1e-8)


def test_steps_that_were_shortened_by_rejections_do_not_end_the_search():
    """Gauss-Newton overshoots on arctan beyond 1.39; damped to the bone, its steps are short."""

    def residual(y):
        return 1e-4 * jnp.arctan(1e3 * (y - 2.0))

    end = solved(residual, (1.9,), 1e-8)
    assert end.result == optx.RESULTS.successful
    assert float(end.value[0]) == pytest.approx(2.0, abs=1e-6)
    assert int(end.stats["num_steps"]) > int(end.stats["num_accepted_steps"])
