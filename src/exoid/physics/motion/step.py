"""One step, and the only time loop: classical Runge-Kutta of order four."""

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float, Int, PyTree

STAGES = np.array([0.0, 0.5, 0.5, 1.0])  # of a step
SHARES = np.array([1.0, 2.0, 2.0, 1.0]) / 6  # of the mean slope


class Drive(eqx.Module):
    """The torque per inertia [rad/s^2] at the three stage times of every step."""

    begin: Float[Any, "*steps"]
    middle: Float[Any, "*steps"]
    end: Float[Any, "*steps"]


def march(
    advance: Callable[[Int[Array, ""], PyTree], PyTree],
    fold: Callable[[Int[Array, ""], PyTree, PyTree], PyTree],
    state: PyTree,
    folded: PyTree,
    steps: int | Int[Array, ""],
) -> PyTree:
    """The only time loop: `advance(index, state)` step by step, every state folded into a result.

    `fold(index, state, folded)` sees the states 0 to `steps`. A number of steps that is known only
    at run time lets one compiled program serve any length, but not reverse-mode derivatives.
    """

    def step(index, carry):
        now, gathered = carry
        following = advance(index, now)
        return following, fold(index + 1, following, gathered)

    return jax.lax.fori_loop(0, steps, step, (state, fold(jnp.array(0), state, folded)))[1]


def parabola(first: PyTree, middle: PyTree, last: PyTree, at: Any) -> PyTree:
    """What lies at a fraction of a step, through its begin, middle and end."""
    weights = (1 - at) * (1 - 2 * at), 4 * at * (1 - at), at * (2 * at - 1)
    return jax.tree.map(
        lambda *each: sum(weight * one for weight, one in zip(weights, each, strict=True)),
        first,
        middle,
        last,
    )


def rk4(
    rate: Callable[[PyTree, Any], PyTree],
    state: PyTree,
    step: Float[Array, "*batch"],
    *,
    compact: bool = False,
) -> PyTree:
    """One classical Runge-Kutta step of length `step` [s].

    `rate(state, at)` is the time derivative, `at` 0, 1/2 or 1 of the step. A `compact` one goes
    through its stages in a loop: it is compiled in half the time, and takes twice as long to run.
    """

    def moved(slope: PyTree, by: Float[Array, "*batch"]) -> PyTree:
        return jax.tree.map(lambda x, s: x + by * s, state, slope)

    def stage(number: Int[Array, ""], slopes: tuple[PyTree, PyTree]) -> tuple[PyTree, PyTree]:
        last, mean = slopes
        at, share = jnp.asarray(STAGES)[number], jnp.asarray(SHARES)[number]
        slope = rate(moved(last, at * step), at)
        return slope, jax.tree.map(lambda all, one: all + share * one, mean, slope)

    if compact:
        none = jax.tree.map(jnp.zeros_like, state)
        return moved(jax.lax.fori_loop(0, len(STAGES), stage, (none, none))[1], step)
    first = rate(state, 0.0)
    second = rate(moved(first, step / 2), 0.5)
    third = rate(moved(second, step / 2), 0.5)
    fourth = rate(moved(third, step), 1.0)
    mean = jax.tree.map(
        lambda a, b, c, d: (a + 2 * b + 2 * c + d) / 6, first, second, third, fourth
    )
    return moved(mean, step)
