"""Does what has a name only stand in for something simple that has none?"""

from dataclasses import replace

from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.glance import beside_free
from exoid.mismatch.search.rank import by_evidence
from exoid.mismatch.search.several import with_one_less
from exoid.physics.term import SensorTerm, name_of

NEAR = 3.0  # times what the best leaves, within which running free may change the order
MOST = 2  # torques that run free, of every set


def with_nameless(found: Found, best: Optimum) -> Found:
    """The same with torques without a name in the place of one of the causes of the best, or of
    all: where these explain as much, it is not certain that those are there.
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
    alone = [one for one in tried if one.sound and len(one.candidate.terms) == first + 1]
    joint = [one for one in tried if one.sound and len(one.candidate.terms) > first + 1]
    singles, pairs = (
        by_evidence([*those, *more], found.base, found.yardstick) if more else those
        for those, more in ((found.singles, alone), (found.pairs, joint))
    )
    return replace(found, singles=singles, pairs=pairs)


def near(found: Found, one: Optimum, best: Optimum) -> list[Hypothesis]:
    """What has one of these torques more, and to first order may come near the best."""
    most = NEAR * max(best.square, found.prepared.samples)
    beside = beside_free(found.prepared, sorted(NAMELESS, key=name_of), one)
    return [start for left, start in beside[:MOST] if left < most]
