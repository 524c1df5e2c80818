"""A torque over the angle as springs that begin to pull at one angle each."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from exoid.interchange.formats.mujoco.by_variable import Curve

FIRST, MOST = 8, 96  # pieces: to begin with, and so many that no more are halved
CLOSE = 1e-5  # of the torque, or of what is usual where that is more: closer than any fit tells it
BETWEEN = 4001  # angles at which the error is looked for


@dataclass(frozen=True)
class Spring:
    """Above `begins` [rad]: -(first x + second x^2 + third x^3) [N m], x the angle beyond it."""

    begins: float
    first: float
    second: float
    third: float

    def pull(self, angles: np.ndarray) -> np.ndarray:
        beyond = np.maximum(angles - self.begins, 0.0)
        return -(self.first * beyond + self.second * beyond**2 + self.third * beyond**3)


@dataclass(frozen=True)
class Springs:
    """They and the constant torque add up to a curve, between two angles."""

    constant: float  # N m
    each: tuple[Spring, ...]
    error: float  # N m, the largest between these angles
    share: float  # of the torque, or of what is usual where that is more


def springs(curve: Curve, lowest: float, highest: float, usual: float) -> Springs:
    """A cubic spline through the curve between these angles [rad], in truncated powers; a piece
    that is off is halved. Torques are `usual` [N m].
    """
    knots = np.linspace(lowest, highest, FIRST + 1)
    angles = np.linspace(lowest, highest, BETWEEN)
    wanted = curve(angles)
    near = np.maximum(np.abs(wanted), usual or np.abs(wanted).max())
    while True:
        constant, found = through(curve, knots)
        off = np.abs(constant + sum(each.pull(angles) for each in found) - wanted)
        pieces = np.clip(np.searchsorted(knots, angles, side="right") - 1, 0, knots.size - 2)
        poor = np.unique(pieces[off > CLOSE * near])
        if poor.size == 0 or knots.size + poor.size > MOST + 1:
            return Springs(constant, found, float(off.max()), float((off / near).max()))
        knots = np.sort(np.append(knots, (knots[poor] + knots[poor + 1]) / 2))


def through(curve: Curve, knots: np.ndarray) -> tuple[float, tuple[Spring, ...]]:
    """The constant and the springs of the spline through its values at these angles."""
    spline = CubicSpline(knots, curve(knots))
    third, second, first, constant = spline.c
    begin = Spring(float(knots[0]), -float(first[0]), -float(second[0]), -float(third[0]))
    more = [
        Spring(float(at), 0.0, 0.0, -float(jump))
        for at, jump in zip(knots[1:-1], np.diff(third), strict=True)
        if jump != 0.0
    ]
    return float(constant[0]), (begin, *more)
