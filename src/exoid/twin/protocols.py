"""Drops and cycles as a user would record them, through the sensors and the firmware's filter."""

from collections.abc import Sequence
from dataclasses import replace

import jax.numpy as jnp
import numpy as np
from jaxtyping import PRNGKeyArray

from exoid.physics.leg import LegModel
from exoid.recordings.declared.protocol import Kind, Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.filter import kalman
from exoid.recordings.filter.constants import CURRENT
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import split
from exoid.twin.motion import FrequencyReading, Movement, perform
from exoid.twin.sensors import TICK, SensorKit, ShownMotion, measure

NOBODY = Subject()


def record(
    model: LegModel, movements: Sequence[Movement], key: PRNGKeyArray, **options
) -> Recording:
    """`session`, cut at its marks: one segment per movement, its time starting at 0."""
    return split(session(model, movements, key, **options))


def session(
    model: LegModel,
    movements: Sequence[Movement],
    key: PRNGKeyArray,
    *,
    kit: SensorKit | None = None,
    subject: Subject = NOBODY,
    torque_frequency: FrequencyReading = "1/T",
    exact: bool = False,
) -> Recording:
    """The continuous log of a session: rest, release, motion, catch, rest, lift, and so on.

    The marks of its protocol run from 1 s before each release to the catch. The torque of `model`
    is replaced by each movement's own. `exact` logs the true motion in place of what sensors and
    filter make of it.
    """
    kit = kit or SensorKit()
    performed = perform(model, movements, torque_frequency, TICK)
    time = np.arange(performed.course.angle.size) * TICK
    starts, ends = (tuple(time[list(at)].tolist()) for at in (performed.start, performed.end))
    return Recording(
        (truth(performed.course, time) if exact else observe(kit, performed.course, time, key),),
        describe_subject(subject, movements),
        describe_protocol(movements, torque_frequency, starts, ends, float(model.thigh_angle)),
        describe_sensors(kit),
    )


def truth(course: ShownMotion, time: np.ndarray) -> Segment:
    """The motion itself, as if sensors and filter were perfect."""
    angle, velocity = np.asarray(course.angle), np.asarray(course.angular_velocity)
    return Segment(time, angle, velocity, np.asarray(course.angular_acceleration), angle, velocity)


def observe(
    kit: SensorKit, course: ShownMotion, time: kalman.Samples, key: PRNGKeyArray
) -> Segment:
    """What the node logs of a motion: raw readings, and its own filter's float32 estimate."""
    seen = measure(kit, course, key)
    ticks = np.full(time.size - 1, TICK, dtype=np.float32)
    angle, rate = (jnp.asarray(raw, jnp.float32) for raw in (seen.angle, seen.angular_velocity))
    state = kalman.filter(ticks, angle, rate).state
    return Segment(
        *(np.asarray(samples, dtype=float) for samples in (time, *state.T)),
        raw_angle=np.asarray(seen.angle, dtype=float),
        raw_angular_velocity=np.asarray(seen.angular_velocity, dtype=float),
        raw_acceleration_x=np.asarray(seen.acceleration_x, dtype=float),
        raw_acceleration_z=np.asarray(seen.acceleration_z, dtype=float),
    )


def describe_subject(subject: Subject, movements: Sequence[Movement]) -> Subject:
    """The subject, with the mass that was fixed to the shank in each movement."""
    if not any(movement.added_mass for movement in movements):
        return subject
    return replace(
        subject,
        added_mass=tuple(movement.added_mass for movement in movements),
        added_mass_distance=tuple(movement.added_mass_distance for movement in movements),
        added_mass_gyration=0.0,  # the twin's are points ...
        damping_under_load_uncertainty=0.0,  # ... that nothing rubs or squeezes for
        stiffness_under_load_uncertainty=0.0,
    )


def describe_protocol(
    movements: Sequence[Movement],
    reading: FrequencyReading,
    starts: tuple[float, ...],
    ends: tuple[float, ...],
    thigh_angle: float,
) -> Protocol:
    """What the user noted: kind and marks of the movements, periods of the cycles, the seat."""
    kinds: tuple[Kind, ...] = tuple(movement.kind for movement in movements)
    voluntary = "active" in kinds
    periods = tuple(m.duration if m.kind == "active" else np.nan for m in movements)
    return Protocol(
        kind=kinds,
        cycle_period=periods if voluntary else None,
        torque_frequency=reading if voluntary else None,
        thigh_angle=thigh_angle or None,
        segment_start=starts,
        segment_end=ends,
    )


def describe_sensors(kit: SensorKit) -> Sensors:
    return Sensors(
        encoder_counts=float(kit.encoder.counts_per_turn),
        angle_noise=float(kit.encoder.noise),
        velocity_noise=float(kit.gyroscope.noise),
        gyro_range=2000.0,
        sample_rate=1 / TICK,
        filter=CURRENT,
    )
