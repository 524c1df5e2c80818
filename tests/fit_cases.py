"""Legs, motions and recordings that the tests of the fit share. Few lengths: each compiles anew."""

from dataclasses import replace
from functools import cache

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, Shared
from exoid.fitting.model.mounting import Mounting
from exoid.physics.leg import GRAVITY, LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.torque import CycleTorque, NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

# Damping and stiffness are the leg's alone, whatever it bears: `test_under_load.py` has others.
STEADY = Subject(damping_under_load_uncertainty=0.0, stiffness_under_load_uncertainty=0.0)
BODY = replace(STEADY, kind="leg", body_mass=74.0, height=1.78)
NOISE = Sensors(angle_noise=8.7e-4, velocity_noise=1.8e-3)  # what the exoskeleton's sensors have
DROP = Movement(np.radians(-12), 2.3)
LOADED = Movement(np.radians(-12), 2.3, added_mass=1.0, added_mass_distance=0.4)
UNMOVED = Mounting(*[np.zeros(0)] * 14)  # of a recording that is just as declared
CYCLE = Movement(np.radians(-6), 1.19, amplitude=-4.0)


def leg(mass=4.5, inertia=0.42, com_distance=0.26, damping=0.33, stiffness=2.6) -> LegParameters:
    return LegParameters(
        *(jnp.asarray(x, float) for x in (mass, inertia, com_distance, damping, stiffness))
    )


@cache  # a recording is not changed by anyone, and every session traces its motion anew
def recorded(*movements: Movement, seed: int = 0, subject: Subject = BODY, **parameters):
    """A session on the virtual exoskeleton, as its sensors see it."""
    model = LegModel(leg(**parameters), NoTorque())
    return record(model, movements, jax.random.key(seed), subject=subject)


simulated = eqx.filter_jit(simulate)


def exact(model: LegModel, start: LegState, time: np.ndarray, **channels) -> Segment:
    """A motion without any noise."""
    motion = simulated(model, start, jnp.asarray(time))
    return Segment(
        time,
        raw_angle=np.asarray(motion.angle),
        raw_angular_velocity=np.asarray(motion.angular_velocity),
        **channels,
    )


def state(angle: float, angular_velocity: float = 0.0) -> LegState:
    return LegState(jnp.asarray(angle, float), jnp.asarray(angular_velocity, float))


def cycle_torque(amplitude=-4.0, period=1.19, onset=0.0, cycles=1.0) -> CycleTorque:
    return CycleTorque(
        *(jnp.asarray(x, float) for x in (amplitude, period, cycles / period, onset))
    )


def one(segment: Segment, kind="passive", subject: Subject = BODY, **protocol) -> Recording:
    """A recording of one segment with the sensors' noise declared."""
    return Recording((segment,), subject, Protocol(kind=kind, **protocol), NOISE)


def coordinates_of(parameters: LegParameters, own: list[tuple[float, float, float]]) -> Coordinates:
    """The fit's coordinates of a leg, and of (tau, angle, angular velocity) of every segment."""
    torque, angle, velocity = np.array(own, dtype=float).T
    m, j, l, d, c = (np.asarray(leaf) for leaf in jax.tree.leaves(parameters))  # noqa: E741
    shared = Shared(
        np.log(j), np.asarray(m * l * GRAVITY / j), np.asarray(c / j), np.asarray(d / j)
    )
    return Coordinates(shared, np.log(m), UNMOVED, SegmentUnknowns(torque / j, angle, velocity))
