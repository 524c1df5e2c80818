"""The causes that a diagnosis tried, by what each leaves unexplained."""

from dataclasses import dataclass

from exoid.diagnose.diagnosis import Diagnosis
from exoid.diagnose.search import names
from exoid.diagnose.settle import Settled
from exoid.physics.library import name_of

MOST = 7  # beside the baseline
PAIRS = 2  # of them
LEAST = 0.5  # of what is left, that a figure with a logarithmic axis shows


@dataclass(frozen=True)
class Cause:
    """One or two effects, or a formula."""

    name: str
    left: float  # mean square of what remains over the noise: 1 is the noise itself
    chosen: bool


def causes(found: Diagnosis) -> list[Cause]:
    """The baseline first, then those that leave least: run free where they were, else pinned."""
    ran = [*found.found.pairs[:PAIRS], *found.found.singles]
    if found.formula is not None:
        ran = [found.best, *ran]
    known = {one.candidate.terms for one in ran}
    rows = [(label(one, found), one.square, one is found.best) for one in ran]
    rows += [
        (name_of(term).replace("_", " "), square, False)
        for term, square in found.found.pinned.items()
        if (term,) not in known
    ]
    best = sorted(rows, key=lambda row: row[1])[:MOST]
    alone = ("Eq. 9 alone", found.found.base.square, False)
    samples = found.yardstick.samples
    return [Cause(name, square / samples, chosen) for name, square, chosen in (alone, *best)]


def label(one: Settled, found: Diagnosis) -> str:
    if found.formula is not None and one is found.best:
        return "formula"
    return " +\n".join(names(one)).replace("_", " ")
