"""Numbers of a study as they are read: with as many digits as their intervals allow."""

from math import isfinite

from exoid.report.words.text import exponent, shown_unit
from exoid.studies.statistics.tables.said import Interval

MOST_DECIMALS, LARGE = 6, 1e5
WIDEST = 20.0  # standard deviations, of the interval of a g that still tells something
NOT_FOUND = "the interval could not be found"


def number(value: float, like: float | None = None) -> str:
    """With as many decimals as make two digits of `like`, a half width."""
    like = value if like is None else like
    if not isfinite(value):
        return "not known"
    if not isfinite(like) or like == 0 or abs(value) >= LARGE:
        return f"{value:.4g}"
    decimals = 1 - exponent(abs(like))
    if decimals > MOST_DECIMALS:
        return f"{value:.3g}"
    return f"{value:z.{max(decimals, 0)}f}"


def with_interval(each: Interval, unit: str = "1") -> str:
    """0.21 rad (95 % 0.12 to 0.30)."""
    shown = f" {shown_unit(unit)}".rstrip()
    if not (isfinite(each.low) and isfinite(each.high)):
        return f"{number(each.value)}{shown} ({NOT_FOUND})"
    half = (each.high - each.low) / 2
    value, low, high = (number(one, half) for one in (each.value, each.low, each.high))
    return f"{value}{shown} (95 % {low} to {high})"


def tells(g: Interval) -> bool:
    """Is a standardised difference known to some degree?"""
    return bool(g.high - g.low < WIDEST)


def in_brackets(each: Interval, unit: str = "1") -> str:
    """0.21 rad (0.12 to 0.30), for a table that says what the brackets hold."""
    return with_interval(each, unit).replace("(95 % ", "(")


def chance(p: float) -> str:
    """A p as it is read."""
    if not isfinite(p):
        return ""
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}" if p < 0.1 else f"p = {p:.2f}"


def odds(p: float, corrected: float, count: int) -> str:
    """Of one test, and among as many of its kind."""
    if count < 2:
        return chance(p)
    among = p_cell(corrected)
    return f"{chance(p)} (corrected for {count} quantities: {among})"


def p_cell(p: float) -> str:
    return chance(p).removeprefix("p = ").removeprefix("p ")
