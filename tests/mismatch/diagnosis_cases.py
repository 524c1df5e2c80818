"""Recordings with something missing in them, and terms of a user's own."""

from dataclasses import dataclass
from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.leg import LegModel
from exoid.physics.moment import Moment
from exoid.physics.motion.simulate import simulate
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY, NOISE, cycle_torque, leg, state

FRICTION = CoulombFriction(jnp.asarray(0.08))


class Detent(PhysicsTerm):
    """tau = a sin(8 phi): a term of a user's own."""

    title: ClassVar[str] = "detent"
    reference: ClassVar[str] = "a test"
    explanation: ClassVar[str] = "The hinge catches at regular angles."
    isolate: ClassVar[str] = "slow movements"

    size: Float[Any, ""] = parameter("a", "N m", -5.0, 5.0, "size", (0.1,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.size * jnp.sin(8 * now.angle)


class Broken(PhysicsTerm):
    """A term whose derivative is not finite: sqrt of what is zero."""

    title: ClassVar[str] = "broken"
    reference: ClassVar[str] = "a test"
    explanation: ClassVar[str] = "It cannot be differentiated."
    isolate: ClassVar[str] = "none"

    size: Float[Any, ""] = parameter("a", "N m", -5.0, 5.0, "size", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return jnp.sqrt(jnp.abs(self.size)) * now.angle


@dataclass(frozen=True)
class Release:
    """A leg let go at an angle [deg]; with an amplitude [N m] it is moved through one cycle."""

    angle: float
    duration: float = 2.4  # s
    amplitude: float = 0.0


DROPS = (Release(-10), Release(-30), Release(-45))
FINE = 10  # steps of the truth per sample: its own error stays far below the noise


def session(*terms, movements=DROPS, seed=0) -> Recording:
    """A leg with these terms, as its sensors show it."""
    rng = np.random.default_rng(seed)
    segments = tuple(measured(each, terms, rng) for each in movements)
    voluntary = any(each.amplitude for each in movements)
    protocol = Protocol(
        kind="active" if voluntary else "passive",
        cycle_period=tuple(each.duration for each in movements) if voluntary else None,
        torque_frequency="1/T" if voluntary else None,
    )
    return Recording(segments, BODY, protocol, NOISE)


def measured(each: Release, terms, rng) -> Segment:
    time = np.arange(round(each.duration * 100) + 1) / 100
    fine = jnp.asarray(np.arange(FINE * (time.size - 1) + 1) / (100 * FINE))
    torque = cycle_torque(each.amplitude, each.duration) if each.amplitude else NoTorque()
    model = LegModel(leg(), torque, terms=terms)
    motion = jax.jit(simulate)(model, state(np.radians(each.angle)), fine)
    noise = rng.normal(size=(2, time.size))
    assert NOISE.angle_noise is not None
    assert NOISE.velocity_noise is not None
    return Segment(
        time,
        raw_angle=np.asarray(motion.shown_angle[::FINE]) + NOISE.angle_noise * noise[0],
        raw_angular_velocity=np.asarray(motion.shown_velocity[::FINE])
        + NOISE.velocity_noise * noise[1],
    )
