"""Drops whose measures are known: a damped oscillator that is let go from rest.

    phi(x) = rest + A exp(-lambda x) (cos(omega x) + lambda / omega sin(omega x)),   x = t - HOLD

so that its n-th turning point is at x = n pi / omega, with (-1)^n A exp(-lambda n pi / omega).
"""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

HOLD = 1.0  # s held still before the release
NOISE = 0.0009  # rad, of an AS5600 with its steps


@dataclass(frozen=True)
class Oscillator:
    """A leg without gravity's nonlinearity."""

    rest: float = -1.2  # rad
    amplitude: float = 1.0  # rad
    frequency: float = 6.1  # omega, rad/s
    decay: float = 0.5  # lambda, 1/s

    @property
    def decrement(self) -> float:
        return 2 * np.pi * self.decay / self.frequency

    @property
    def period(self) -> float:
        return 2 * np.pi / self.frequency

    @property
    def pull(self) -> float:
        """omega^2 + lambda^2, which is the first acceleration over the amplitude."""
        return self.frequency**2 + self.decay**2

    def angle(self, x):
        turned = self.frequency * np.maximum(x, 0)
        swing = np.cos(turned) + self.decay / self.frequency * np.sin(turned)
        return self.rest + self.amplitude * np.exp(-self.decay * np.maximum(x, 0)) * swing

    def velocity(self, x):
        envelope = self.amplitude * self.pull / self.frequency * np.exp(-self.decay * x)
        return -envelope * np.sin(self.frequency * x)


def recorded(angle, time, kind="passive", noise=NOISE, **channels) -> Recording:
    """One segment of a relaxed leg, unless said otherwise."""
    segment = Segment(time, raw_angle=angle, **channels)
    return Recording((segment,), protocol=Protocol(kind=kind), sensors=Sensors(angle_noise=noise))


def drop(leg=None, *, lasting=13.0, step=0.01, noise=0.0, seed=0, hold=HOLD) -> Recording:
    """A drop of the oscillator, held still for `hold` s."""
    time = np.arange(0, hold + lasting, step)
    angle = (leg or Oscillator()).angle(time - hold)
    angle = angle + noise * np.random.default_rng(seed).normal(size=time.size)
    return recorded(angle, time, noise=noise or 1e-6)
