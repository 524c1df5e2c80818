"""A known mass on the shank, as well as it was weighed, placed and shaped."""

from dataclasses import dataclass
from math import sqrt

from exoid.fitting.model.systematics import GYRATION, MEASURED_GYRATION, PLACED, WEIGHED

LEAST = 1e-9  # m^2: a variance may not vanish


@dataclass(frozen=True)
class Weighed:
    """How far a sample's mass may be off, one standard deviation each: as `exoid.fit` assumes it
    where nothing is declared.

    `gyration` is its radius of gyration about its own middle, to a tenth; unknown, as of weights
    and cuffs, where it is None.
    """

    share: float = WEIGHED  # of the mass: a kitchen scale
    distance: float = PLACED  # m, by tape
    gyration: float | None = None  # m

    @property
    def extent(self) -> tuple[float, float]:
        """The square of the radius of gyration [m^2], and its standard deviation."""
        if self.gyration is None:
            return GYRATION**2, sqrt(2) * GYRATION**2
        extent = self.gyration**2
        return extent, max(2 * MEASURED_GYRATION * extent, LEAST)

    @property
    def expected(self) -> tuple[tuple[float, float], ...]:
        """Mean and standard deviation of each of the row's entries of a mass."""
        return (0.0, self.share), (0.0, self.distance), self.extent
