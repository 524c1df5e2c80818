"""How a free movement ends: at rest, in a hand, or because it was none."""

from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Bool

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.pack import where_so
from exoid.online.filter.select import select
from exoid.online.filter.whiteness import fails, judged, unwhite
from exoid.online.model.trust import Phase
from exoid.online.movement.evidence import EVIDENCE, evidence
from exoid.online.movement.knowledge import NEVER, Knowledge
from exoid.online.movement.watch import SCATTER, at_rest, departed, last_two, least

CAUGHT = 3  # samples in a row that are no leg's
SHORTEST = 0.4  # s of a movement that counts
SWINGS = 2  # turns of a leg that a hand or a muscle may not have led: those go there and back
SUDDEN = 3.5  # standard deviations: what was white until just now fails for a hand, not for a model
SWUNG = 2  # turns after its end by which a movement was no hand's, but one that nobody explained
PROVEN = 6  # turns that the model explained: smaller swings have nothing that those had not
LIFTED = np.radians(5.0)  # rad up from its last turn: more than a reflex adds to a swing


def ended(belief: Knowledge, torn: Bool[Array, ""]) -> Knowledge:
    """Is the movement over, and did it count?"""
    course = belief.course
    still, place = at_rest(belief.recent, belief.sensing.angle)
    gone = still & (jnp.abs(place - belief.hold) > departed(belief.sensing.angle))
    failing = fails(course.whiteness)[1]
    cut = (course.astray >= CAUGHT) | torn
    over = still | failing | cut
    return where_so(over, lambda now: closed(now, gone, failing, cut, torn), belief)


def closed(belief: Knowledge, gone, failing, cut, torn) -> Knowledge:
    """The movement is over: the belief with what it told, or without."""
    course, older = belief.course, belief.older
    sound = jnp.where(failing | cut, older.unwhite < SUDDEN, True)
    end = jnp.where(failing | cut, older.time, course.reached)
    swings = jnp.where(failing | cut, older.turns, course.turns) >= SWINGS + course.late
    free = swings | (gone & (course.late == 0) & (unwhite(course.whiteness)[1] < SUDDEN))
    counts = sound & judged(course.whiteness) & (end - course.begun > SHORTEST) & free
    kept = select(failing | cut, older.filters, belief.filters)
    odds = jnp.where(failing | cut, older.evidence, evidence(course))
    known = select(counts, told(kept, odds), belief.before)
    doubted = (failing | cut & ~torn) & ~(counts & (older.turns >= PROVEN))
    return replace(
        belief,
        filters=with_known(belief.filters, known),
        course=replace(course, ended=end),
        scatter=jnp.where(counts, course.scatter, belief.scatter),
        phase=jnp.where(counts, int(Phase.DONE), int(Phase.HELD)),
        verdict=replace(
            belief.verdict,
            drops=belief.verdict.drops + counts,
            rests=jnp.where(counts & (odds > EVIDENCE), 0, course.rested) + counts,
            changed=belief.verdict.changed & ~counts,
            unexplained=belief.verdict.unexplained & ~(counts & (belief.verdict.drops > 0)),
            suspected=jnp.where(doubted, course.turns + SWUNG, NEVER),
        ),
    )


def told(filters: Gaussian, odds: Any) -> Gaussian:
    """What all drops told; the last one alone where that contradicts the others, by less than
    another leg would: legs differ from drop to drop, and what was known saw none of its samples.
    """
    return jax.tree.map(lambda both: jnp.where(odds > EVIDENCE, both[1], both[0]), filters)


def refuted(belief: Knowledge) -> Knowledge:
    """A movement that ended astray and swings on was no hand's: the model does not explain it.

    What was lifted since then tells nothing of that: it is another movement that goes on.
    """
    suspected = jnp.where(lifted(belief), NEVER, belief.verdict.suspected)
    now = replace(belief, verdict=replace(belief.verdict, suspected=suspected))
    return where_so(belief.course.turns >= suspected, unexplained, now)


def lifted(belief: Knowledge) -> Bool[Array, ""]:
    """Is the leg farther up than where it last turned, as none is that swings on and loses energy,
    whatever the model lacks? Up is where it was let go.
    """
    course = belief.course
    up = jnp.where(course.turns % 2 == 0, -course.direction, course.direction)
    least_way = least(LIFTED, SCATTER, belief.sensing.angle)
    return jnp.min(up * (last_two(belief.recent) - course.top)) > least_way


def unexplained(belief: Knowledge) -> Knowledge:
    """The belief without its last movement."""
    verdict = belief.verdict
    counted = belief.phase == Phase.DONE
    return replace(
        belief,
        filters=with_known(belief.filters, belief.before),
        phase=jnp.full_like(belief.phase, int(Phase.HELD)),
        verdict=replace(
            verdict,
            drops=verdict.drops - counted,
            rests=belief.course.rested,
            unexplained=jnp.asarray(True),
            suspected=jnp.full_like(verdict.suspected, NEVER),
        ),
    )


def first_of(filters: Gaussian) -> Gaussian:
    return jax.tree.map(lambda both: both[0], filters)


def with_known(filters: Gaussian, known: Gaussian) -> Gaussian:
    """The filters with what is known by all drops."""
    return jax.tree.map(lambda both, one: both.at[0].set(one), filters, known)
