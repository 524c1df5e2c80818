"""Does what has a name only stand in for something simple that has none?"""

from dataclasses import replace

from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.glance import beside_free
from exoid.mismatch.search.several import with_one_less
from exoid.physics.term import SensorTerm

NEAR = 3.0  # times what the best leaves, within which running free may change the order
MOST = 2  # torques that run free, of every set


def with_nameless(found: Found, best: Optimum) -> Found:
    """The same with those torques without a name that explain more than the best does, in the place
    of one of its causes or of all: then it is not certain that one of these is there.
    """
    prepared, first = found.prepared, len(found.prepared.common)
    own = best.candidate.terms[first:]
    if not own or all(issubclass(term, SensorTerm) for term in own):
        return found
    fewer = [found.base.candidate, *with_one_less(best.candidate, first)]
    less = {frozenset(one.terms): one for one in fewer}
    known = {
        frozenset(one.candidate.terms): one for one in (found.base, *found.singles, *found.pairs)
    }
    sets = [known.get(terms) or settle_free(prepared, start) for terms, start in less.items()]
    tried = side_by_side(
        lambda start: settle_free(prepared, start, rival=best.square),
        [start for one in sets for start in near(found, one, best)],
    )
    better = [one for one in tried if one.sound and found.evidence(one) > found.evidence(best)]
    alone = [one for one in better if len(one.candidate.terms) == first + 1]
    joint = [one for one in better if len(one.candidate.terms) > first + 1]
    return replace(found, singles=[*found.singles, *alone], pairs=[*found.pairs, *joint])


def near(found: Found, one: Optimum, best: Optimum) -> list[Hypothesis]:
    """What has one of these torques more, and to first order may come near the best."""
    most = NEAR * max(best.square, found.prepared.samples)
    beside = beside_free(found.prepared, list(NAMELESS), one)
    return [start for left, start in beside[:MOST] if left < most]
