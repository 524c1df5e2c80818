"""Which way a leg moves, how often it has turned, and where: by the gyro, by angles without one."""

from dataclasses import replace
from typing import Any

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.online.model.unknowns import AT
from exoid.online.movement.knowledge import NEVER, Knowledge, Recent
from exoid.online.movement.stream import last, window

MOVES = 0.2  # rad/s beyond a gyro's bias: then a leg moves one way
SPAN = 0.1  # s of angles that tell a rate: no leg turns twice in it
QUICK = 2.0  # rad/s, half of what a leg is at most in a fall of 60 degrees
SURE = 4.0  # deviations of that rate, beyond which it is not the encoder's noise
SEEN = 0.4  # s within which a turn is seen, and less than a leg takes to the one before


def turned(belief: Knowledge, rate: Float[Array, ""]):
    """The movement's turns, seen whether the filters still follow it or not."""
    course = belief.course
    by_gyro = rate - belief.filters.mean[1, AT["gyro_bias"]]
    by_angles, deviation, middle = slope(belief.recent, belief.sensing.angle)
    alone = jnp.isnan(rate)
    speed = jnp.where(alone, by_angles, by_gyro)
    moves = jnp.where(alone, jnp.maximum(MOVES, SURE * deviation), MOVES)
    way = jnp.where(jnp.abs(speed) > moves, jnp.sign(speed), course.direction)
    turns = course.turns + ((way != course.direction) & (course.direction != 0))
    back = (turns > course.turns) & (turns % 2 == 0) & (belief.verdict.suspected == NEVER)
    top = jnp.where(back, farthest(belief.recent, -way), course.top)
    first = (course.turns + course.late == 0) & (course.quick[1] == 0)
    place = jnp.where(alone, middle, last(belief.recent)[1])
    quick = jnp.where(first & (jnp.abs(speed) > QUICK), jnp.stack([place, speed]), course.quick)
    return replace(course, direction=way, turns=turns, top=top, quick=quick)


def farthest(recent: Recent, way: Float[Array, ""]) -> Float[Array, ""]:
    """How far the leg went that way [rad] before it turned."""
    inside = window(recent, SEEN)
    return way * jnp.max(jnp.where(inside, way * recent.rows[:, 1], -jnp.inf))


def slope(recent: Recent, noise: Any) -> tuple[Float[Array, ""], Float[Array, ""], Any]:
    """Rate [rad/s] of the line through the last angles of that variance, its deviation, and its
    middle [rad].
    """
    inside = window(recent, SPAN)
    time, angle = (jnp.where(inside, recent.rows[:, at], 0.0) for at in (0, 1))
    count = jnp.maximum(jnp.sum(inside), 1)
    since = jnp.where(inside, time - jnp.sum(time) / count, 0.0)
    spread = jnp.sum(since**2)
    told = spread > 0
    weight = jnp.where(told, spread, 1.0)
    deviation = jnp.where(told, jnp.sqrt(noise / weight), jnp.inf)
    return jnp.sum(since * angle) / weight, deviation, jnp.sum(angle) / count
