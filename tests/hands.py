"""Drops as a person makes them, by SciPy: held by a hand, let go between two samples, free, lifted.

Nothing of exoid moves these legs, so that what it finds is compared with somebody else's truth.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording


@dataclass(frozen=True)
class Knee:
    """Eq. 9 per inertia: phi'' = hand - gravity cos(phi) - stiffness phi - damping phi'."""

    gravity: float = 28.0  # 1/s^2
    stiffness: float = 5.0  # 1/s^2
    damping: float = 0.5  # 1/s

    def pull(self, angle, rate):
        return -self.gravity * np.cos(angle) - self.stiffness * angle - self.damping * rate


ADULT = Knee()
SPASTIC = Knee(28.0, 12.0, 6.0)


@dataclass(frozen=True)
class Hand:
    """What a hand does. A `lift` pulls the leg to where it was held, from that time on."""

    start: float = -0.3  # rad
    hold: float = 0.7  # s before it lets go
    fade: float = 0.05  # s of letting go
    soft: bool = True  # its torque fades like a cosine, else evenly
    lift: float = np.inf  # s after the release
    stop: float = np.inf  # s after the release, when it stops the leg where it is


@dataclass(frozen=True)
class Device:
    rate: float = 100.0  # Hz
    noise: float = 1e-3  # rad
    gyro: float | None = 3e-3  # rad/s, None without one


def share(since, hand: Hand):
    """How much of the leg the hand still carries."""
    if hand.fade == 0:
        return np.where(since < 0, 1.0, 0.0)
    x = np.clip(since / hand.fade, 0, 1)
    return (1 + np.cos(np.pi * x)) / 2 if hand.soft else 1 - x


def motion(knee: Knee, hand: Hand, time, release: float):
    """Angle and rate at `time`; the hand begins to let go at `release`."""
    carried = -knee.pull(hand.start, 0.0)
    caught = [0.0, 0.0]

    def slope(t, y):
        since = t - release
        push = carried * share(since, hand)
        if since > hand.lift:
            grip = min((since - hand.lift) / 0.2, 1.0)
            push += grip * (carried + 40.0 * (hand.start - y[0]) - 10.0 * y[1])
        if since > hand.stop:
            push += 900.0 * (caught[0] - y[0]) - 60.0 * (y[1])
        return y[1], knee.pull(y[0], y[1]) + push

    def run(begin, end, y):
        inside = (time > begin) & (time <= end)
        found = solve_ivp(
            slope,
            (begin, end),
            y,
            t_eval=np.append(time[inside], end),
            rtol=1e-9,
            atol=1e-10,
            max_step=0.02,
        )
        return found.y[:, :-1], found.y[:, -1]

    before = time <= release
    parts = [np.stack([np.full(before.sum(), hand.start), np.zeros(before.sum())])]
    begin, state = release, np.array([hand.start, 0.0])
    for edge in (*sorted((hand.fade, hand.lift, hand.stop)), np.inf):
        end = min(release + edge, time[-1] + 1e-6)
        if end > begin:
            caught[0] = state[0]
            part, state = run(begin, end, state)
            parts.append(part)
            begin = end
            caught[0] = state[0]
    return np.concatenate(parts, axis=1)


def dropped(
    knee: Knee = ADULT,
    hand: Hand | None = None,
    device: Device | None = None,
    *,
    lasting=8.0,
    seed=0,
    declared=True,
) -> tuple[Recording, float]:
    """One drop, and when the hand began to let go [s]: at a random phase between two samples."""
    hand, device = hand or Hand(), device or Device()
    rng = np.random.default_rng(seed)
    step = 1 / device.rate
    time = np.arange(0, hand.hold + lasting, step)
    release = hand.hold + step * rng.random() if hand.hold else 0.0
    angle, rate = motion(knee, hand, time, release)
    angle = angle + device.noise * rng.standard_normal(time.size)
    gyro = None if device.gyro is None else rate + device.gyro * rng.standard_normal(time.size)
    segment = Segment(time, raw_angle=angle, raw_angular_velocity=gyro)
    known = Sensors(angle_noise=device.noise, velocity_noise=device.gyro)
    body = Subject(kind="leg", body_mass=74.0, height=1.78)
    recording = Recording(
        (segment,), body, Protocol(kind="passive"), known if declared else Sensors()
    )
    return recording, release
