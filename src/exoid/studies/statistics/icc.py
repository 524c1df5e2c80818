"""Intraclass correlations of a complete table, people by occasions.

Names and intervals as McGraw & Wong (1996), Psychological Methods 1: 30-46, have them; those of
Shrout & Fleiss (1979), Psychological Bulletin 86: 420-428, in brackets.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.stats import chi2, f

from exoid.studies.statistics.tables.said import Interval, NotTold

TAIL = 0.025  # of either side of a 95 % interval
Table = Float[np.ndarray, "person occasion"]


@dataclass(frozen=True)
class Icc:
    """Of one occasion.

    `one_way` ICC(1) [(1,1)]; `agreement` ICC(A,1) [(2,1)], which a shift of an occasion lowers;
    `consistency` ICC(C,1) [(3,1)], which it does not. `of_mean` has the three for the mean of all
    occasions: ICC(k), ICC(A,k), ICC(C,k). `sem` is the standard error of measurement without the
    shift, the root of the residual mean square.
    """

    one_way: Interval
    agreement: Interval
    consistency: Interval
    of_mean: tuple[float, float, float]
    sem: Interval


@dataclass(frozen=True)
class Squares:
    """Mean squares of the two-way table: of rows, columns, what is left, and within rows."""

    people: int
    occasions: int
    rows: float
    columns: float
    error: float
    within: float


def icc(table: Table) -> Icc:
    """**Raises** `NotTold` (why) where the table is too small, or does not vary."""
    squares = squares_of(table)
    return Icc(
        one_way(squares),
        agreement(squares),
        consistency(squares),
        of_mean(squares),
        sem(squares),
    )


def squares_of(table: Table) -> Squares:
    n, k = table.shape
    if n < 3 or k < 2:
        raise NotTold(f"{n} people on {k} occasions are too few: 3 people and 2 are needed.")
    if not np.isfinite(table).all():
        raise NotTold("The table is not complete.")
    rows, columns = table.mean(1, keepdims=True), table.mean(0, keepdims=True)
    whole = table.mean()
    left = np.sum((table - rows - columns + whole) ** 2) / ((n - 1) * (k - 1))
    within = np.sum((table - rows) ** 2) / (n * (k - 1))
    between = k * np.sum((rows - whole) ** 2) / (n - 1)
    size = np.finfo(float).eps * np.abs(table).max()
    if left <= size**2 or between <= size**2:
        raise NotTold("The values do not vary, between people or from one occasion to another.")
    shift = n * np.sum((columns - whole) ** 2) / (k - 1)
    return Squares(n, k, float(between), float(shift), float(left), float(within))


def one_way(each: Squares) -> Interval:
    n, k, ratio = each.people, each.occasions, each.rows / each.within
    low = ratio / f.isf(TAIL, n - 1, n * (k - 1))
    high = ratio * f.isf(TAIL, n * (k - 1), n - 1)
    return Interval(*(float((one - 1) / (one + k - 1)) for one in (ratio, low, high)))


def consistency(each: Squares) -> Interval:
    n, k, ratio = each.people, each.occasions, each.rows / each.error
    low = ratio / f.isf(TAIL, n - 1, (n - 1) * (k - 1))
    high = ratio * f.isf(TAIL, (n - 1) * (k - 1), n - 1)
    return Interval(*(float((one - 1) / (one + k - 1)) for one in (ratio, low, high)))


def agreement(each: Squares) -> Interval:
    """Its interval rests on Satterthwaite's degrees of freedom."""
    n, k = each.people, each.occasions
    rows, columns, error = each.rows, each.columns, each.error
    value = (rows - error) / (rows + (k - 1) * error + k * (columns - error) / n)
    a = k * value / (n * (1 - value))
    b = 1 + k * value * (n - 1) / (n * (1 - value))
    freedom = (a * columns + b * error) ** 2 / (
        (a * columns) ** 2 / (k - 1) + (b * error) ** 2 / ((n - 1) * (k - 1))
    )
    below, above = f.isf(TAIL, n - 1, freedom), f.isf(TAIL, freedom, n - 1)
    rest = k * columns + (k * n - k - n) * error
    low = n * (rows - below * error) / (below * rest + n * rows)
    high = n * (above * rows - error) / (rest + n * above * rows)
    return Interval(value, float(low), float(high))


def of_mean(each: Squares) -> tuple[float, float, float]:
    rows, columns, error = each.rows, each.columns, each.error
    return (
        (rows - each.within) / rows,
        (rows - error) / (rows + (columns - error) / each.people),
        (rows - error) / rows,
    )


def sem(each: Squares) -> Interval:
    freedom = (each.people - 1) * (each.occasions - 1)
    low, high = (each.error * freedom / chi2.isf(tail, freedom) for tail in (TAIL, 1 - TAIL))
    return Interval(each.error**0.5, float(low**0.5), float(high**0.5))
