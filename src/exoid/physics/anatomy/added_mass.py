"""A mass on the shank, by what motion shows of it."""

from math import sqrt

UNUSUAL = 2.0  # standard deviations: a mass that reaches beyond 10 cm, or hangs 1 cm elsewhere


def same_swing(distance: float, square: float, usual: float) -> float:
    """Where a mass of the `usual` k^2 [m^2] swings as one of this `square` does at a distance [m].

    Beside their weights, motion tells the length of the pendulum that a mass is, L = r + k^2 / r,
    so that r = (L + sqrt(L^2 - 4 k^2)) / 2, the longer of two.
    """
    length = distance + square / distance
    return (length + sqrt(max(length**2 - 4 * usual, 0.0))) / 2
