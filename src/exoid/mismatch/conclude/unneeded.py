"""What an explanation does not need: out, the least needed first."""

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found, lost_at
from exoid.physics.parameter import declarations
from exoid.physics.term import Term


def without_unneeded(
    found: Found, base: Optimum, one: Optimum, some: tuple[type[Term], ...]
) -> Optimum:
    """The same without those of `some` that leave hardly more where they are out, the least needed
    taken out first: what a leg did in the place of one sensor's error may be none with another.
    """
    while left := {term: lost(found, one, term) for term in one.candidate.terms if term in some}:
        least = min(left, key=left.__getitem__)
        if found.yardstick.clear(left[least], 0.0, len(list(declarations(least)))):
            break
        fewer = one.candidate.without([least])
        one = settle_free(found.prepared, fewer) if fewer.terms else base
    return one


def lost(found: Found, one: Optimum, term: type[Term]) -> float:
    """What more would be left without a term, to first order."""
    at, candidate = one.candidate.point.size + one.candidate.zero.size, one.candidate
    place = candidate.terms.index(term)
    first = at + sum(value.size for value in candidate.values[:place])
    rows = [*range(first, first + candidate.values[place].size)]
    return lost_at(found.prepared, one, dict.fromkeys(rows, 0.0))
