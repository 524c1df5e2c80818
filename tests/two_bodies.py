"""Drops of a leg in a frame with play between them, by SciPy: two bodies, each with its own weight.

Nothing of exoid moves them. The sensors ride on the frame.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

STARTS = (-0.1, -0.4, -0.7)  # rad
COUNT = 2 * np.pi / 4096  # rad, of the encoder
CREEP = 2e-3  # rad/s, within which dry friction passes through zero
DEEP = 3e-4  # rad, at which a contact's damper has its full strength


@dataclass(frozen=True)
class Leg:
    """J phi'' = -gravity cos(phi) - stiffness phi - damping phi' - friction sgn(phi') - contact."""

    inertia: float = 0.42  # kg m^2
    gravity: float = 11.5  # N m
    stiffness: float = 2.2  # N m/rad
    damping: float = 0.25  # N m s/rad
    friction: float = 0.0  # N m


@dataclass(frozen=True)
class Frame:
    """J_e q'' = contact - gravity cos(q) - damping q' - friction sgn(q'); free within the play."""

    half_play: float = 0.015  # rad
    inertia: float = 0.012  # kg m^2
    gravity: float = 0.6  # N m
    friction: float = 0.05  # N m
    damping: float = 0.02  # N m s/rad
    stiffness: float = 600.0  # N m/rad, of the contact
    damping_ratio: float = 0.6  # of the contact, with the frame's inertia


@dataclass(frozen=True)
class Session:
    """How the drops are made and recorded."""

    starts: tuple[float, ...] = STARTS
    hold: float = 0.5  # s at rest before the release
    lasting: float = 5.0  # s
    rate: float = 100.0  # Hz
    angle_noise: float = 5e-4  # rad, beside the counts
    gyro_noise: float = 5e-3  # rad/s


def contact(frame: Frame, slip: float, rate: float) -> float:
    """What the leg pushes the frame with [N m]; slip = q - phi. It never pulls."""
    depth, way = abs(slip) - frame.half_play, np.sign(slip)
    if depth <= 0:
        return 0.0
    damper = 2 * frame.damping_ratio * np.sqrt(frame.stiffness * frame.inertia)
    push = frame.stiffness * depth + damper * min(depth / DEEP, 1.0) * way * rate
    return -way * max(push, 0.0)


def resting(frame: Frame, angle: float) -> float:
    """The frame's slip on a leg that is held still."""
    weight = frame.gravity * np.cos(angle)
    return -np.sign(weight) * frame.half_play - weight / frame.stiffness


def slopes(leg: Leg, frame: Frame, y: np.ndarray) -> np.ndarray:
    angle, rate, place, speed = y
    pushed = contact(frame, place - angle, speed - rate)
    pulled = -leg.gravity * np.cos(angle) - leg.stiffness * angle - leg.damping * rate
    pulled -= leg.friction * np.tanh(rate / CREEP) + pushed
    moved = pushed - frame.gravity * np.cos(place) - frame.damping * speed
    moved -= frame.friction * np.tanh(speed / CREEP)
    return np.array([rate, pulled / leg.inertia, speed, moved / frame.inertia])


def motion(leg: Leg, frame: Frame, start: float, time: np.ndarray) -> np.ndarray:
    """(phi, phi', q, q') at `time`, from rest at its first."""
    begin = np.array([start, 0.0, start + resting(frame, start), 0.0])
    found = solve_ivp(
        lambda _, y: slopes(leg, frame, y),
        (time[0], time[-1]),
        begin,
        method="LSODA",
        t_eval=time,
        rtol=1e-8,
        atol=1e-10,
        max_step=2e-3,
    )
    return found.y


def recorded(leg: Leg, frame: Frame, how: Session, seed: int = 0) -> Recording:
    """The drops as encoder and gyro on the frame show them."""
    random = np.random.default_rng(seed)
    segments = []
    for start in how.starts:
        time = np.arange(round((how.hold + how.lasting) * how.rate)) / how.rate
        release = how.hold + random.random() / how.rate if how.hold else 0.0
        after = time > release
        fallen = motion(leg, frame, start, np.concatenate([[release], time[after]]))
        held = np.repeat(fallen[:, :1], (~after).sum(), axis=1)
        _, _, place, speed = np.concatenate([held, fallen[:, 1:]], axis=1)
        angle = place + how.angle_noise * random.standard_normal(time.size)
        gyro = speed + how.gyro_noise * random.standard_normal(time.size)
        segments.append(
            Segment(time, raw_angle=COUNT * np.round(angle / COUNT), raw_angular_velocity=gyro)
        )
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    noise = np.sqrt(how.angle_noise**2 + COUNT**2 / 12)
    known = Sensors(angle_noise=float(noise), velocity_noise=how.gyro_noise)
    return Recording(tuple(segments), body, Protocol(kind="passive"), known)
