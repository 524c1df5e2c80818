"""A quantity with its error, its unit, and what determined it."""

from dataclasses import dataclass, replace
from math import hypot

from exoid.fitting.misfit.uncertainty import Shares, Source
from exoid.fitting.model.user_values import Means

RIVALS = "rival causes"  # what limits a number where a diagnosis cannot tell causes apart


@dataclass(frozen=True)
class Estimate:
    """A quantity as the tables print it. `value` is None where nothing determines it."""

    symbol: str
    title: str
    unit: str
    value: float | None
    standard_error: float | None
    expected: float | None = None
    expected_deviation: float | None = None
    lower: float | None = None
    upper: float | None = None
    shares: Shares | None = None  # of its precision; None where there is none
    reason: str | None = None  # why there is no value, or no error
    # by what part its variance would shrink were each systematic known: they need not add up to 1
    limited_by: dict[str, float] | None = None
    by_hand: Means | None = None  # fixed, bounded or expected by the user
    if_slack: float | None = None  # error more, for a spring slack elsewhere than at full extension

    @property
    def determined_by(self) -> Source | None:
        return None if self.shares is None else self.shares.source

    def widened(self, by: float, least: float = 0.0, cause: str | None = None) -> "Estimate":
        """With an error of `least`, and a standard deviation more, that a `cause` makes; where no
        error is, there is none to widen. What its systematics make of it stays.
        """
        error = hypot(max(self.standard_error or 0.0, least), by)
        if not self.standard_error or error == self.standard_error:
            return self
        kept = (self.standard_error / error) ** 2
        shares = {name: kept * share for name, share in (self.limited_by or {}).items()}
        more = {} if cause is None else {cause: shares.get(cause, 0.0) + 1 - kept}
        return replace(self, standard_error=error, limited_by=shares | more)

    @property
    def set_by(self) -> str | None:
        """Who determined the value, in words that tell the user's own hand from exoid's."""
        if self.by_hand == "fix":
            return "fixed by you"
        if self.by_hand == "bound" and self.shares is not None and self.shares.bound == 1.0:
            return "your bound"
        if (self.by_hand, self.determined_by) == ("prior", "prior"):
            return "your prior"
        if (self.by_hand, self.determined_by) == ("prior", "both"):
            return "both, your prior"
        if self.shares is not None and self.determined_by == "data":
            return self.shares.kind or "data"
        return self.determined_by
