"""A value of the best fit, and what is known around it."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from exoid.fitting.misfit.uncertainty import HELD, Information, Shares
from exoid.fitting.model.user_values import Means
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate

ON_BOUND = "at a bound: no error is quoted"
ON_YOUR_BOUND = "at your bound: no error is quoted"
FIXED = "fixed by you: ± 0 is no finding, and the errors of the others hold if it is true"
NARROWED = "follows from a bound, not from the recording: ± holds only there, see --plot for more"


@dataclass(frozen=True, eq=False)
class Found:
    """A value of the best fit, its gradient, and what is known around it."""

    value: float
    gradient: np.ndarray
    information: Information
    held: bool  # on a bound, or by hand

    @cached_property
    def shares(self) -> Shares | None:
        """Who told it; None where nothing did."""
        return HELD if self.held else self.information.shares(self.gradient)

    def untold(self, reason: str) -> str | None:
        """The reason, where nothing tells the value."""
        return reason if self.shares is None else None

    def estimate(
        self, label: tuple[str, str, str], *, by_hand: Means | None = None, **more: Any
    ) -> Estimate:
        """With its error, where one is quoted, under its symbol, title and unit."""
        shares, error = self.shares, None
        if shares is not None and shares != HELD:
            error = self.information.standard_error(self.gradient)
        return Estimate(
            *label,
            value=None if shares is None else self.value,
            standard_error=0.0 if by_hand == "fix" else error,
            shares=shares,
            limited_by=self.information.limits(self.gradient),
            by_hand=by_hand,
            **more,
        )


def mean_of(basis: Basis, names: list[str], at_bound: set[str]) -> Found:
    """The mean over some quantities of the best fit, held where all of them are at a bound."""
    rows = [basis.problem.quantities.index(name) for name in names]
    value = float(basis.ended.best.quantities[0, rows].mean())
    gradient = basis.ended.local.quantities[rows].mean(axis=0)
    return Found(value, gradient, basis.information, at_bound.issuperset(names))


def why(shares: Shares | None, by_hand: Means | None) -> str | None:
    """Why an error is none, or small."""
    if by_hand == "fix":
        return FIXED
    if shares == HELD:
        return ON_YOUR_BOUND if by_hand == "bound" else ON_BOUND
    # An error may be small only because a bound holds another quantity.
    return NARROWED if shares is not None and shares.source == "bound" else None
