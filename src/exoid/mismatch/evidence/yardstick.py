"""What a difference between sums of squares is worth, in units that noise and model error allow."""

from dataclasses import dataclass

import numpy as np
from scipy.special import chndtr  # not scipy.stats: as long to load as a fit takes

SURE = 30.0  # evidence beyond its price that noise does not reach: with thirty terms, 1 in 10 000
APART = 10.0  # evidence by which one candidate is better than another: odds of 150 to 1
MATTERS = 0.02  # of the noise's sum of squares: an effect that explains less changes nothing
KNOWN = 1.1  # mean square over the noise up to which noise may be all that is left
UNEXPLAINED = 1.6  # mean square over the noise from which on something remains unexplained
REFUTED = 10.0  # times the mean square of the best that a cause leaves which it cannot be
FOLLOWED = 0.97  # share of the mismatch that a term must explain to be named, where noise is known


@dataclass(frozen=True)
class Yardstick:
    """What a difference between sums of squares is worth."""

    samples: int
    scale: float  # by which the sums of squares are larger than those of independent noise

    def price(self, parameters: int) -> float:
        """What every parameter must earn: the log of the number of independent samples."""
        return parameters * float(np.log(max(self.samples / self.scale, np.e)))

    def evidence(self, worse: float, better: float, parameters: int) -> float:
        """The gain from one sum of squares to another, after its price."""
        return (worse - better) / self.scale - self.price(parameters)

    def apart(self, worse: float, best: float, parameters: int) -> float:
        """How much the best is better than another, in units of noise and of what remains.

        What even the best leaves over the noise, which is known to 5 %, has a cause that nobody
        knows. It may as well be what tells the two apart: a difference as large as that counts
        `APART` and no more.
        """
        found, left = self.evidence(worse, best, parameters), best - KNOWN * self.samples
        if left <= 0 or worse <= best:
            return found
        return min(found, APART * (worse - best) / left)

    def matters(self, worse: float, better: float) -> bool:
        """Is the gain large beside the noise itself?"""
        return worse - better > MATTERS * self.samples

    def clear(self, worse: float, better: float, parameters: int) -> bool:
        """Is the gain beyond what noise may do, and large enough to matter?"""
        found = self.evidence(worse, better, parameters) > SURE
        return found and self.matters(worse, better)

    def explains(self, square: float) -> bool:
        """Is what is left hardly more than noise?"""
        return square < UNEXPLAINED * self.samples

    def followed(self, worse: float, better: float) -> float:
        """The share of the excess over the noise that is explained."""
        return 1 - (better - self.samples) / max(worse - self.samples, 1.0)

    def power(self, worse: float, better: float, parameters: int) -> float:
        """The chance that an effect as large as this becomes clear once more."""
        size = max(worse - better, 0.0) / self.scale
        return float(1 - chndtr(self.least(parameters), parameters, size))

    def least(self, parameters: int) -> float:
        """The smallest gain that is clear."""
        found = SURE + self.price(parameters)
        return max(found, MATTERS * self.samples / self.scale)
