"""What the drops of a leg show, in few lines for the prompt, and as a table for notebooks and
pandas.
"""

from typing import Any

from exoid.files.extras import require
from exoid.pendulum.catalogue import MEASURES
from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.summary import html_table

FIELDS = ("drop", "measure", "symbol", "value", "standard_error", "unit", "reason")
UNREAD = Measure("", "", "", "")  # of a drop that is refused whole


def lines(test: Any) -> str:
    """Every average on a line of its own, below how many drops were read."""
    each = [
        f"  {one.symbol} = {mean(one)}{unit(one)} ({one.title})" for one in test.average.values()
    ]
    return "\n".join([heading(test), *each])


def page(test: Any) -> str:
    """The same as HTML."""
    each = test.average.values()
    rows = [(one.symbol, one.title, mean(one), one.unit, len(one.drops)) for one in each]
    return html_table(heading(test), ("", "measure", "mean ± sd", "unit", "drops"), rows)


def heading(test: Any) -> str:
    read = sum(each.reason is None for each in test.drops)
    return f"PendulumTest: {read} of {len(test.drops)} segments read"


def mean(one: Any) -> str:
    spread = "" if one.standard_deviation is None else f" ± {one.standard_deviation:.2g}"
    return f"{one.mean:.4g}{spread}"


def unit(one: Any) -> str:
    return "" if one.unit == "1" else f" {one.unit}"


def frame(test: Any) -> Any:
    """A row for every measure of every drop, for pandas; a drop that is refused whole has all
    measures without a value.
    """
    require("pandas", "a data frame is made")
    import pandas

    rows = [
        (drop.name, name, each.symbol, read.value, read.standard_error, each.unit, why)
        for drop in test.drops
        for name, each in MEASURES.items()
        for read in [drop.measures.get(name, UNREAD)]
        for why in [drop.reason or read.reason]
    ]
    made = pandas.DataFrame(rows, columns=pandas.Index(FIELDS))
    return made.astype({"value": float, "standard_error": float})
