"""Legs that SciPy moved, as sensors with faults show them: drops from a hold, and voluntary cycles.

Nothing of exoid moves or shows these legs but its containers.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp
from scipy.signal import butter, lsim

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import ADULT, Hand, Knee, motion

BODY = Subject(kind="leg", body_mass=74.0, height=1.78)
PENDULUM = Subject(kind="rig")
NOISE = (8e-4, 3e-3)  # rad, rad/s
STARTS = (-0.05, -0.3, -0.6)  # rad, of drops
BEFORE = 0.7  # s that a hand holds the leg
CYCLES = ((1.5, 17.0), (1.8, 16.5), (2.4, 16.0), (1.6, 18.0))  # s, 1/s^2: periods, torques over J
FIRST = -0.25  # rad, where cycles begin
FINE = 1e-3  # s, of what a filter sees


@dataclass(frozen=True)
class Faults:
    """What encoder, gyro and clock do wrong."""

    zero: float = 0.0  # rad, of the encoder
    zero_drift: float = 0.0  # rad/s
    gain: float = 0.0
    first: tuple[float, float] = (0.0, 0.0)  # rad, once per turn
    second: tuple[float, float] = (0.0, 0.0)  # rad, twice per turn
    scale: float = 0.0  # of the gyro
    bias: float = 0.0  # rad/s
    bias_drift: float = 0.0  # rad/s^2
    delay: float = 0.0  # s, of the gyro
    clock: float = 0.0  # true seconds in a recorded one, less 1
    smoothed: float = 0.0  # s, time constant of a gyro's filter of first order
    held_back: float = 0.0  # s, delay of an encoder's Butterworth filter of second order

    def angle(self, time, true):
        """What the encoder shows of true angles."""
        wave = sum(
            one[0] * np.sin(order * true) + one[1] * np.cos(order * true)
            for order, one in ((1, self.first), (2, self.second))
        )
        return true + self.gain * true + wave + self.zero + self.zero_drift * time

    def rate(self, time, true):
        """What the gyro shows of the true rates of its delayed instants."""
        return (1 + self.scale) * true + self.bias + self.bias_drift * time

    def filtered(self, moving: "Moving") -> "Moving":
        """The motion as sensors behind filters see it."""
        encoder, gyro = ([1.0], [1.0]), ([1.0], [self.smoothed, 1.0])
        if self.held_back:
            encoder = butter(2, np.sqrt(2) / self.held_back, analog=True)

        def seen(time):
            fine = np.arange(0.0, time[-1] + FINE, FINE)
            angle, rate = moving(fine)
            behind = angle[0] + lsim(encoder, angle - angle[0], fine)[1]
            return np.array(
                [np.interp(time, fine, each) for each in (behind, lsim(gyro, rate, fine)[1])]
            )

        return seen if self.smoothed or self.held_back else moving


Moving = Callable[[np.ndarray], np.ndarray]  # true times to (angle, rate)


def drops(
    faults: Faults,
    knee: Knee = ADULT,
    *,
    starts=STARTS,
    before=BEFORE,
    gyro=True,
    seed=0,
    rate=100.0,
    lasting=6.0,
    body=BODY,
) -> Recording:
    """Drops from several angles, every one held still by a hand `before` [s]."""
    random = np.random.default_rng(seed)
    segments = []
    for start in starts:
        release = before + random.random() / rate
        hand = Hand(start, fade=0.0)

        def moving(time, hand=hand, release=release):
            return motion(knee, hand, time, release)

        time = np.arange(0.0, before + lasting, 1 / rate)
        segments.append(shown(faults, moving, time, random, gyro=gyro))
    return Recording(tuple(segments), body, Protocol(kind="passive"), known(gyro=gyro))


def cycles(faults: Faults, knee: Knee = ADULT, *, gyro=True, seed=0, rate=100.0) -> Recording:
    """Cycles of Eq. 10 with f = 1/T, of several speeds, from rest; T by the recorder's clock."""
    random = np.random.default_rng(seed)
    segments = []
    for period, torque in CYCLES:
        time = np.arange(0.0, period / (1 + faults.clock), 1 / rate)
        moving = cycled(knee, period, torque)
        segments.append(shown(faults, moving, time, random, gyro=gyro))
    periods = tuple(period / (1 + faults.clock) for period, _ in CYCLES)
    protocol = Protocol(kind="active", cycle_period=periods, torque_frequency="1/T")
    return Recording(tuple(segments), BODY, protocol, known(gyro=gyro))


def cycled(knee: Knee, period: float, torque: float) -> Moving:
    """J phi'' = tau |sin(2 pi t / T)| + Eq. 9 from the release at 0 on; at rest before."""

    def slope(time, state):
        push = torque * abs(np.sin(2 * np.pi * time / period))
        return state[1], push + knee.pull(state[0], state[1])

    turns = [0.0, period / 2, 2 * period]

    def moving(time):
        found = np.tile([[FIRST], [0.0]], time.size)
        state = np.array([FIRST, 0.0])
        for begin, end in pairwise(turns):
            inside = (time >= begin) & (time < end)
            every = np.append(time[inside], end)
            run = solve_ivp(slope, (begin, end), state, t_eval=every, rtol=1e-9, atol=1e-10)
            found[:, inside], state = run.y[:, :-1], run.y[:, -1]
        return found

    return moving


def shown(faults: Faults, moving: Moving, time, random, *, gyro: bool) -> Segment:
    """A motion as the sensors show it at recorded times."""
    true, moving = (1 + faults.clock) * time, faults.filtered(moving)
    noise = random.normal(size=(2, time.size))
    angle = faults.angle(time, moving(true)[0]) + NOISE[0] * noise[0]
    late = moving(true - faults.delay)[1]
    rate = faults.rate(time, late) + NOISE[1] * noise[1] if gyro else None
    return Segment(time, raw_angle=angle, raw_angular_velocity=rate)


def known(*, gyro: bool) -> Sensors:
    return Sensors(angle_noise=NOISE[0], velocity_noise=NOISE[1] if gyro else None)
