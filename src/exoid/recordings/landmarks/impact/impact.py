"""A turn that something hard makes: no polynomial follows it, one that was pushed does.

    phi(t) = p(t) + gained s(t - t0, lasting)

with p of degree 4 and s of `pushed`. Every instant and duration counts by its likelihood.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.impact.push import (
    INSTANTS,
    LASTING,
    REACH,
    STEP,
    every_push,
    greatest,
    pushed,
)
from exoid.recordings.measured.samples import Samples

HALF, DEGREE = 0.1, 4  # s to either side, and of the polynomial: as other turns are read
CLEAR = 25.0  # chi-square by which a push must explain more: a drop without one has 23 at most
UNLIKELY = 1e-3  # weight of a push that is not counted
SHAPE = 0.1  # of its acceleration, by which a stop pushes otherwise than by half a sine
FINE = 5e-4  # s between the instants at which the angle may be greatest or least


@dataclass(frozen=True)
class Impact:
    """Where a leg was turned around, and the push that did it."""

    time: float  # s
    time_error: float  # s
    value: float  # rad
    error: float  # rad
    lasting: float  # s
    gained: float  # rad/s, extension positive
    acceleration: float  # rad/s^2, in the middle of the push
    acceleration_error: float  # rad/s^2


@dataclass(frozen=True, eq=False)
class Around:
    """The samples beside a turn, and what polynomials leave of them."""

    time: Samples  # s after it
    angle: Samples  # rad, less their mean
    noise: float  # rad

    @property
    def free(self) -> int:
        """Samples beyond what a polynomial and a push explain."""
        return self.time.size - DEGREE - 4

    @cached_property
    def powers(self) -> NDArray[np.float64]:
        """(sample, power)"""
        return powers_of(self.time)

    def left(self, signals: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of signals (sample last) beside polynomials."""
        basis, _ = np.linalg.qr(self.powers)
        return signals - (signals @ basis) @ basis.T


def powers_of(time: Samples) -> NDArray[np.float64]:
    return np.vander(time / HALF, DEGREE + 1, increasing=True)


def bends_of(time: float) -> Samples:
    """The second derivatives of these powers at one time [1/s^2]."""
    power = np.arange(DEGREE + 1)
    return power * (power - 1) * (time / HALF) ** np.maximum(power - 2, 0) / HALF**2


def impact_at(time: Samples, angle: Samples, noise: float, turn: float, side: int) -> Impact | None:
    """The impact at a `turn` [s] that pushes to a `side`, 1 extension; None where none is needed.

    `time` [s] and `angle` [rad] may begin with a fall: what was before it is another motion.
    """
    first, last = np.searchsorted(time, [turn - HALF, turn + HALF])
    angle = angle[first:last]
    if angle.size <= DEGREE + 4 or not noise > 0:
        return None
    around = Around(time[first:last] - turn, angle - angle.mean(), noise)
    left = around.left(around.angle)
    plain = float(left @ left) / noise**2
    if plain < around.free + CLEAR:
        return None
    pushes = around.left(every_push(around.time))
    size = np.einsum("ps,ps->p", pushes, pushes)
    along = side * (pushes @ left)
    told = (along > 0) & (size > 1e-9 * HALF**2)
    gained = np.where(told, along**2 / np.where(told, size, 1.0), 0.0) / noise**2
    rough = max(1.0, (plain - float(gained.max())) / around.free)
    if gained.max() < CLEAR * rough:
        return None
    weight = np.exp((gained - gained.max()) / 2 / rough)
    found = summed(around, weight, side, rough)
    return replace(found, time=turn + found.time, value=float(angle.mean()) + found.value)


def summed(around: Around, weight: Samples, side: int, rough: float) -> Impact:
    """Over all pushes that count, each by its `weight`; the noise is greater by root `rough`."""
    likely = np.flatnonzero(weight > UNLIKELY)
    share = weight[likely] / weight[likely].sum()
    each = np.array([turned(around, *divmod(int(one), INSTANTS.size), side) for one in likely])
    mean = share @ each
    time, value, error = each.T[:3]
    late = float(np.sqrt(share @ (time - mean[0]) ** 2))
    bent = float(np.sqrt(share @ ((each[:, 4] - mean[4]) ** 2 + rough * each[:, 5] ** 2)))
    between = mean[3] / 4 * STEP  # rad, from one instant that is tried to the next
    unsure = float(np.sqrt(share @ ((value - mean[1]) ** 2 + rough * error**2) + between**2))
    lasting = float(share @ np.array(LASTING)[likely // INSTANTS.size])
    return Impact(
        time=float(mean[0]),
        time_error=max(late, FINE),
        value=float(mean[1]),
        error=unsure,
        lasting=lasting,
        gained=float(mean[3]),
        acceleration=float(mean[4]),
        acceleration_error=float(np.hypot(bent, SHAPE * mean[4])),
    )


def turned(around: Around, lasting: int, instant: int, side: int) -> tuple[float, ...]:
    """Where an angle turns with one push: s, rad, its error by the noise, rad/s gained, and rad/s^2
    in the middle of the push with their error by the noise.
    """
    push = LASTING[lasting], float(INSTANTS[instant])
    own = pushed(around.time - push[1], push[0])
    inverse = np.linalg.pinv(np.column_stack([around.powers, own]))
    times = np.arange(-REACH, REACH + FINE / 2, FINE)
    table = np.column_stack([powers_of(times), pushed(times - push[1], push[0])])
    found = inverse @ around.angle
    curve = table @ found
    at = int(np.argmin(side * curve))
    error = around.noise * float(np.linalg.norm(table[at] @ inverse))
    bend = np.append(bends_of(push[1]), greatest(push[0]))
    bent = float(bend @ found), around.noise * float(np.linalg.norm(bend @ inverse))
    return float(times[at]), float(curve[at]), error, float(found[-1]), *bent
