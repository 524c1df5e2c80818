"""A torque over the angle as springs that begin to pull at one angle each."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from exoid.interchange.formats.mujoco.by_variable import Curve

COUNTS = (8, 12, 16, 24, 32, 48, 64)  # of pieces, tried in turn
CLOSE = 1e-5  # of the largest torque: closer than any fit tells it
BETWEEN = 4001  # angles at which the error is looked for


@dataclass(frozen=True)
class Spring:
    """Above `begins` [rad]: -(first x + second x^2 + third x^3) [N m], x the angle beyond it."""

    begins: float
    first: float
    second: float
    third: float


@dataclass(frozen=True)
class Springs:
    """They and the constant torque add up to a curve, between two angles."""

    constant: float  # N m
    each: tuple[Spring, ...]
    error: float  # N m, the largest between these angles


def springs(curve: Curve, lowest: float, highest: float) -> Springs:
    """A cubic spline through the curve between these angles [rad], in truncated powers."""
    found = None
    for count in COUNTS:
        found = through(curve, np.linspace(lowest, highest, count + 1))
        largest = np.abs(curve(np.linspace(lowest, highest, BETWEEN))).max()
        if found.error <= CLOSE * largest:
            break
    assert found is not None  # there are counts
    return found


def through(curve: Curve, knots: np.ndarray) -> Springs:
    """The spline through its values at these angles."""
    spline = CubicSpline(knots, curve(knots))
    third, second, first, constant = spline.c
    begin = Spring(float(knots[0]), -float(first[0]), -float(second[0]), -float(third[0]))
    more = [
        Spring(float(at), 0.0, 0.0, -float(jump))
        for at, jump in zip(knots[1:-1], np.diff(third), strict=True)
        if jump != 0.0
    ]
    angles = np.linspace(knots[0], knots[-1], BETWEEN)
    error = float(np.abs(spline(angles) - curve(angles)).max())
    return Springs(float(constant[0]), (begin, *more), error)
