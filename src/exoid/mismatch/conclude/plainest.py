"""In which form the best explanation is told: the plainest of those that nothing tells apart."""

from itertools import permutations

from exoid.mismatch.conclude.asserted import certain_of, equivalents, same_cause
from exoid.mismatch.conclude.twins import families
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.rank import alike, simpler_form
from exoid.physics.term import Term, holds


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
    """The same in the place of an exact twin that no knee can have, as a spring that is slack far
    beyond full extension, or that is a fault of clocks where every gyro has some of the other:
    nothing but rounding tells the two apart.
    """
    mine, measure = families(best), found.yardstick
    twins = [
        one
        for one in (*found.singles, *found.pairs)
        if families(one) == mine and alike(one, best, measure)
    ]

    def usual(one: Optimum) -> tuple[bool, int]:
        every = zip(one.candidate.terms, one.candidate.values, strict=True)
        can_be = found.prepared.rig or all(named(*each).possible() for each in every)
        return can_be, sum(term.everyday for term in one.candidate.terms)

    return max([best, *twins], key=usual)


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
