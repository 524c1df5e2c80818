"""The fall of a leg that a hand lets go: a damped oscillator, and a torque that sets in evenly.

y'' = min(x / w, 1) - stiffness y - damping y',   y(0) = y'(0) = 0,   x = t - t0
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.samples import Samples

Table = NDArray[np.float64]
FINE = 5e-4  # s, between the entries of a response
LONGEST = 1.5  # s, of a response


@dataclass(frozen=True)
class Swing:
    """How a leg moves near the angle where it was held, per inertia."""

    stiffness: float  # 1/s^2, gravity's share included
    damping: float  # 1/s


def respond(swing: Swing) -> tuple[Samples, Samples]:
    """Response to a unit step of acceleration and its integral, every FINE s."""
    x = np.arange(0.0, LONGEST, FINE)
    decay = swing.damping / 2
    turn = np.sqrt(complex(swing.stiffness - decay**2))
    fading = np.exp(-decay * x)
    cosine, sine = fading * np.cos(turn * x), fading * np.sin(turn * x) / turn
    step = (1 - cosine - decay * sine) / swing.stiffness
    lag = swing.damping / swing.stiffness
    bend = (decay**2 - turn**2) / swing.stiffness
    ramp = (x - lag + lag * cosine + bend * sine) / swing.stiffness
    return np.real(step), np.real(ramp)


def falling(since: Table, width: float, swing: Swing, order: int) -> Table:
    """y of the module's docstring, or a derivative, `since` s after t0; at once where w = 0."""
    step, ramp = respond(swing)
    if width == 0:
        for _ in range(order):
            step = np.gradient(step, FINE)
        return read(step, since)
    table = ramp if order == 0 else step
    return (read(table, since) - read(table, since - width)) / width


def read(table: Samples, since: Table) -> Table:
    return np.interp(np.maximum(since, 0.0), FINE * np.arange(table.size), table)
