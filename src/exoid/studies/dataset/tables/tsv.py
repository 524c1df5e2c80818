"""Tables of BIDS: columns by tabs, what is missing as n/a."""

from collections.abc import Iterable, Sequence

MISSING = "n/a"


def tsv(rows: Iterable[Sequence[object]]) -> str:
    """The text of a table; a number as short as it is exact."""
    return "".join("\t".join(map(cell, row)) + "\n" for row in rows)


def cell(value: object) -> str:
    """A cell; what would end it is a space."""
    if value is None or value == "" or value != value:
        return MISSING
    return " ".join(str(value).split()) if isinstance(value, str) else repr(value)
