"""Causes that are in everything that explains a recording, where what acts besides is open."""

from exoid.mismatch.conclude.asserted import asserted, has
from exoid.mismatch.conclude.verdict.cannot_tell import NEARLY_ALL
from exoid.mismatch.evidence.yardstick import REFUTED
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.resample import inclusion
from exoid.physics.term import Term


def in_all(found: Found, best: Optimum, seed: int) -> list[type[Term]]:
    """The causes that all have which leave not very much more than the best, where it leaves only
    noise; of resampled segments nearly all must ask for one that has them.
    """
    if not found.yardstick.explains(best.square):
        return []
    each = [found.base, *found.singles, *found.pairs]
    near = [one for one in each if one.square < REFUTED * best.square]
    shared = [one for one in asserted(best, near) if one not in found.prepared.common]
    having = [one for one in each if all(has(one, term) for term in shared)]
    others = [one for one in each if one not in having]
    again = inclusion(found, having, others, seed) if shared and others else None
    return shared if again is None or again >= NEARLY_ALL else []
