"""The chi-square distribution, without the 0.2 s that SciPy's takes to be loaded."""

from math import erfc, exp, lgamma, log, sqrt

import numpy as np

CLOSE = 1e-9  # of itself, by which the last step of Newton moves it: the next would by its square


def chance_above(freedom: int, square: float) -> float:
    """The probability of a chi-square beyond `square`, of so many degrees of freedom.

    With h half the square, e^-h times the sum of h^k / Gamma(k + 1) over k = n / 2 - 1 and so on
    down to 0 or 1 / 2; where n is odd, erfc(sqrt h) besides.
    """
    half, odd = square / 2, freedom % 2
    if half <= 0:
        return 1.0
    powers = [each + odd / 2 for each in range(freedom // 2)]
    parts = [power * log(half) - half - lgamma(power + 1) for power in powers]
    return (erfc(sqrt(half)) if odd else 0.0) + float(np.exp(parts).sum())


def median_of(freedom: int) -> float:
    """The chi-square that every other is beyond, by Newton from Wilson's and Hilferty's cube."""
    square = freedom * (1 - 2 / (9 * freedom)) ** 3
    step = square
    while abs(step) > CLOSE * square:
        half = square / 2
        density = exp((freedom / 2 - 1) * log(half) - half - lgamma(freedom / 2)) / 2
        step = (chance_above(freedom, square) - 0.5) / density
        square += step
    return square
