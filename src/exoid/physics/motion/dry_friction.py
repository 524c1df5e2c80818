"""How dry friction turns over with the leg within a step.

A step goes the way in which it begins, with friction against it. Where the leg comes to rest
within, it turns back in what is left of the step: by what pulls at it less the friction, which now
acts the other way, or stays where that is more. The error of a turn is of third order in the step.
"""

from typing import Any

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.state import LegState


def turned(
    begin: LegState, end: LegState, sense: Any, levels: tuple[Any, Any], step: Any
) -> LegState:
    """The end of a step of a leg that went the way of `sense`, friction of these `levels` [rad/s^2]
    at its begin and its end against it, to where it would be without a turn.
    """
    ahead = sense * begin.angular_velocity
    slowing = (ahead - sense * end.angular_velocity) / step
    turns = ahead < step * slowing
    later = step - ahead / jnp.where(turns, slowing, 1.0)
    back = jnp.maximum(slowing - sum(levels), 0.0)  # rad/s^2, after the turn
    more = jnp.where(turns, sense * (slowing - back), 0.0)
    return LegState(end.angle + more * later**2 / 2, end.angular_velocity + more * later)


def sense_of(rate: Any, pulled: Any) -> Float[Array, ""]:
    """The way a leg goes: 1 or -1; at rest the other one than it is `pulled`, so that it turns at
    once.
    """
    return jnp.where(rate == 0, -jnp.sign(pulled), jnp.sign(rate))
