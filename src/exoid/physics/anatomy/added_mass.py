"""A mass on the shank, by what motion shows of it."""

from math import sqrt

from exoid.physics.leg import GRAVITY

UNUSUAL = 2.0  # standard deviations: a mass that reaches beyond 10 cm, or hangs 1 cm elsewhere


def same_swing(distance: float, square: float, usual: float) -> float:
    """Where a mass of the `usual` k^2 [m^2] swings as one of this `square` does at a distance [m].

    Beside their weights, motion tells the length of the pendulum that a mass is, L = r + k^2 / r,
    so that r = (L + sqrt(L^2 - 4 k^2)) / 2, the longer of two.
    """
    length = distance + square / distance
    return (length + sqrt(max(length**2 - 4 * usual, 0.0))) / 2


def changes_swing_least(gravity: float) -> float:
    """Where a mass swings by itself as fast as a leg of this G = m l g / J [1/s^2]: r = g / G [m].

    A mass M at r changes G by M r (G r - g) / (J + M r^2). Between there and the knee that is most
    at half of it.
    """
    return GRAVITY / gravity
