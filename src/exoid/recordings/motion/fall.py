"""The fall of a leg that a hand lets go, as it is and in the samples that it is compared with: a
damped oscillator, and a torque that sets in evenly.

y'' = min(x / w, 1) - stiffness y - damping y',   y(0) = y'(0) = 0,   x = t - t0
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.left_over import beside, left_beside, orthonormal
from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.signal import Signal

Table = NDArray[np.float64]
FINE = 5e-4  # s, between the entries of a response
LONGEST = 1.5  # s, of a response
BELIEVED = 3  # rows without a sample, for what is believed of three further amplitudes


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
def tables(swings: Swings, order: int, *, at_once: bool) -> tuple[Table, Table]:
    """What a read takes: a response with a row every FINE s, and by how much it grows until the
    next. Of the step at once, of its integral otherwise; or a derivative of either.
    """
    step, ramp = respond(swings)
    found = step if at_once else (ramp, step)[order]
    for _ in range(order if at_once else 0):
        found = np.gradient(found, FINE, axis=1)
    return np.ascontiguousarray(found.T[:-1]), np.ascontiguousarray(np.diff(found, axis=1).T)


def falling(since: Table, widths: Samples, swings: Swings, order: int) -> Table:
    """y of the module's docstring, or a derivative, for each width (first axis) and swing (last),
    `since` s after t0; at once where w = 0.
    """
    found = np.empty((widths.size, *since.shape, len(swings)))
    slow = widths > 0
    if not slow.all():
        found[~slow] = read(tables(swings, order, at_once=True), since)
    if slow.any():
        width = widths[slow, None, None]
        table = tables(swings, order, at_once=False)
        found[slow] = (read(table, since) - read(table, since - width)) / width[..., None]
    return found


def read(table: tuple[Table, Table], since: Table) -> Table:
    """A table at some times, straight between its rows."""
    values, growth = table
    place = np.clip(since / FINE, 0.0, values.shape[0])
    low = np.minimum(place.astype(int), values.shape[0] - 1)
    found = np.take(growth, low, axis=0)
    found *= (place - low)[..., None]
    found += np.take(values, low, axis=0)
    return found


@dataclass(frozen=True, eq=False)
class Rows:
    """What is compared: rows of what is believed, then angles, then velocities.

    Measured values are over their noise and about their mean, which is free.
    """

    time: Samples  # s
    velocity: int  # the first row of a velocity
    scale: Samples  # 1 over the noise of each
    data: Samples
    levels: Table  # (channel, row): the means, of length 1
    scatter: float  # chi-square of what was summed up in one row

    def fallen(self, since: Table, widths: Samples, legs: Swings, begun: int = 0) -> Table:
        """What each leg falls `since` it was let go, or a derivative of it: a table of rows and
        legs for every width and instant, in turn.
        """
        each = [falling(since[:, : self.velocity], widths, legs, begun)]
        if self.velocity < self.time.size:
            each.append(falling(since[:, self.velocity :], widths, legs, begun + 1))
        found = np.concatenate(each, axis=2) * self.scale[:, None]
        return found.reshape(-1, *found.shape[2:])

    def left(self, columns: Table, fall: Table) -> Table:
        """Chi-square beside the means, some columns (set, column, row), which are overwritten, and
        each further one in turn (set, row, one): (set, one).
        """
        basis = orthonormal(beside(columns, self.levels))
        return left_beside(basis, self.levels, fall, self.data) + self.scatter


def rows_of(signal: Signal, begin: float) -> Rows:
    """Nothing moves until `begin` [s]: what was measured until then is one row of each channel."""
    channels = [(signal.angle, signal.angle_noise), (signal.velocity, signal.velocity_noise)]
    each = [
        summed_up(signal.time, samples, noise, begin)
        for samples, noise in channels
        if samples is not None
    ]
    parts = [np.zeros((4, BELIEVED)), *(part for part, _ in each)]
    time, weight, scale, data = np.concatenate(parts, axis=1)
    time[:BELIEVED] = min(begin, signal.time[0])
    ends = np.cumsum([part.shape[1] for part in parts])
    levels = np.zeros((len(each), time.size))
    for level, first, last in zip(levels, ends, ends[1:], strict=False):
        level[first:last] = weight[first:last] / max(float(np.linalg.norm(weight[first:last])), 1.0)
    data = data - (levels @ data) @ levels
    return Rows(time, int(ends[1]), scale, data, levels, sum(scatter for _, scatter in each))


def summed_up(time: Samples, samples: Samples, noise: float, begin: float) -> tuple[Table, float]:
    """Time, weight, scale and value over the noise of every row of a channel; those until `begin`
    are one, and the chi-square about it.
    """
    known = ~np.isnan(samples)
    time, values = time[known], samples[known] / noise
    weight = np.ones(time.size)
    held = int(np.searchsorted(time, begin, side="right"))
    if held < 2:
        return np.stack([time, weight, weight / noise, values]), 0.0
    middle = float(values[:held].mean())
    scatter = float(np.sum((values[:held] - middle) ** 2))
    values[held - 1], weight[held - 1] = middle * np.sqrt(held), np.sqrt(held)
    rows = np.stack([time, weight, weight / noise, values])
    return rows[:, held - 1 :], scatter
