"""Two values of each person: both sides, or before and after."""

from dataclasses import dataclass

import numpy as np

from exoid.files.counted import counted
from exoid.studies.statistics.tables.frames import Column, Frame, frame_of
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import OCCASION, Values, means

FEWEST = 3


@dataclass(frozen=True, eq=False)
class Pairs:
    """`frame` has a row per person, with `first`, `second`, `first_error` and `second_error`."""

    quantity: str
    unit: str
    first: str
    second: str
    frame: Frame

    @property
    def difference(self) -> Column:
        """Second less first."""
        return self.frame["second"] - self.frame["first"]

    @property
    def mean(self) -> Column:
        return (self.frame["second"] + self.frame["first"]) / 2

    @property
    def error(self) -> Column:
        """Of the difference, by the errors of the estimates; NaN where one is unknown."""
        return np.hypot(self.frame["first_error"], self.frame["second_error"])


def pairs_of(values: Values, column: str, first: str, second: str) -> Pairs:
    """Of every person who has both: sides are paired day by day, days side by side, then averaged.

    **Raises** `NotTold` (why) where fewer than three have both.
    """
    both = means(values, OCCASION)[["value", "error"]].unstack(column)
    names = both.columns.get_level_values(column)
    if first not in names or second not in names:
        lacking = first if first not in names else second
        raise NotTold(f"No value is of the {column} {lacking!r}.")
    columns = {
        "first": both["value", first],
        "second": both["value", second],
        "first_square": both["error", first] ** 2,
        "second_square": both["error", second] ** 2,
    }
    whole = frame_of(columns).dropna(subset=["first", "second"]).groupby(level="person")
    found = whole[["first", "second"]].mean()
    if len(found) < FEWEST:
        raise NotTold(
            f"{counted(len(found), 'person has', 'people have')} both {first!r} and {second!r}: "
            f"at least {FEWEST} are needed."
        )
    for name in ("first", "second"):
        square = whole[f"{name}_square"].sum(skipna=False)
        found[f"{name}_error"] = np.sqrt(square) / whole.size()
    return Pairs(values.quantity, values.unit, first, second, found)
