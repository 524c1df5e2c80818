"""One sample more, and what is known then: the whole of a step, as it is compiled."""

from dataclasses import replace

import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.pack import where_so
from exoid.online.filter.read_out import off_the_seat, ratios, seated, slopes
from exoid.online.filter.select import select
from exoid.online.filter.whiteness import unwhite
from exoid.online.model.model import Goals, Model
from exoid.online.model.trust import Phase, Trust
from exoid.online.movement.change import changed
from exoid.online.movement.end import SHORTEST, SWINGS, ended, first_of, refuted
from exoid.online.movement.evidence import evidence
from exoid.online.movement.follow import follow
from exoid.online.movement.knowledge import NEVER, Knowledge
from exoid.online.movement.late import begun_late, judged_late
from exoid.online.movement.stream import heard, is_faulty, look
from exoid.online.movement.turns import turned
from exoid.online.movement.watch import watch
from exoid.online.outlook import Outlook


def take_in(model: Model, belief: Knowledge, row: Float[Array, " 6"]) -> tuple[Knowledge, Outlook]:
    """The belief after one more sample (a row of `Sample`), and what it says."""
    row = finite(row)
    arrived = look(belief.recent, belief.stream, row, belief.sensing.period)
    torn = arrived.torn
    moving = belief.phase == Phase.MOVING
    cut = where_so(moving & torn, lambda now: over(model, now, torn), belief)
    lost = where_so(torn, forgetting, cut)
    now = replace(lost, recent=heard(lost.recent, row, arrived), stream=arrived.stream)
    now = replace(now, course=turned(now, row[2]))
    free = now.phase == Phase.MOVING
    now = where_so(arrived.taken & free, lambda at: moved(model, at), now)
    now = where_so(arrived.taken & ~free, lambda at: watched(model, at), now)
    return now, outlook(model, now)


def finite(row: Float[Array, " 6"]) -> Float[Array, " 6"]:
    """The sample with NaN for what is no number; nothing was seen where nobody knows the load."""
    told = jnp.where(jnp.isfinite(row), row, jnp.nan)
    loaded = ~jnp.isnan(told[3:]).any()
    seen = jnp.where(loaded, told[1:3], jnp.nan)
    return jnp.concatenate([told[:1], seen, jnp.where(jnp.isnan(told[3:]), 0.0, told[3:])])


def forgetting(belief: Knowledge) -> Knowledge:
    """Nobody knows what a hand did in a gap."""
    never = jnp.full_like(belief.verdict.suspected, NEVER)
    return replace(
        belief,
        phase=jnp.full_like(belief.phase, int(Phase.HELD)),
        verdict=replace(belief.verdict, suspected=never),
    )


def moved(model: Model, belief: Knowledge) -> Knowledge:
    """A sample of a free movement."""
    return over(model, changed(model, follow(model, belief)), jnp.asarray(False))


def watched(model: Model, belief: Knowledge) -> Knowledge:
    """A sample while nothing moves freely, as far as is known."""
    return begun_late(model, refuted(watch(model, belief)))


def over(model: Model, belief: Knowledge, torn: Bool[Array, ""]) -> Knowledge:
    """The belief after the movement, where it is over."""
    return judged_late(model, ended(belief, torn))


def outlook(model: Model, belief: Knowledge) -> Outlook:
    """What the belief says."""
    known = shown(belief)
    on_seat = seated(known, model.node)
    values, errors = ratios(on_seat)
    slope = slopes(on_seat.level.mean)
    told = on_seat.told(slope)
    contradicted = off_the_seat(known, model.node)
    return Outlook(
        trust=trust(model.goals, belief, values, (errors, told), contradicted),
        phase=belief.phase,
        drops=belief.verdict.drops,
        rests=belief.verdict.rests,
        ratios=values,
        errors=errors,
        if_slack=jnp.zeros(3) if model.unknowns.pushed else on_seat.if_slack(slope),
        begun=belief.course.begun,
        ended=belief.course.ended,
        unwhite=unwhite(belief.course.whiteness)[1],
        change=evidence(belief.course),
        late=belief.course.late,
    )


def shown(belief: Knowledge) -> Gaussian:
    """What all movements told that are no hand's: the present one once it swings."""
    course, known = belief.course, first_of(belief.filters)
    few = (course.turns < SWINGS) | (course.reached - course.begun < SHORTEST)
    may_be_a_hand = few | (course.late > 0)
    return select((belief.phase == Phase.MOVING) & may_be_a_hand, belief.before, known)


def trust(goals: Goals, belief: Knowledge, values, errors, contradicted):
    """How far to believe it; the worst that is to be said comes last. Of the `errors` the first are
    all, the second what more drops would make smaller.
    """
    verdict = belief.verdict
    gravity = jnp.abs(values[0])
    sizes = jnp.stack([gravity, gravity, jnp.sqrt(gravity)])
    share, left = (jnp.max(each / sizes) for each in errors)
    begun = (verdict.drops > 0) | (belief.phase == Phase.MOVING)
    said = jnp.where(begun, int(Trust.LEARNING), int(Trust.WAITING))
    said = jnp.where(begun & (share < goals.good), int(Trust.GOOD), said)
    said = jnp.where((verdict.drops > 0) & (left < goals.enough), int(Trust.ENOUGH), said)
    said = jnp.where(verdict.unexplained, int(Trust.UNEXPLAINED), said)
    said = jnp.where(verdict.changed, int(Trust.CHANGED), said)
    said = jnp.where(begun & contradicted, int(Trust.UNEXPLAINED), said)
    return jnp.where(is_faulty(belief.stream), int(Trust.FAULTY), said)
