"""The fall of a leg that a hand lets go: a damped oscillator, and a torque that sets in evenly.

y'' = min(x / w, 1) - stiffness y - damping y',   y(0) = y'(0) = 0,   x = t - t0
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Table = NDArray[np.float64]
FINE = 5e-4  # s, between the entries of a response
LONGEST = 1.5  # s, of a response


@dataclass(frozen=True)
class Swing:
    """How a leg moves near the angle where it was held, per inertia."""

    stiffness: float  # 1/s^2, gravity's share included
    damping: float  # 1/s


Swings = tuple[Swing, ...]


@lru_cache(maxsize=16)  # every release asks for those of the same few legs
def respond(swings: Swings) -> tuple[Table, Table]:
    """Response of each to a unit step of acceleration, and its integral, every FINE s."""
    x = np.arange(0.0, LONGEST, FINE)
    stiffness, damping = np.array([[each.stiffness, each.damping] for each in swings]).T[..., None]
    decay = damping / 2
    turn = np.sqrt((stiffness - decay**2).astype(complex))
    fading = np.exp(-decay * x)
    cosine, sine = fading * np.cos(turn * x), fading * np.sin(turn * x) / turn
    step = (1 - cosine - decay * sine) / stiffness
    lag = damping / stiffness
    bend = (decay**2 - turn**2) / stiffness
    ramp = (x - lag + lag * cosine + bend * sine) / stiffness
    return np.real(step), np.real(ramp)


@lru_cache(maxsize=16)
def let_go_at_once(swings: Swings, order: int) -> Table:
    """The response to a step, or a derivative of it."""
    step = respond(swings)[0]
    for _ in range(order):
        step = np.gradient(step, FINE, axis=1)
    return step


def falling(since: Table, width: float, swings: Swings, order: int) -> Table:
    """y of the module's docstring, or a derivative, of each swing (first axis), `since` s after t0;
    at once where w = 0.
    """
    if width == 0:
        return read(let_go_at_once(swings, order), since)
    table = respond(swings)[1 if order == 0 else 0]
    return (read(table, since) - read(table, since - width)) / width


def read(tables: Table, since: Table) -> Table:
    """Every table (first axis) at the same times, straight between its entries."""
    place = np.clip(since / FINE, 0.0, tables.shape[1] - 1)
    low = np.minimum(place.astype(int), tables.shape[1] - 2)
    share = place - low
    return tables[:, low] * (1 - share) + tables[:, low + 1] * share
