"""A table of the report."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from exoid.fitting.result.fit_result import Estimate
from exoid.report.words.text import written

DIMENSIONLESS = ("-", "1")
STACKED, SPANNING = 3, 5  # columns that a phone has room for, and half a sheet of paper


@dataclass(frozen=True)
class Table:
    """Columns of equal length by their heads, and what they are in words.

    The first column names the rows. Columns that hold nothing are left out.
    """

    caption: str
    columns: Mapping[str, Sequence[str]]

    @property
    def heads(self) -> list[str]:
        return [head for head, cells in self.columns.items() if any(cells)]

    @property
    def shape(self) -> str:
        """`stack`: a phone shows its rows below each other; `span`: paper gives it both columns."""
        many = len(self.heads)
        return " ".join(["stack"] * (many > STACKED) + ["span"] * (many > SPANNING))

    @property
    def rows(self) -> list[tuple[str, ...]]:
        return list(zip(*(self.columns[head] for head in self.heads), strict=True))


def quantity(each: Estimate) -> str:
    """Value ± standard error with the unit."""
    plain = each.value is None or each.unit in DIMENSIONLESS
    return written(each) if plain else f"{written(each)} {each.unit}"
