"""What besides white noise is in a residual, and how it is weighed."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause

NOISY = 1.1  # over the declared noise, from where on it is worth a word
DOUBT = 10.0  # a process only stands for what a kind misses: it is held for this much worse

KINDS = ("passive", "measured", "active")  # of segments; the last leans on a form of its torque


@dataclass(frozen=True)
class Missed:
    """What besides white noise is in a residual; `cause` is None where nothing is."""

    cause: Cause | None
    correlation_time: float  # s
    ratio: float  # variance of u over that of the noise, in units of its gram
    noise: float  # s, over the declared noise
    likelihood: float  # the logarithm of the greatest restricted one

    @property
    def deviation(self) -> float:
        """Of u: rad/s^2, which is a torque over J, or rad."""
        return self.noise * self.ratio**0.5 * (1.0 if self.cause is None else UNIT[self.cause])


@dataclass(frozen=True, eq=False)
class Disturbance:
    """What every kind of segment misses, how it is weighed, and the information that is left."""

    kinds: dict[str, Missed]
    scales: dict[str, float]  # that a kind's residual is divided by, over the least of them
    information: Float[np.ndarray, "coordinate coordinate"]  # H M^-1 H
    widening: Float[np.ndarray, " direction"]  # of the errors, along what the data determine
    # root mean square, over the noise, that a fit to one kind alone leaves, where kinds differ
    alone: dict[str, float] = field(default_factory=dict)

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
