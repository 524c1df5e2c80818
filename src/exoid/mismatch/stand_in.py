"""Does what has a name only stand in for something simple that has none?"""

from dataclasses import replace

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.conclude.asserted import certain_of
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.glance import beside_free
from exoid.mismatch.search.rank import alike, by_evidence
from exoid.physics.library import library
from exoid.physics.term import SensorTerm, name_of

NEAR = 3.0  # times what the best leaves, within which running free may change the order
MOST = 2  # torques that run free, of every set


def with_nameless(found: Found, best: Optimum) -> Found:
    """The same with torques without a name in the place of one of the library's torques that the
    best has, and of all: where these explain as much, it is not certain that those are there.
    """
    known = {*library()}
    torques = [
        term for term in best.candidate.terms if term in known and not issubclass(term, SensorTerm)
    ]
    if not torques:
        return found
    fewer = [best.candidate.without(each) for each in (torques, *([one] for one in torques))]
    sets = [settled(found, one) for one in {frozenset(one.terms): one for one in fewer}.values()]
    tried = side_by_side(
        lambda start: settle_free(found.prepared, start, rival=best.square),
        [start for one in sets for start in near(found, one, best)],
    )
    sound = [one for one in tried if one.sound]
    singles, pairs = (
        by_evidence([*those, *more], found.base, found.yardstick) if more else those
        for those, more in (
            (found.singles, [one for one in sound if len(one.candidate.terms) == 1]),
            (found.pairs, [one for one in sound if len(one.candidate.terms) > 1]),
        )
    )
    return replace(found, singles=singles, pairs=pairs)


def leading(found: Found, best: Optimum) -> Optimum:
    """The best, or a set that has a torque without a name beside a cause that is certain, and
    refutes the best: the leg's numbers are those of what explains most.
    """
    top = max((best, *found.singles, *found.pairs), key=found.evidence)
    nameless = not NAMELESS.isdisjoint(top.candidate.terms)
    if not nameless or alike(best, top, found.yardstick):
        return best
    return top if certain_of(found, top) else best


def settled(found: Found, candidate: Hypothesis) -> Optimum:
    """Where a set with a cause less ends: as the search left it, or from here."""
    each = (found.base, *found.singles, *found.pairs)
    same = [one for one in each if {*one.candidate.terms} == {*candidate.terms}]
    return max(same, key=found.evidence) if same else settle_free(found.prepared, candidate)


def near(found: Found, one: Optimum, best: Optimum) -> list[Hypothesis]:
    """What has one of these torques more and to first order may come near the best; all of them
    where the best leaves more than noise, since to first order nobody sees how fast one fades.
    """
    beside = beside_free(found.prepared, sorted(NAMELESS, key=name_of), one)
    if not found.yardstick.explains(best.square):
        return [start for _, start in beside]
    most = NEAR * max(best.square, found.prepared.samples)
    return [start for left, start in beside[:MOST] if left < most]
