"""Who learns the leg: the node itself, or exoid.online at the host, which follows the node.

Drops alone tell neither an inertia: theirs is what anatomy expects of body mass and height, with
the frame's own, which is known.
"""

from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from benchmarks.closed_loop.host import Told
from benchmarks.closed_loop.rig import GRAVITY, Body, Frame
from benchmarks.closed_loop.sensors import Seen

import exoid
from exoid import online
from exoid.online import Trust
from exoid.physics.anatomy import ExpectedLeg
from exoid.physics.terms.device.coulomb_friction import CoulombFriction

TRUSTED = Trust.GOOD, Trust.ENOUGH
DOUBTED = Trust.UNEXPLAINED, Trust.CHANGED, Trust.FAULTY
BLOCK = 32  # samples that the host's learner takes at once
MODEL = online.Model(online.Unknowns((CoulombFriction,)))
FRICTION = "coulomb_friction.level_over_inertia"


@dataclass(frozen=True)
class Known:
    """A leg in its frame, as one is to be carried."""

    gravity: float  # m l g / J [1/s^2]
    stiffness: float  # c / J [1/s^2]
    damping: float  # d / J [1/s]
    inertia: float  # kg m^2
    friction: float = 0.0  # over J [rad/s^2]
    zero: float = 0.0  # rad, that the encoder shows where the knee is extended


class Learner(Protocol):
    """One of them."""

    @abstractmethod
    def __init__(self, body: Body, frame: Frame) -> None:
        """Of whom a scale and a tape tell, in a frame that is known."""

    trust: Trust
    drops: int

    @abstractmethod
    def see(self, seen: Seen, told: Told) -> None:
        """A tick: what the chips showed, and what the node told."""

    @abstractmethod
    def leg(self) -> Known:
        """The leg as it is known."""

    @abstractmethod
    def anew(self, body: Body) -> "Learner":
        """The same, told that it is another body's leg from now on."""

    @property
    def knows(self) -> bool:
        return self.trust in TRUSTED and self.drops > 0


class ByNode(Learner):
    """The node's own, in C++: ratios, and not where its encoder's zero is."""

    def __init__(self, body: Body, frame: Frame) -> None:
        self.trust, self.drops = Trust.WAITING, 0
        self._frame, self._inertia = frame, worn(body, frame).inertia.value
        self._told = Told()

    def see(self, seen: Seen, told: Told) -> None:
        self.trust, self.drops, self._told = Trust(told.trust), told.drops, told

    def leg(self) -> Known:
        gravity, stiffness, damping, _ = self._told.ratios
        return Known(gravity, stiffness, damping, self._inertia, self._told.friction)

    def anew(self, body: Body) -> "ByNode":
        """The node needs no word: it has found that by itself."""
        other = ByNode(body, self._frame)
        other.trust, other.drops = self.trust, self.drops
        return other


class ByHost(Learner):
    """exoid.online with dry friction: it takes blocks of samples."""

    def __init__(self, body: Body, frame: Frame) -> None:
        self.trust, self.drops = Trust.WAITING, 0
        self._frame, self._belief = frame, online.init(worn(body, frame), MODEL)
        self._rows: list[tuple[float, ...]] = []

    def see(self, seen: Seen, told: Told) -> None:
        self._rows.append((seen.time, seen.angle, seen.rate))
        if len(self._rows) < BLOCK:
            return
        samples = online.Sample(*np.array(self._rows).T)
        self._belief, said = online.replay(self._belief, samples, MODEL)
        self._rows.clear()
        self.trust, self.drops = Trust(int(said.trust[-1])), int(said.drops[-1])

    def leg(self) -> Known:
        every = online.estimates(self._belief, MODEL)
        names = "gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia", "inertia"
        found = [every[name].value for name in (*names, FRICTION, "zero")]
        return Known(*found)

    def anew(self, body: Body) -> "ByHost":
        return ByHost(body, self._frame)


def worn(body: Body, frame: Frame) -> ExpectedLeg:
    """What anatomy expects of a body's leg, with the mass and the inertia of the frame."""
    leg = exoid.expected_leg(body.mass, body.height)
    mass = leg.mass.value + frame.mass
    weight = leg.mass.value * leg.com_distance.value * GRAVITY + frame.weight
    values = {
        "mass": mass,
        "com_distance": weight / mass / GRAVITY,
        "inertia": leg.inertia.value + frame.inertia,
    }
    return replace(
        leg, **{name: replace(getattr(leg, name), value=value) for name, value in values.items()}
    )
