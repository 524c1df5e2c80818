"""Causes that are in everything that explains a recording, where what acts besides is open."""

from exoid.mismatch.conclude.asserted import asserted, has
from exoid.mismatch.conclude.rivals import REFUTED
from exoid.mismatch.conclude.verdict.cannot_tell import NEARLY_ALL, chance
from exoid.mismatch.conclude.verdict.judge import Judgement, claimed_at_once
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.resample import inclusion
from exoid.physics.term import Term


def in_all(
    found: Found, best: Optimum, judged: Judgement, repeated: float | None, seed: int
) -> list[type[Term]]:
    """The causes that all have which leave not very much more than the best, where it leaves only
    noise and nothing speaks against it but that resampled segments ask for another set; of these
    nearly all must have them.
    """
    if judged.verdict != "cannot_tell" or not found.yardstick.explains(best.square):
        return []
    if judged.reasons != chance(repeated, claimed_at_once(found, best)):
        return []
    each = [found.base, *found.singles, *found.pairs]
    near = [one for one in each if one.square < REFUTED * best.square]
    shared = [one for one in asserted(best, near) if one not in found.prepared.common]
    having = [one for one in each if all(has(one, term) for term in shared)]
    others = [one for one in each if one not in having]
    again = inclusion(found, having, others, seed) if shared and others else None
    return shared if again is None or again >= NEARLY_ALL else []
