"""An estimate with its error, as every report prints it."""

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.report.words.text import NOT_DETERMINED, with_error

AT_BOUND = 1e-3  # relative distance within which a value is written as its bound


def written(each: Estimate) -> str:
    """value ± standard error, as far as they are known."""
    if each.value is None:
        return NOT_DETERMINED
    if each.standard_error is not None:
        return with_error(each.value, each.standard_error)
    return f"{on_bound(each):.4g}"


def if_slack(each: Estimate) -> str:
    """The error more that holds for a spring slack elsewhere than at full extension."""
    return "" if each.if_slack is None else f"± {each.if_slack:.2g}"


def on_bound(each: Estimate) -> float | None:
    """The value, without the rounding by which one that a bound set lies beside it."""
    if each.value is None or each.determined_by != "bound":
        return each.value
    for bound in (each.lower, each.upper):
        if bound is not None and abs(each.value - bound) <= AT_BOUND * max(1.0, abs(bound)):
            return bound
    return each.value
