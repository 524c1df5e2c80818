"""What a fit found, in few lines for the prompt, and as a table for notebooks and pandas."""

from math import degrees
from typing import Any

from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.recordings.summary import html_table


def lines(result: Any) -> str:
    """Every quantity on a line of its own, below how well it fits."""
    return "\n".join(
        [heading(result), *(f"  {estimate(each)}" for each in quantities(result).values())]
    )


def page(result: Any) -> str:
    """The same as HTML."""
    rows = [
        (each.symbol, each.title, number(each), each.unit, each.determined_by or each.reason or "")
        for each in quantities(result).values()
    ]
    return html_table(heading(result), ("", "quantity", "value", "unit", "set by"), rows)


def heading(result: Any) -> str:
    segments = f"{len(result.segments)} segment{'s' if len(result.segments) > 1 else ''}"
    astray = "" if result.follows else "it does not follow the recording, "
    return (
        f"FitResult: {astray}{segments}, {degrees(result.angle_rmse):.3g} deg RMSE, "
        f"{result.multistart.at_best} of {result.multistart.starts} starts at the best"
    )


def quantities(result: Any) -> dict[str, Any]:
    """Parameters, the gravity moment, ratios, then the terms'; of a fit that does not follow its
    recording none of them has a value.
    """
    shown = without_numbers(result)
    return {**shown.of_leg, **shown.ratios, **shown.of_terms}


def estimate(each: Any) -> str:
    """One quantity with its error and what determined it."""
    by = f" ({each.determined_by})" if each.determined_by else ""
    return (
        f"{each.symbol} = {number(each)} {each.unit}{by}"
        if each.value is not None
        else (f"{each.symbol}: not determined")
    )


def number(each: Any) -> str:
    if each.value is None:
        return "not determined"
    error = "" if each.standard_error is None else f" ± {each.standard_error:.2g}"
    more = "" if each.if_slack is None else f" (± {each.if_slack:.2g} if slack)"
    return f"{each.value:.4g}{error}{more}"


def frame(result: Any) -> Any:
    """A row for each quantity, for pandas."""
    from exoid.files.extras import require

    require("pandas", "a data frame is made")
    import pandas

    names = ("symbol", "value", "standard_error", "if_slack", "unit", "determined_by",
             "expected", "expected_deviation", "lower", "upper", "reason")  # fmt: skip
    found = quantities(result)
    rows = {name: [getattr(each, name) for each in found.values()] for name in names}
    numbers = (
        "value",
        "standard_error",
        "if_slack",
        "expected",
        "expected_deviation",
        "lower",
        "upper",
    )
    made = pandas.DataFrame(rows, index=pandas.Index([*found], name="quantity"))
    return made.astype(dict.fromkeys(numbers, float))
