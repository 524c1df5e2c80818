"""A leg that is at rest or in a hand: when does it come to rest, and when is it let go?"""

from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Bool, Float, Int

from exoid.online.filter.motion import view
from exoid.online.filter.pack import where_so
from exoid.online.filter.select import select
from exoid.online.filter.whiteness import nothing_seen
from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase
from exoid.online.model.unknowns import AT
from exoid.online.movement.knowledge import NEVER, Course, Knowledge, Recent
from exoid.online.movement.stream import window

REST = 0.5  # s, in which a leg that still swings by a degree goes farther than it may
STILL = np.radians(0.7)  # rad that a leg at rest goes in that time: a hand trembles
SCATTER = 9.0  # deviations of an angle: twice what those of that time are apart, a hand beside
SEEN = 0.9  # of that time that must have been seen
DEPARTED = np.radians(2.0)  # rad from its hold
LEAVING = np.radians(0.4)  # rad, there the hand begins to let go
BEYOND = 3.0  # deviations of an angle, beyond which it is not where it was
PULL = 1.0  # rad/s^2, by which a leg that is let go falls at least: one that hangs is lifted
LETTING_GO = 0.08  # s that a hand takes to be off the leg


def at_rest(recent: Recent, noise: Any) -> tuple[Bool[Array, ""], Float[Array, ""]]:
    """Has the leg been still for a while, as far as an angle of that variance tells, and where?"""
    inside = window(recent, REST)
    time, angle = recent.rows[:, 0], recent.rows[:, 1]
    span = spread(time, inside)
    mean = jnp.sum(jnp.where(inside, angle, 0.0)) / jnp.maximum(jnp.sum(inside), 1)
    return (spread(angle, inside) < least(STILL, SCATTER, noise)) & (span > SEEN * REST), mean


def least(width: float, deviations: float, noise: Any) -> Float[Array, ""]:
    """A width [rad] that an angle of that variance can tell."""
    return jnp.maximum(width, deviations * jnp.sqrt(noise))


def departed(noise: Any) -> Float[Array, ""]:
    """How far a leg is from its hold that has left it [rad]."""
    return least(DEPARTED, SCATTER, noise)


def spread(values: Float[Array, " row"], inside: Bool[Array, " row"]) -> Float[Array, ""]:
    """The greatest less the smallest of those inside."""
    high = jnp.max(jnp.where(inside, values, -jnp.inf))
    return high - jnp.min(jnp.where(inside, values, jnp.inf))


def watch(model: Model, belief: Knowledge) -> Knowledge:
    """A sample while nothing moves freely."""
    still, place = at_rest(belief.recent, belief.sensing.angle)
    waiting = belief.phase == Phase.WAITING
    hold = jnp.where(still, place, belief.hold)
    away = departure(belief.recent, belief.hold) > departed(belief.sensing.angle)
    left = waiting & away & ~still
    phase = jnp.where(still, int(Phase.WAITING), belief.phase)
    suspected = jnp.where(still, NEVER, belief.verdict.suspected)
    verdict = replace(belief.verdict, suspected=suspected)
    watched = replace(belief, hold=hold, phase=phase, verdict=verdict)
    return where_so(left, lambda now: gone(model, now), watched)


def gone(model: Model, belief: Knowledge) -> Knowledge:
    """The leg has left its hold: the way that it would fall if it was let go, or in a hand.

    How stiff its knee is no table tells: before a drop has told it, it falls whether slack or not.
    """
    recent = belief.recent
    last = recent.rows[(recent.heard - 1) % recent.rows.shape[0]]
    held = belief.filters.mean[0].at[-2].set(belief.hold).at[-1].set(0.0)
    slack = jnp.where(belief.verdict.drops > 0, held, held.at[AT["stiffness"]].set(0.0))
    falls = [view(model.unknowns, row, Sample(*last)).acceleration for row in (held, slack)]
    away = (jnp.sign(last[1] - belief.hold) * jnp.stack(falls) > PULL).all()
    phase = jnp.full_like(belief.phase, int(Phase.HELD))
    return select(away, let_go(belief), replace(belief, phase=phase))


def departure(recent: Recent, hold: Float[Array, ""]) -> Float[Array, ""]:
    """How far both of the last two samples are from the hold: one alone may be a spike."""
    return jnp.min(jnp.abs(last_two(recent) - hold))


def last_two(recent: Recent) -> Float[Array, "2"]:
    """The angles of the last two samples [rad]."""
    rows = recent.rows.shape[0]
    return jnp.stack([recent.rows[(recent.heard - back) % rows, 1] for back in (1, 2)])


def let_go(belief: Knowledge) -> Knowledge:
    """A movement begins: the filters are to see it from where the hand is off the leg."""
    time, angle = belief.recent.rows[:, 0], belief.recent.rows[:, 1]
    near = jnp.abs(angle - belief.hold) < least(LEAVING, BEYOND, belief.sensing.angle)
    left = jnp.max(jnp.where(near, time, -jnp.inf))
    return moving_since(belief, left + LETTING_GO, jnp.zeros_like(belief.course.late))


def moving_since(belief: Knowledge, begun: Float[Array, ""], late: Int[Array, ""]) -> Knowledge:
    """A movement that began at a time [s], `late` as the leg turned or else from its hold."""
    recent = belief.recent
    behind = jnp.sum(recent.rows[:, 0] >= begun)
    course = Course(
        begun=begun,
        reached=begun,
        ended=begun,
        torque=jnp.zeros(()),
        opened=jnp.asarray(False),
        whiteness=nothing_seen(),
        likelihood=jnp.zeros(2),
        astray=jnp.zeros_like(belief.course.astray),
        direction=jnp.zeros(()),
        turns=late * (belief.course.turns % 2),  # even where it is to go down
        late=late,
        quick=late * belief.course.quick,
        top=belief.hold,
        scatter=belief.scatter,
        rested=belief.verdict.rests,
    )
    first = jax.tree.map(
        lambda known, new: jnp.stack([known[0], new]), belief.filters, belief.prior
    )
    return replace(
        belief,
        phase=jnp.full_like(belief.phase, int(Phase.MOVING)),
        verdict=replace(belief.verdict, suspected=jnp.full_like(belief.verdict.suspected, NEVER)),
        filters=first,
        before=jax.tree.map(lambda both: both[0], belief.filters),
        course=course,
        recent=replace(recent, absorbed=recent.heard - behind),
    )


def begun(belief: Knowledge) -> Knowledge:
    """A record begins with the last sample: the leg is held there, or falls already."""
    recent = belief.recent
    hold = recent.rows[(recent.heard - 1) % recent.rows.shape[0], 1]
    return replace(belief, phase=np.full_like(belief.phase, int(Phase.WAITING)), hold=hold)
