"""Where all starts of a fit ended."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from exoid.fitting.misfit.condensed import Neighbourhood
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.uncertainty import decomposed, spread
from exoid.fitting.model.coordinates import TYPICAL, Coordinates, take
from exoid.fitting.model.limits import Prior
from exoid.fitting.solve.program_values import Solved

LIMITED = 1e-3  # tolerance with limits: a multiplier of ten makes it 1e-3 of half a sum of squares
FEASIBLE = 1e-4  # relative violation that is rounding of the multiplier method
SAME_LOSS = 1e-3  # relative; other minima lie orders of magnitude higher
Plain = Callable[[Disturbance], bool]  # is the answer, by what is missed?
TOLD = 0.5  # relative error of an inertia from which on the data do not tell it


@dataclass(frozen=True, eq=False)
class SearchResult:
    """Where all starts ended: the free fits, which start led to which, and the chosen fit."""

    free: Solved
    member: np.ndarray  # per start: its row of `free`, -1 where it failed
    failures: dict[str, int]
    best: Solved  # one row, with prior and limits
    disturbance: Disturbance  # in the residual of the free fit
    starts: Coordinates
    local: Neighbourhood  # of `best`
    level: np.ndarray | None = None  # every quantity on level seats, where `best` has tilted ones
    held: Prior | None = None  # the one of `best`, where what is declared holds it closer
    by_angle: Disturbance | None = None  # in the residual to the angles, where sensors lie apart

    @cached_property
    def point(self) -> Coordinates:
        """Where `best` is."""
        return take(self.best.coordinates, 0)


def scale_told(data: np.ndarray) -> bool:
    """Do the data by themselves fix the inertia, so that a search may begin at theirs?"""
    inertia = np.eye(data.shape[0])[0]  # the first coordinate
    error = spread(decomposed(data), np.eye(data.shape[0]), inertia)
    return bool(error * TYPICAL.shared.log_inertia < TOLD)
