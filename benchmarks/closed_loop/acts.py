"""What hands and muscles do to the leg: torques on it, one act after the other."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from benchmarks.closed_loop.plant import State
from benchmarks.closed_loop.rig import Leg

HAND = 300.0, 15.0  # N m/rad, N m s/rad: an arm that holds a heel
STOPPING, STOPPED = 0.06, 0.3  # s by which it slows a swinging leg, and after which it carries it
GRASP = 0.05  # s that it takes to hold firmly
EFFORT = 60.0, 6.0  # N m/rad, N m s/rad: by which a muscle corrects what it did not expect


class Act(Protocol):
    """One of them; it lasts `seconds`."""

    seconds: float

    @abstractmethod
    def begin(self, state: State, leg: Leg) -> None:
        """It begins now."""

    @abstractmethod
    def torque(self, elapsed: float, state: State) -> float:
        """On the leg [N m], so long after its begin."""


@dataclass
class Carry:
    """A hand stops the leg, brings it to an angle, and holds it there."""

    to: float  # rad
    moving: float  # s
    seconds: float

    def begin(self, state: State, leg: Leg) -> None:
        self.caught, self.stop = state, state.angle + STOPPING * state.rate

    def torque(self, elapsed: float, state: State) -> float:
        left = np.exp(-elapsed / STOPPING)
        way = smooth(np.clip((elapsed - STOPPED) / self.moving, 0.0, 1.0))
        wanted = self.stop + (self.to - self.stop) * way - STOPPING * self.caught.rate * left
        rate = self.caught.rate * left
        grasp = min(elapsed / GRASP, 1.0)
        return grasp * (HAND[0] * (wanted - state.angle) + HAND[1] * (rate - state.rate))


@dataclass
class Drop:
    """The hand lets go of a leg that it held, which swings."""

    letting_go: float  # s
    seconds: float
    held: Carry

    def begin(self, state: State, leg: Leg) -> None:
        pass

    def torque(self, elapsed: float, state: State) -> float:
        if elapsed >= self.letting_go:
            return 0.0
        return (1 - elapsed / self.letting_go) * self.held.torque(self.held.seconds, state)


@dataclass
class Move:
    """The person raises and lowers the leg: by what a bare leg needs and a correction."""

    swing: float  # rad
    period: float  # s
    seconds: float

    def begin(self, state: State, leg: Leg) -> None:
        self.start, self.leg = state.angle, leg

    def torque(self, elapsed: float, state: State) -> float:
        angle, rate, acceleration = self.wanted(elapsed)
        leg = self.leg
        known = leg.inertia * acceleration + leg.weight * np.cos(angle)
        known += leg.stiffness * angle + leg.damping * rate
        begun = min(elapsed / GRASP, 1.0)
        return begun * (known + EFFORT[0] * (angle - state.angle) + EFFORT[1] * (rate - state.rate))

    def wanted(self, elapsed: float) -> tuple[float, float, float]:
        """Angle, rate and acceleration."""
        turn, half = 2 * np.pi / self.period, self.swing / 2
        phase = turn * elapsed
        return (
            self.start + half * (1 - np.cos(phase)),
            half * turn * np.sin(phase),
            half * turn**2 * np.cos(phase),
        )


@dataclass
class Rest:
    """Nobody touches the leg."""

    seconds: float

    def begin(self, state: State, leg: Leg) -> None:
        pass

    def torque(self, elapsed: float, state: State) -> float:
        return 0.0


def smooth(share: float) -> float:
    """From 0 to 1 with no jerk at either end."""
    return share**3 * (10 - 15 * share + 6 * share**2)
