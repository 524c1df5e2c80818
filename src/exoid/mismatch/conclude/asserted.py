"""What is certain: the causes that every explanation has which this recording cannot tell apart."""

from collections.abc import Sequence
from itertools import permutations

import numpy as np

from exoid.mismatch.evidence.yardstick import FOLLOWED
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, blurred, causes, size
from exoid.mismatch.search.rank import alike, simpler_form
from exoid.physics.library import library
from exoid.physics.parameter import AT_AN_END, declarations
from exoid.physics.scale import ranged
from exoid.physics.term import SensorTerm, Term, holds, name_of

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
    what nobody knows: then also what is best without one of them must have them.
    """
    fewer = [] if found.yardstick.explains(best.square) else with_one_less(found, best)
    certain, most = asserted(best, [*equivalents(found, best), *fewer]), stand_ins(found, best)
    return tuple(one for one in certain if not any(same_cause(one, term) for term in most))


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


def plainest(found: Found, best: Optimum) -> Optimum:
    """The best, or where it only includes what is certain, the best of those that have it: a frame
    that rubs has dry friction, and play beside it that nobody needs.
    """
    equal, certain = equivalents(found, best), certain_of(found, best)

    def plain(one: Optimum) -> bool:
        return all(any(same_cause(cause, own) for own in one.candidate.terms) for cause in certain)

    each = [one for one in equal if plain(one)]
    chosen = best if best in each or not each else max(each, key=found.evidence)
    return in_usual_form(found, in_plainest_form(found, chosen))


def in_usual_form(found: Found, best: Optimum) -> Optimum:
    """The same with what every gyro has some of, where its exact twin is a fault that few clocks
    have: nothing but rounding tells the two apart.
    """
    mine, measure = families(best), found.yardstick
    twins = [
        one
        for one in (*found.singles, *found.pairs)
        if families(one) == mine and alike(one, best, measure)
    ]
    return max([best, *twins], key=lambda one: sum(term.everyday for term in one.candidate.terms))


def families(one: Optimum) -> list[list[str]]:
    """Its causes, each with its exact twin."""
    return sorted(sorted({name_of(term), term.twin}) for term in one.candidate.terms)


def in_plainest_form(found: Found, best: Optimum) -> Optimum:
    """The same with a cause in a simpler form, where the finer one explains less than what remains
    unexplained: that may as well be of the same size and shape.
    """
    most = 2 * best.square - found.yardstick.samples
    simpler = [
        one
        for one in (*found.singles, *found.pairs)
        if best.square <= one.square < most and is_simpler(one, best)
    ]
    noise = found.yardstick.explains(best.square)
    return best if noise or not simpler else max(simpler, key=found.evidence)


def is_simpler(one: Optimum, other: Optimum) -> bool:
    """Has it the same causes, some in a simpler form? What sticks has none that does not."""
    mine, others = one.candidate.terms, other.candidate.terms
    return set(mine) != set(others) and any(
        len(order) == len(others) and all(map(is_form_of, order, others))
        for order in permutations(mine)
    )


def is_form_of(term: type[Term], its: type[Term]) -> bool:
    """Is it the same, or a simpler form of it?"""
    return term is its or (simpler_form(term, its) and holds(term) is holds(its))


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
