"""A leg of which a hand lets go slowly, and that then swings on: it is followed from a turn.

A hand takes much of what a fall gives while the leg is slow. A reflex, or a stop, takes it when the
leg is fast, and does so again: then the swings alone are not the leg's.
"""

from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.online.filter.motion import view
from exoid.online.filter.pack import where_so
from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase
from exoid.online.movement.end import SWUNG, unexplained
from exoid.online.movement.evidence import EVIDENCE, evidence
from exoid.online.movement.knowledge import Knowledge
from exoid.online.movement.stream import last
from exoid.online.movement.watch import moving_since

FIRST = 1  # turns at most, until which a hand that lets go slowly has led a leg
TAKEN = 0.25  # of what a fall gives a slow leg, that a hand takes at least: a reflex, a stop or dry
# friction take 0.2 of that by then
PARTS = 9  # places at which a fall is looked at


def begun_late(model: Model, belief: Knowledge) -> Knowledge:
    """What strayed in its first fall begins anew where the leg turns next, once, if a hand may have
    led it: before a drop has told the leg, tables tell how it falls.
    """

    def anew(one: Knowledge) -> Knowledge:
        return moving_since(one, last(one.recent)[0], jnp.ones_like(one.course.late))

    def looked_at(one: Knowledge) -> Knowledge:
        least = jnp.where(one.verdict.drops > 0, TAKEN, TAKEN / 2)
        return where_so(taken(model, one) > least, anew, one)

    return where_so(is_due(belief), looked_at, belief)


def is_due(belief: Knowledge) -> Bool[Array, ""]:
    course, suspected = belief.course, belief.verdict.suspected
    led = (suspected <= FIRST + SWUNG) & (course.late == 0)
    return led & (belief.phase == Phase.HELD) & (course.turns == suspected - SWUNG + 1)


def judged_late(model: Model, belief: Knowledge) -> Knowledge:
    """Without a movement that began late and counted, unless a hand led the fall before, and the
    leg is the one of the drops before.
    """
    course = belief.course
    counted = (belief.phase == Phase.DONE) & (course.late > 0)

    def looked_at(now: Knowledge) -> Knowledge:
        wrong = (evidence(now.course) > EVIDENCE) | (taken(model, now) < TAKEN)
        return where_so(wrong, unexplained, now)

    return where_so(counted, looked_at, belief)


def taken(model: Model, belief: Knowledge) -> Float[Array, ""]:
    """The share of what a fall gives, less the leg's own damping, that it lacked where the leg was
    no longer slow: from rest it would be as fast as v^2 / 2 = int phi'' dphi.
    """
    place, speed = belief.course.quick
    share = jnp.linspace(0.0, 1.0, PARTS)
    angle = belief.hold + share * (place - belief.hold)
    rate = jnp.sqrt(share) * speed  # as of a fall that is ever faster
    now = Sample(*last(belief.recent))

    def falling(angle: Any, rate: Any) -> Float[Array, ""]:
        row = belief.filters.mean[0].at[-2].set(angle).at[-1].set(rate)
        return view(model.unknowns, row, now).acceleration

    given = jnp.trapezoid(jax.vmap(falling)(angle, rate), angle)
    return jnp.where(speed == 0, 0.0, 1.0 - speed**2 / 2 / jnp.maximum(given, 1e-3))
