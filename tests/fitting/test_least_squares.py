"""Where the solver stops: not before the step is negligible, and not long after."""

from functools import partial

import equinox as eqx
import jax
import jax.numpy as jnp
import lineax as lx
import numpy as np
import optimistix as optx
import pytest

from exoid.fitting.solve.least_squares import HasteningTrustRegion, NegligibleStep

TIME = jnp.linspace(0, 2, 20)
MEASURED = 3 * jnp.exp(-1.5 * TIME)


@partial(jax.jit, static_argnums=(0, 3))
def compiled(residual, start, tolerance, hastening=True):
    inner = optx.LevenbergMarquardt(1e-14, 1e-14, linear_solver=lx.Normal(lx.Cholesky()))
    if hastening:
        inner = eqx.tree_at(lambda solver: solver.search, inner, HasteningTrustRegion())
    end = optx.least_squares(
        lambda y, _: residual(y),
        NegligibleStep(inner, tolerance),
        start,
        max_steps=200,
        throw=False,
    )
    return end.value, end.result == optx.RESULTS.successful, end.stats["num_steps"]


def solved(residual, start, tolerance, *, hastening=True):
    """The end point, whether it was reached, and the number of steps that were tried."""
    start, tolerance = jnp.asarray(start, float), jnp.asarray(tolerance)
    value, done, steps = compiled(residual, start, tolerance, hastening)
    return value, bool(done), int(steps)


def decay(y):
    return y[0] * jnp.exp(-y[1] * TIME) - MEASURED


def test_at_the_end_no_residual_would_change_by_more_than_the_tolerance():
    for tolerance in (1e-1, 1e-3, 1e-6):
        value, done, _ = solved(decay, (1.0, 0.2), tolerance)
        assert done
        assert np.abs(decay(value)).max() < 3 * tolerance  # the first order is not all


def test_a_finer_tolerance_takes_more_steps():
    counts = [solved(decay, (1.0, 0.2), tolerance)[2] for tolerance in (1e-1, 1e-4, 1e-9)]
    assert counts[0] < counts[1] < counts[2]


def test_a_start_at_the_minimum_is_left_at_once():
    value, done, steps = solved(decay, (3.0, 1.5), 1e-6)
    assert done
    assert steps == 1
    assert np.array_equal(value, [3.0, 1.5])


def test_no_step_is_taken_where_every_step_is_negligible():
    value, _, steps = solved(decay, (1.0, 0.2), np.inf)
    assert steps == 1
    assert np.array_equal(value, [1.0, 0.2])


def test_an_optimum_with_a_residual_that_stays_is_recognised():
    """The loss there changes by rounding alone, and its decrease says nothing."""

    def residual(y):
        return jnp.array([1e3, y[0] - 1, 1e-3 * (y[0] ** 2 - 4)])

    value, done, steps = solved(residual, (9.0,), 1e-9)
    assert done
    assert steps < 30
    x = float(value[0])
    assert (x - 1) + 2e-6 * x * (x**2 - 4) == pytest.approx(0.0, abs=1e-8)


def test_steps_that_were_shortened_by_rejections_do_not_end_the_search():
    """Gauss-Newton overshoots on arctan beyond 1.39; after rejections its steps are short."""

    def far(y):
        return 100 * jnp.arctan(3 * (y - 2.0))

    start = jnp.array([-2.0])
    step = -far(start) / jax.jacfwd(far)(start)[0]
    assert abs(far(start + step)[0]) > abs(far(start)[0])  # so the first step is rejected
    value, done, _ = solved(far, (-2.0,), 1e-6)
    assert done
    assert float(value[0]) == pytest.approx(2.0, abs=1e-6)


def creased(y):
    """Least at 0, though the derivative there leads on: dry friction holds a leg a step sooner."""
    return 1e3 * jnp.where(y < 0, 1 - y, 1 + y)


def test_where_every_step_fails_a_search_ends_sooner_where_rejections_hasten():
    ends = [solved(creased, (0.0,), 1e-2, hastening=each) for each in (True, False)]
    for value, done, _ in ends:
        assert done
        assert value[0] == 0
    assert ends[0][2] <= 0.7 * ends[1][2]


def test_where_no_step_fails_nothing_hastens():
    for tolerance in (1e-1, 1e-6):
        quick, usual = (solved(decay, (1.0, 0.2), tolerance, hastening=h) for h in (True, False))
        assert np.array_equal(quick[0], usual[0])
