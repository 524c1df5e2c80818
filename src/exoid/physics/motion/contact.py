"""Instants at which something meets and a torque jumps, as a leg and its stop."""

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float, PyTree

CLOSE = 1e-5  # rad: what is nearer meets, unless it is about to
Scalar = Float[Array, ""]
Gaps = Callable[[PyTree], list[tuple[Scalar, Scalar]]]  # how far, and how fast that grows


def until_contact(gaps: Gaps, rate: Callable[[PyTree], PyTree], state: PyTree, longest: Any):
    """The time [s] until a gap closes, by its speed and acceleration; at most `longest`."""
    ahead = jax.tree.map(lambda now, slope: now + longest * slope, state, rate(state))
    until = longest
    for (gap, opening), (_, later) in zip(gaps(state), gaps(ahead), strict=True):
        under = opening**2 - 2 * gap * (later - opening) / longest
        root = jnp.sqrt(jnp.maximum(under, 0.0)) - opening
        meets = (gap > CLOSE) & (under > 0) & (root > 0)
        until = jnp.minimum(until, jnp.where(meets, 2 * gap / jnp.where(meets, root, 1.0), until))
    return until


def met(gaps: Gaps, rate: Callable[[Array, PyTree], PyTree], state: PyTree) -> PyTree:
    """The same state where something has just met, with the derivatives that it has after that:
    what came earlier is moved by the new torque for longer (the saltation matrix).

    `rate(slack, state)` takes gaps below `slack` for closed.
    """
    still = jax.lax.stop_gradient
    sooner = jnp.zeros(())
    for gap, opening in gaps(state):
        meets = (jnp.abs(gap) < CLOSE) & (opening < 0)
        sooner += (gap - still(gap)) / jnp.where(meets, still(opening), jnp.inf)
    rates = jax.vmap(rate, (0, None))(jnp.array([CLOSE, -CLOSE]), state)
    return jax.tree.map(lambda now, new: now + sooner * still(new[0] - new[1]), state, rates)
