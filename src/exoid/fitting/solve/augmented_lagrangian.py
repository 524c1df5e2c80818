"""Least squares under constraints: the constraints enter as extra residuals.

minimise |r(y)|^2 / 2 subject to g(y) <= 0, by minimising |r|^2/2 + |p|^2/2 with
p = sqrt(rho) max(0, g + mu / rho) and updating mu <- max(0, mu + rho g) until it stands still
(Hestenes 1969, Powell 1969, Rockafellar 1973; Nocedal & Wright, Numerical Optimization, ch. 17).
"""

from collections.abc import Callable

import jax
import jax.numpy as jnp
import optimistix as optx
from jaxtyping import Array, Bool, Float, Int, PyTree

from exoid.fitting.solve.least_squares import NegligibleStep, levenberg_marquardt
from exoid.physics.record import record

Vector = Float[Array, " _"]

SLOW = 0.25  # of the error before: a round that gains less
STIFFER = 10.0  # makes that constraint's penalty so much greater ...
STUCK = 1e3  # ... or so much, where it did not move the point at all, as at a crease
STEPS = 60  # of the inner solver; a start that needs more has lost its way
FEASIBLE = 1e-5  # greatest g that counts as met; g is relative
ROUNDING = 1e-14  # of the greatest derivative of a residual


@record
class Outcome:
    """Where a start ended. `failed` marks a point that must never be chosen."""

    point: Vector
    detail: PyTree  # what `residual` gave beside its value, at `point`
    multiplier: Vector
    violation: Float[Array, ""]  # greatest of g, relative as in `violations`
    steps: Int[Array, ""]  # evaluations of the residual
    exhausted: Bool[Array, ""]  # the inner solver ran out of steps


def minimise(
    residual: Callable[[Vector], tuple[Vector, PyTree]],
    constraint: Callable[[Vector], Vector],
    start: Vector,
    penalty: Vector,
    *,
    tolerance: Float[Array, ""],
    rounds: Int[Array, ""],
) -> Outcome:
    """At most `rounds` updates of the multipliers, each with one inner least-squares solve.

    `residual` returns its value and any detail worth keeping of the last point. `penalty` is rho:
    taken as 100 over the variance of each g, it gains two digits a round. Where it gains less,
    because other constraints hold that variance down, it grows; and where a g is not met and no
    residual minds, as of a limit of what no sample tells.
    """

    def penalised(point, weighed):
        multiplier, rho = weighed
        excess = jnp.maximum(0.0, constraint(point) + multiplier / rho)
        value, detail = residual(point)
        return jnp.concatenate([value, jnp.sqrt(rho) * excess]), detail

    inner = levenberg_marquardt()

    def update(carry):
        outcome, rho, error, number, _ = carry
        solution = optx.least_squares(
            with_dense_derivative(penalised),
            NegligibleStep(inner=inner, tolerance=tolerance),
            outcome.point,
            args=(outcome.multiplier, rho),
            has_aux=True,
            max_steps=STEPS,
            throw=False,
        )
        value = constraint(solution.value)
        multiplier = jnp.maximum(0.0, outcome.multiplier + rho * value)
        # How far g <= 0 <= mu, g mu = 0 are from true; sqrt(rho) of it is in units of noise, as
        # the tolerance is.
        remaining = jnp.abs(multiplier - outcome.multiplier) / rho
        apart = jnp.sqrt(rho) * remaining > tolerance
        following = Outcome(
            point=solution.value,
            detail=solution.aux,
            multiplier=multiplier,
            violation=value.max(),
            steps=outcome.steps + solution.stats["num_steps"],
            exhausted=solution.result == optx.RESULTS.nonlinear_max_steps_reached,
        )
        slow = apart & (remaining > SLOW * error)
        still = jnp.all(solution.value == outcome.point)
        unminded = ~apart & (value > FEASIBLE)
        stiffer = jnp.where(slow, jnp.where(still, STUCK, STIFFER), 1.0) * rho
        stiffer = jnp.where(unminded, STUCK * rho, stiffer)
        unsettled = (apart.any() & ~still) | (value.max() > FEASIBLE)
        return following, stiffer, remaining, number + 1, unsettled

    nothing = jnp.zeros_like(penalty)
    detail = jax.tree.map(
        lambda leaf: jnp.zeros(leaf.shape, leaf.dtype), jax.eval_shape(residual, start)[1]
    )
    before = Outcome(start, detail, nothing, jnp.array(jnp.inf), jnp.array(0), jnp.array(False))
    carry = before, penalty, jnp.full_like(penalty, jnp.inf), jnp.array(0), jnp.array(True)
    outcome, *_ = jax.lax.while_loop(
        lambda carry: (carry[3] < rounds) & carry[4], update, of_each(start, carry)
    )
    return outcome


def of_each(start: Vector, carry: PyTree) -> PyTree:
    """The same, as if it hung on the start: where many start at once, JAX traces a loop again and
    again until it knows all that its steps make different for each.
    """
    own = jnp.isnan(start[0])
    return jax.tree.map(lambda leaf: jnp.where(own, leaf, leaf), carry)


def with_dense_derivative(function):
    """The same function, its derivative held as one matrix.

    A solver's loop carries what the derivative is made of from step to step: one array instead of
    the dozens that the pieces of a residual leave behind, which would double the compiled program.
    Of what a residual does not depend on rounding is left: along it a step would go anywhere.
    """

    def evaluated(point, args):
        here = jax.lax.stop_gradient(point)
        value, push, detail = jax.linearize(lambda x: function(x, args), here, has_aux=True)
        matrix = jax.vmap(push, out_axes=1)(jnp.eye(here.size))
        size = jnp.abs(matrix)
        matrix = jnp.where(size > ROUNDING * size.max(axis=1, keepdims=True), matrix, 0.0)
        return value + matrix @ (point - here), detail

    return evaluated
