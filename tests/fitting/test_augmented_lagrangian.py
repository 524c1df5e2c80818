"""Small problems whose constrained minima are known."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import minimize as scipy_minimize

from exoid.fitting.solve.augmented_lagrangian import minimise

TARGET = jnp.array([2.0, 1.0])
TOLERANCE = 1e-6  # of the residuals; a point is wrong by about as much
CLOSE = 1e-5


@partial(jax.jit, static_argnums=(0, 1))
def compiled(residual, constraint, start, penalty, rounds):
    return minimise(
        lambda y: (residual(y), 3 * y),
        constraint,
        start,
        jnp.full(constraint(start).shape, penalty),
        tolerance=jnp.asarray(TOLERANCE),
        rounds=rounds,
    )


def solved(residual, constraint, start, penalty=100.0, rounds=10):
    begin = jnp.asarray(start, float)
    return compiled(residual, constraint, begin, jnp.asarray(penalty), jnp.asarray(rounds))


def away(y):
    return y - TARGET


def bounded(y):
    return y[:1] - 1.0


def in_disc(y):
    return jnp.array([y @ y - 1.0])


def test_an_inactive_constraint_has_no_multiplier_and_changes_nothing():
    found = solved(away, lambda y: y[:1] - 3.0, (0.0, 0.0))
    assert np.allclose(found.point, TARGET, atol=CLOSE)
    assert np.all(found.multiplier == 0)
    assert float(found.violation) == pytest.approx(-1.0, abs=CLOSE)


def test_an_active_bound_is_met_and_its_multiplier_is_the_force_on_it():
    """Stationary where y - (2, 1) + mu (1, 0) = 0 with y_0 = 1: mu = 1."""
    found = solved(away, bounded, (0.0, 0.0))
    assert np.allclose(found.point, (1.0, 1.0), atol=CLOSE)
    assert float(found.multiplier[0]) == pytest.approx(1.0, abs=1e-4)
    assert abs(float(found.violation)) < CLOSE


def test_two_active_constraints_are_met_together_beside_an_inactive_one():
    limits = jnp.array([1.0, 0.5, 9.0])
    found = solved(away, lambda y: jnp.array([y[0], y[1], y[0] + y[1]]) - limits, (0, 0))
    assert np.allclose(found.point, (1.0, 0.5), atol=CLOSE)
    assert np.allclose(found.multiplier, (1.0, 0.5, 0.0), atol=1e-4)


def test_a_curved_constraint_is_met_from_outside():
    """The point of the unit disc nearest to (2, 1); mu = (sqrt 5 - 1) / 2 in y - t + 2 mu y = 0."""
    found = solved(away, in_disc, (3.0, -2.0))
    assert np.allclose(found.point, TARGET / np.sqrt(5), atol=CLOSE)
    assert float(found.multiplier[0]) == pytest.approx((np.sqrt(5) - 1) / 2, abs=1e-4)


def test_the_penalty_changes_the_way_but_not_the_end():
    ends = [
        solved(away, in_disc, (0.0, 0.0), rho, rounds=40).point for rho in (10.0, 100.0, 1000.0)
    ]
    assert np.allclose(ends[0], ends[1], atol=CLOSE)
    assert np.allclose(ends[2], ends[1], atol=CLOSE)


def test_one_round_leaves_the_error_of_a_penalty_and_more_remove_it():
    """y_0 = 1 + 1 / (1 + rho) after the first round, that times 1 / (1 + rho) after each."""
    errors = [abs(float(solved(away, bounded, (0.0, 0.0), 9.0, n).point[0]) - 1) for n in (1, 2, 3)]
    assert np.allclose(errors, (0.1, 0.01, 0.001), rtol=1e-3)


def test_a_curved_valley_under_two_constraints_ends_where_slsqp_does():
    def rosenbrock(y):
        return jnp.array([10 * (y[1] - y[0] ** 2), 1 - y[0]])

    def limits(y):
        return jnp.array([y @ y - 1.0, y[0] + y[1] - 1.1])

    found = solved(rosenbrock, limits, (-1.0, 0.5), rounds=30)
    reference = scipy_minimize(
        lambda y: float(rosenbrock(y) @ rosenbrock(y)) / 2,
        (-1.0, 0.5),
        method="SLSQP",
        constraints={"type": "ineq", "fun": lambda y: -np.asarray(limits(y))},
        options={"ftol": 1e-14, "maxiter": 500},
    )
    assert reference.success
    assert np.allclose(found.point, reference.x, atol=1e-4)
    assert not bool(found.exhausted)


def test_the_detail_belongs_to_the_end_point():
    found = solved(away, bounded, (0.0, 0.0))
    assert np.allclose(found.detail, 3 * found.point, atol=3 * CLOSE)
