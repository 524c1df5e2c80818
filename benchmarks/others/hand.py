"""What a hand does: hold still, let go, leave alone, catch, lift. Each is rows for `march`."""

from dataclasses import dataclass

import numpy as np

from .leg import Physics
from .motion import TICK, static_torque

FIRM = 30.0  # grip stiffness over m l g, per rad: a hand is much stiffer than the leg is heavy
DAMPED = 1.4  # of the grip, over the root of stiffness and inertia
YIELD = 0.08  # s, in which a catching hand comes to a stop


@dataclass(frozen=True)
class Tremor:
    """The hand's own shaking about where it holds."""

    size: float  # rad
    frequency: tuple[float, float]  # Hz
    phase: tuple[float, float]  # rad

    def at(self, time: np.ndarray) -> np.ndarray:
        waves = zip(self.frequency, self.phase, strict=True)
        return self.size * sum(np.sin(2 * np.pi * f * time + p) for f, p in waves) / 2**0.5


def grip_of(physics: Physics) -> tuple[float, float]:
    """Stiffness in N m/rad and damping in N m s/rad of a hand about the knee."""
    stiffness = FIRM * physics.weight
    return stiffness, DAMPED * float(np.sqrt(stiffness * physics.inertia))


def half_ticks(duration: float) -> np.ndarray:
    """s: a whole number of ticks, with their middles."""
    ticks = max(1, round(duration / TICK))
    return TICK / 2 * np.arange(2 * ticks + 1)


def smooth(share: np.ndarray) -> np.ndarray:
    """From 0 to 1 with no jump of slope."""
    share = np.clip(share, 0.0, 1.0)
    return share * share * (3 - 2 * share)


def rows(weight, support, target) -> np.ndarray:
    """Share of the grip, supporting torque in N m, and where the hand is in rad."""
    return np.stack(np.broadcast_arrays(weight, support, target), axis=-1).astype(float)


def hold(physics: Physics, angle: float, duration: float, tremor: Tremor, clock: float):
    time = half_ticks(duration)
    target = angle + tremor.at(clock + time)
    return rows(np.ones_like(time), static_torque(physics, angle), target)


def let_go(physics: Physics, angle: float, ramp: float, tremor: Tremor, clock: float):
    time = half_ticks(ramp)
    target = angle + tremor.at(clock + time)
    return rows(1 - smooth(time / time[-1]), static_torque(physics, angle), target)


def leave(duration: float) -> np.ndarray:
    """No hand at all."""
    return rows(np.zeros_like(half_ticks(duration)), 0.0, 0.0)


def catch(physics: Physics, angle: float, rate: float, ramp: float) -> np.ndarray:
    """A hand that closes, moving along at first, and stops the leg; it is then held."""
    time = half_ticks(ramp + 3 * YIELD)
    target = angle + rate * YIELD * (1 - np.exp(-time / YIELD))
    return rows(smooth(time / ramp), static_torque(physics, float(target[-1])), target)


def lift(physics: Physics, begin: float, end: float, duration: float) -> np.ndarray:
    """From one angle to another with least jerk (Flash & Hogan, J Neurosci 5(7), 1985)."""
    time = half_ticks(duration)
    s = time / time[-1]
    target = begin + (end - begin) * s**3 * (10 - 15 * s + 6 * s**2)
    support = np.array([static_torque(physics, float(each)) for each in target[::40]])
    return rows(np.ones_like(time), np.interp(time, time[::40], support), target)
