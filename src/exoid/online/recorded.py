"""A recording as the samples of a stream, and the sensors that sent them."""

from dataclasses import replace
from math import ceil

import numpy as np

from exoid.online.model.model import Node
from exoid.online.model.sample import Sample
from exoid.recordings.conventions.thin import of_means
from exoid.recordings.measured.samples import usual_step
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.noise import noise_of
from exoid.recordings.signal.smoothed import OF_ANGLE, OF_RATE

PAUSE = 1.0  # s between segments, each of which has a clock of its own
QUICKEST = 0.0049  # s between samples: of what comes more often, means are followed
LEAST = 1e-4, 1e-3  # rad, rad/s: no sensor on a leg scatters by less


def samples_of(recording: Recording) -> Sample:
    """What `replay` takes: the segments one after the other, 1 s apart, by the best angle, the
    gyro and the torque they have, and with the added mass of each:
    `online.replay(belief, online.samples_of(recording))`.

    Two masses in one stream are exact unless the model says how they were weighed (see `Sample`).
    """
    columns, begin = [], 0.0
    for number, segment in enumerate(recording.segments):
        mass = recording.added_mass(number) or 0.0
        distance = recording.added_mass_distance(number)
        if mass and distance is None:
            raise ValueError(
                f"nobody says where the mass of {mass:g} kg of segment {number} sits, which the "
                "online estimator needs to know: give added_mass_distance_m."
            )
        rows = columns_of(segment, begin)
        columns.append([*rows, *(np.full_like(rows[0], each) for each in (mass, distance or 0.0))])
        begin = float(rows[0][-1]) + PAUSE
    return Sample(*map(np.concatenate, zip(*columns, strict=True)))


def columns_of(segment: Segment, begin: float) -> list[np.ndarray]:
    """Time, angle, rate and torque, the first at `begin` [s]; NaN where there is no gyro."""
    together = ceil(QUICKEST / usual_step(segment.time)) if segment.time.size > 1 else 1
    part = of_means(segment, together)
    missing = np.full(part.time.shape, np.nan)
    rates = (part.raw_angular_velocity, part.angular_velocity, missing)
    rate = next(each for each in rates if each is not None)
    torque = np.zeros_like(missing) if part.applied_torque is None else part.applied_torque
    return [part.time - part.time[0] + begin, part.best_angle, rate, torque]


def node_of(recording: Recording) -> Node:
    """The sensors of a recording: how often they sent, how much the samples scatter, and what its
    sidecar says of zero, scale, seat and clock.

    >>> time = np.arange(200) * 0.02  # s
    >>> shaken = 2e-3 * np.random.default_rng(0).standard_normal(200)  # rad
    >>> segment = exoid.Segment(time, raw_angle=-0.35 + shaken)
    >>> node = online.node_of(exoid.Recording((segment,), exoid.Subject(kind="leg")))
    >>> round(node.period, 3)
    0.02
    """
    times, angles, rates, _ = zip(
        *(columns_of(each, 0.0) for each in recording.segments), strict=True
    )
    said, own = recording.sensors, declared(recording)
    of_angle = level_of(times, angles, said.angle_noise, OF_ANGLE, LEAST[0])
    of_rate = level_of(times, rates, said.velocity_noise, OF_RATE, LEAST[1])
    return replace(
        own,
        angle_noise=of_angle or own.angle_noise,
        angle_step=0.0,
        velocity_noise=of_rate or own.velocity_noise,
        velocity_step=0.0,
        period=max(own.period, *(usual_step(each) for each in times)),
    )


def is_smoothed(recording: Recording) -> bool:
    """Did the angle go through a filter before it came here? Its samples share their errors then,
    or hardly have any, and a release is blurred: a model that is right looks wrong. The samples are
    those that were measured, as a fit asks them: means of them share and hide errors, too.
    """
    noise = clean(recording).angle
    return noise.alike_over > 0 or noise.hidden


def declared(recording: Recording) -> Node:
    """A node with what the sidecar of a recording says of zero, scale, seat and clock."""
    sensors, seat = recording.sensors, recording.protocol.thigh_angle_uncertainty
    known = {
        "zero": sensors.angle_zero_uncertainty,
        "scale": sensors.gyro_scale_uncertainty,
        "tilt": seat,
        "slant": None if seat is None else 0.0,
        "clock": sensors.clock_uncertainty,
    }
    return Node(
        **{name: value for name, value in known.items() if value is not None},
        clock_declared=sensors.clock_uncertainty is not None,
        gyro=any(has_gyro(each) for each in recording.segments),
    )


def has_gyro(segment: Segment) -> bool:
    rates = segment.raw_angular_velocity, segment.angular_velocity
    return any(each is not None and bool(np.isfinite(each).any()) for each in rates)


def level_of(times, signals, declared: float | None, swing: float, least: float) -> float | None:
    """The standard deviation of a channel's samples, with the steps in which it is told; None where
    too few samples tell one, and nobody declared it.
    """
    noise = noise_of(list(times), list(signals), declared, swing=swing)
    told = noise.measured is not None or declared is not None
    return max(noise.level, least) if told else None
