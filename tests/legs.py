"""Drops of legs that obey Eq. 9, by SciPy: nothing of exoid but its containers."""

from functools import cache

import numpy as np
from scipy.integrate import solve_ivp

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

ADULT = (27.5, 6.0, 0.8)  # m l g / J and c / J [1/s^2], d / J [1/s]
CHILD = (45.0, 9.0, 1.2)
SPASTIC = (28.0, 25.0, 9.0)
BODY = Subject(kind="leg", body_mass=74.0, height=1.78)


@cache
def fall(leg=ADULT, start=-0.2, duration=6.0, step=0.01, thigh=0.0, slack=0.0, end=(0.0, 1.0)):
    """Time, angle and angular velocity of a leg that is let go at rest; `end` is the moment at full
    extension over J [1/s^2], and the angle over which it grows e-fold [rad].
    """
    gravity, stiffness, damping = leg

    def slope(_, state):
        angle, speed = state
        pull = gravity * np.cos(angle + thigh) + stiffness * (angle - slack)
        return speed, -pull - damping * speed - end[0] * np.exp(angle / end[1])

    time = np.arange(0.0, duration, step)
    found = solve_ivp(slope, (0.0, duration), (start, 0.0), t_eval=time, rtol=1e-9, atol=1e-9)
    return time, found.y[0], found.y[1]


def drop(leg=ADULT, start=-0.2, *, gyro=True, seed=0, noise=(8e-4, 3e-3), **how) -> Segment:
    """What an encoder and a gyro make of it."""
    time, angle, speed = fall(leg, start, **how)
    random = np.random.default_rng(seed)
    return Segment(
        time,
        raw_angle=angle + noise[0] * random.standard_normal(time.size),
        raw_angular_velocity=speed + noise[1] * random.standard_normal(time.size) if gyro else None,
    )


def recording(*segments: Segment, **tables) -> Recording:
    """Of one adult, by the sensors' data sheets."""
    told = {"subject": BODY, "protocol": Protocol(kind="passive")}
    noise = Sensors(angle_noise=8e-4, velocity_noise=3e-3)
    return Recording(segments, **{**told, "sensors": noise, **tables})


def balance_of(leg, thigh=0.0) -> float:
    """Where Eq. 9 holds a leg at rest: m l g cos(angle + thigh) = -c angle."""
    gravity, stiffness, _ = leg
    angles = np.linspace(-np.pi / 2 - abs(thigh) - 0.1, 0.0, 200_001)
    left = gravity * np.cos(angles + thigh) + stiffness * angles
    return float(angles[np.argmin(np.abs(left))])
