"""What the noise, and what the model misses, leave of the information that the data carry.

With the residual r = A dz + S u + e of every segment, and its weight w, the estimates scatter by

    H^-1 M H^-1,   H = sum w A'A,   M = sum w^2 A'(s^2 I + S K S')A,

the sandwich form, and H M^-1 H is the information that the data really carry. Noise s and process u
belong to the kind of segment: how a leg was moved at will says nothing of how it swings by itself.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from exoid.fitting.misfit.disturbance import ROUNDING, Missed, whitening
from exoid.fitting.misfit.gram_matrices import CAUSES, Cause, Gram, modes

KINDS = ("passive", "measured", "active")  # of segments; the last leans on a form of its torque


@dataclass(frozen=True, eq=False)
class Disturbance:
    """What every kind of segment misses, how it is weighed, and the information that is left."""

    kinds: dict[str, Missed]
    scales: dict[str, float]  # that a kind's residual is divided by, over the least of them
    information: Float[np.ndarray, "coordinate coordinate"]  # H M^-1 H
    widening: Float[np.ndarray, " direction"]  # of the errors, along what the data determine

    @property
    def cause(self) -> Cause | None:
        """Of the first kind that misses something; None where nothing is missed."""
        return next((each.cause for each in self.kinds.values() if each.cause), None)

    @property
    def trusted(self) -> str:
        """The kind that is weighed most."""
        return min(self.scales, key=self.scales.__getitem__)

    @property
    def noise(self) -> float:
        """White noise over the declared one, of the trusted kind."""
        return self.kinds[self.trusted].noise

    @property
    def apart(self) -> bool:
        """Are the kinds of segments weighed differently?"""
        return max(self.scales.values()) > 1.0

    @property
    def scale(self) -> float:
        """By how much all errors at least are wider than the declared noise makes them.

        The weight of the data against the prior goes by it: where the two disagree, the fit stays
        with the data. A kind that is weighed less than it tells by itself is none to go by.
        """
        return float(max(self.widening.min(), self.noise))

    def weighing(self, kinds: Sequence[str]) -> Float[np.ndarray, " segment"]:
        """What the residuals of segments of these kinds are divided by, one against the other."""
        return np.array([self.scales[kind] for kind in kinds])

    def like(self, kind: str) -> Missed:
        """What a segment of this kind misses; one that was not recorded, as the first that was."""
        return self.kinds.get(kind, next(iter(self.kinds.values())))

    def causes(self, kinds: Sequence[str]) -> list[Cause]:
        """Whose grams `spoiled` needs, segment by segment."""
        return [self.kinds[kind].cause or CAUSES[0] for kind in kinds]


def spoiled(found: Disturbance, grams: list[Gram], kinds: Sequence[str], size: int) -> Disturbance:
    """The same disturbance, with the information that it leaves to these segments.

    Each gram is of the cause of its kind.
    """
    plain, white, excess = (np.zeros((size, size)) for _ in range(3))
    for each, kind in zip(grams, kinds, strict=True):
        missed, weight = found.kinds[kind], found.scales[kind] ** -2
        _, cross = modes(each, missed.correlation_time)
        place = np.ix_(each.place, each.place)
        fitted, process = each.fitted[:-1, :-1], cross[:, :-1].T @ cross[:, :-1]
        plain[place] += weight * fitted
        white[place] += (weight * missed.noise) ** 2 * fitted
        excess[place] += (weight * missed.noise) ** 2 * missed.ratio * process
    basis, unit = whitening(plain)
    inside = basis.T @ ((white + excess) / np.outer(unit, unit)) @ basis
    grown, axes = np.linalg.eigh(inside)
    grown = np.maximum(grown, ROUNDING)
    back = np.linalg.pinv(basis).T @ axes * unit[:, None]
    information = (back / grown) @ back.T
    return replace(found, information=information, widening=np.sqrt(grown))


def common(missed: Missed, kinds: Sequence[str]) -> Disturbance:
    """One for all kinds, before it is known what it leaves."""
    each = [kind for kind in KINDS if kind in kinds]
    return Disturbance(
        dict.fromkeys(each, missed), dict.fromkeys(each, 1.0), np.zeros((0, 0)), np.ones(1)
    )
