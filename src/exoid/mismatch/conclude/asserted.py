"""What is certain: the causes that every explanation has which this recording cannot tell apart."""

from collections.abc import Sequence

import numpy as np

from exoid.mismatch.evidence.yardstick import FOLLOWED
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, blurred, causes, size
from exoid.mismatch.search.rank import alike, simpler_form
from exoid.physics.library import library
from exoid.physics.parameter import AT_AN_END, declarations
from exoid.physics.scale import ranged
from exoid.physics.term import SensorTerm, Term, name_of

PLAIN = 2  # numbers of a cause; with more a wrong one comes near sooner
SOFT = 0.1  # of the stiffness that the baseline saw, below which a leg has hardly any


def equivalents(found: Found, best: Optimum) -> list[Optimum]:
    """The explanations that this recording cannot tell from the best, itself first.

    One that only adds to another what is not needed is no other.
    """
    simulated, measure = [*found.singles, *found.pairs], found.yardstick
    top = max(simulated, key=found.evidence)
    rivals = [one for one in (found.base, *simulated) if alike(one, top, measure)]
    every = [best, *(one for one in rivals if one is not best)]
    return [best, *(one for one in every[1:] if not any(holds_all(one, less) for less in every))]


def asserted(best: Optimum, equal: list[Optimum]) -> tuple[type[Term], ...]:
    """The causes that all of the `equal` have, in one form or another, and that are at their values
    still what they are called; in the form of the best where all have that.
    """
    certain: list[type[Term]] = []
    every = (best, *equal)
    for cause in (cause for one in every for cause in causes_of(one)):
        known = any(same_cause(cause, other) for other in certain)
        if not known and all(has(each, cause) for each in equal):
            certain.append(cause)
    return tuple(cause for cause in certain if not only_inside(cause, certain, every))


def only_inside(cause: type[Term], certain: list[type[Term]], every: Sequence[Optimum]) -> bool:
    """Is it in all of them no more than a part of another certain cause, as a frame's friction is
    of its play?
    """
    own = any(same_cause(cause, term) for one in every for term in one.candidate.terms)
    return not own and any(
        named(term, value).includes() == name_of(cause)
        for one in every
        for term, value in zip(one.candidate.terms, one.candidate.values, strict=True)
        if term in certain
    )


def certain_of(found: Found, best: Optimum) -> tuple[type[Term], ...]:
    """The causes that are certain. Where more than noise is left, the last cause may only take up
    what nobody knows: then also what is best without one of them must have them. What the library
    does not name is none.
    """
    fewer = [] if found.yardstick.explains(best.square) else with_one_less(found, best)
    certain, most = asserted(best, [*equivalents(found, best), *fewer]), stand_ins(found, best)
    named = (one for one in certain if one not in NAMELESS)
    return tuple(one for one in named if not any(same_cause(one, term) for term in most))


def stand_ins(found: Found, best: Optimum) -> dict[type[Term], str]:
    """Its causes that stand in for what it does not have, and why they must; none of a lone cause
    that leaves only noise.
    """
    noise = found.yardstick.explains(best.square)
    if noise and causes(best) < 2:
        return {}
    if springless(found, best):
        own = (term for term in best.candidate.terms if not issubclass(term, SensorTerm))
        return dict.fromkeys(own, "would leave the leg hardly any stiffness")
    each = list(zip(best.candidate.terms, best.candidate.values, strict=True))
    most = "would have to be larger than it can be"
    why = {term: most for term, value in each if at_its_most(term, float(value[0]), found)}
    unsure = blurred(found.prepared, best, found.yardstick.scale)
    why |= dict.fromkeys(unsure, "may be something else within the error of its numbers")
    if not noise and not found.prepared.has_gyro:
        unwatched = "leaves more than noise where no gyro watches the encoder"
        why |= {term: unwatched for term, _ in each if issubclass(term, SensorTerm)}
    if not noise and found.followed(best) < FOLLOWED:
        left = f"numbers and leaves {1 - found.followed(best):.0%} of what is missing"
        why |= {term: f"has {value.size} {left}" for term, value in each if value.size > PLAIN}
    return why


def springless(found: Found, best: Optimum) -> bool:
    """Does more than noise remain, and a leg with hardly any of the stiffness that it seemed to
    have?
    """
    if found.prepared.rig or found.yardstick.explains(best.square):
        return False
    before, after = (
        float(found.prepared.coordinates(one.candidate).shared.stiffness)
        for one in (found.base, best)
    )
    return after < SOFT * before


def at_its_most(term: type[Term], size: float, found: Found) -> bool:
    """Is a size at the end of its range? None is no end where it has no sign, nor is a rest angle
    as far off as a constant torque.
    """
    if term.same_torque:
        return False
    _, first = next(declarations(term))
    declared = ranged(first, found.prepared.scale)
    room = AT_AN_END * (declared.upper - declared.lower)
    return size > declared.upper - room or size < min(declared.lower + room, 0.0)


def with_one_less(found: Found, best: Optimum) -> list[Optimum]:
    """Of what was simulated with one of the causes of the best less, in one form or another, that
    with most evidence; the baseline where that has more.
    """
    mine = best.candidate.terms
    each = [
        one
        for one in (*found.singles, *found.pairs)
        if len(one.candidate.terms) == len(mine) - 1
        and all(any(same_cause(term, own) for own in mine) for term in one.candidate.terms)
    ]
    return [max([found.base, *each], key=found.evidence)] if each else []


def causes_of(one: Optimum) -> list[type[Term]]:
    """Its terms that are what they are called, and what those include."""
    each = [named(*both) for both in zip(one.candidate.terms, one.candidate.values, strict=True)]
    inside = {term.includes() for term in each}
    own = [type(term) for term in each if term.itself()]
    return [*own, *(term for term in library() if name_of(term) in inside)]


def weight(found: Found, causes: tuple[type[Term], ...]) -> float:
    """The share of the weight of all explanations that those with all of the causes hold.

    An explanation weighs exp(-a / 2), a being how much the best is better (`Yardstick.apart`): the
    posterior odds of models by their evidence, no larger than what remains unexplained allows.
    """
    each = [found.base, *found.singles, *found.pairs]
    top = max(each, key=found.evidence)
    worse = [found.yardstick.apart(one.square, top.square, size(top) - size(one)) for one in each]
    odds = np.exp(-np.maximum(worse, 0.0) / 2)
    holding = [all(has(one, cause) for cause in causes) for one in each]
    return float(odds @ holding / odds.sum())


def holds_all(one: Optimum, less: Optimum) -> bool:
    """Has it all causes of another one, and more?"""
    more = len(one.candidate.terms) > len(less.candidate.terms)
    return more and all(has(one, term) for term in less.candidate.terms)


def has(one: Optimum, cause: type[Term]) -> bool:
    """Is one of its terms this cause, or does one include it at the values that it has?"""
    each = zip(one.candidate.terms, one.candidate.values, strict=True)
    return any(
        same_cause(term, cause) or named(term, value).includes() == name_of(cause)
        for term, value in each
    )


def same_cause(one: type[Term], other: type[Term]) -> bool:
    """Are they one cause: the same, forms of one, or exactly alike in every recording?"""
    names = {name_of(one), name_of(other)}
    twins = {one.twin, one.same_torque} | {other.twin, other.same_torque}
    forms = simpler_form(one, other) or simpler_form(other, one)
    return one is other or forms or bool(names & twins)
