"""The causes that a diagnosis tried, by what each leaves unexplained."""

from dataclasses import dataclass

from exoid.mismatch.answer.diagnosis import Diagnosis, Tested

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
    ran = [*found.pairs[:PAIRS], *found.singles]
    if found.formula is not None:
        ran = [found.best, *ran]
    known = [one.terms for one in ran]
    rows = [*ran, *(one for one in found.pinned if one.terms not in known)]
    best = sorted(rows, key=lambda one: one.mean_square)[:MOST]
    alone = Cause("Eq. 9 alone", found.baseline.mean_square, False)
    return [alone, *(Cause(label(one), one.mean_square, one.chosen) for one in best)]


def label(one: Tested) -> str:
    return " +\n".join(one.terms).replace("_", " ")
