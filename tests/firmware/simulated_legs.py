"""Many simulated legs at a time: how they move, and what a node's encoder and gyro show of it.

An own integrator and own sensors in plain NumPy, so that what the firmware learns is compared with
nothing of exoid's.
"""

from dataclasses import dataclass

import numpy as np

TICK = 0.01  # s
STEPS = 2  # of the integrator in a tick
ENCODER_STEP, ENCODER_NOISE = 2 * np.pi / 4096, np.radians(0.043)  # rad
GYRO_STEP, GYRO_NOISE = np.radians(0.07), np.radians(7e-3) * np.sqrt(833 / 2)  # rad/s
RENEWAL, OFF_RATE = 1 / 833, 0.03  # s between the gyro's samples; how far its clock is off
FINER = 16  # counts of EXO_FINE in one of the encoder

Motion = list[np.ndarray]  # angle, rate, acceleration; each by tick and leg


@dataclass(frozen=True)
class Legs:
    """phi'' = torque - gravity cos(phi) - stiffness phi - damping phi' - friction sgn(phi').

    Each is over the inertia.
    """

    gravity: np.ndarray
    stiffness: np.ndarray
    damping: np.ndarray
    torque: np.ndarray
    zero: np.ndarray  # rad, by which the encoder shows more
    bias: np.ndarray  # rad/s, of the gyro
    scale: np.ndarray  # relative, of the gyro
    friction: np.ndarray | float = 0.0
    late: np.ndarray | float = 0.0  # s, by which the gyro's samples are older than by its clock
    off_axis: np.ndarray | float = 0.0  # rad, of the encoder's magnet: its error once a turn
    off_way: np.ndarray | float = 0.0  # rad, where that error is 0 and grows

    @classmethod
    def drawn(cls, legs: int, rng: np.random.Generator) -> "Legs":
        """Adults and children with knees of half to twice a relaxed one's; an encoder 3 deg off."""
        knees = np.exp(rng.normal(0, 0.5, (2, legs)))
        return cls(
            gravity=rng.normal(28, 3.5, legs).clip(18, 42),
            stiffness=6.6 * knees[0],
            damping=0.82 * knees[1],
            torque=rng.normal(0, 1, legs),
            zero=np.radians(3) * rng.choice([-1, 1], legs),
            bias=rng.uniform(-0.1, 0.1, legs),
            scale=rng.normal(0, 0.008, legs),
        )

    @property
    def size(self) -> int:
        return self.gravity.size

    @property
    def ratios(self) -> np.ndarray:
        """What a node is to tell, in its order; the torque is that at the encoder's zero."""
        torque = self.torque + self.stiffness * self.zero
        friction = self.friction + np.zeros(self.size)
        return np.stack([self.gravity, self.stiffness, self.damping, torque, friction])

    def pull(self, angle, rate):
        """Acceleration but for dry friction."""
        fall = self.gravity * np.cos(angle) + self.stiffness * angle
        return self.torque - fall - self.damping * rate

    def way(self, angle, rate):
        """Against which dry friction pulls: 0 of a leg that it holds."""
        pull = self.pull(angle, rate)
        return np.where(rate == 0, np.sign(pull) * (np.abs(pull) > self.friction), np.sign(rate))

    def acceleration(self, angle, rate):
        held = (rate == 0) & (np.abs(self.pull(angle, rate)) <= self.friction)
        pull = self.pull(angle, rate) - self.friction * self.way(angle, rate)
        return np.where(held, 0.0, pull)

    def drop(self, start, duration: float) -> Motion:
        """Let go at rest at `start` [rad], by the classical method of Runge and Kutta."""
        angle, rate = np.array(start, float), np.zeros(self.size)
        path = [(angle, rate, self.acceleration(angle, rate))]
        for _ in range(round(duration / TICK)):
            for _ in range(STEPS):
                angle, rate = self.stepped(angle, rate, TICK / STEPS)
            path.append((angle, rate, self.acceleration(angle, rate)))
        return [np.stack(each) for each in zip(*path, strict=True)]

    def stepped(self, angle, rate, step):
        """With dry friction in two parts, where the leg turns round in it: its end is at rest."""
        way = self.way(angle, rate)
        end = self.swung(angle, rate, way, step)
        turns = (end[1] * way < 0) & (np.asarray(self.friction) > 0)
        if not turns.any():
            return end
        part = step * np.where(turns, rate / np.where(turns, rate - end[1], 1.0), 0.0)
        angle = self.swung(angle, rate, way, part)[0]
        again = self.swung(angle, 0.0 * rate, self.way(angle, 0.0 * rate), step - part)
        return tuple(np.where(turns, new, old) for new, old in zip(again, end, strict=True))

    def swung(self, angle, rate, way, step):
        """While friction pulls one way; a leg that it holds stays."""

        def acceleration(angle, rate):
            pull = self.pull(angle, rate) - self.friction * way
            return np.where((way == 0) & (np.asarray(self.friction) > 0), 0.0, pull)

        slopes = [(rate, acceleration(angle, rate))]
        for part in (0.5, 0.5, 1.0):
            turn, pull = slopes[-1]
            there = angle + part * step * turn, rate + part * step * pull
            slopes.append((there[1], acceleration(*there)))
        weights = np.array([1, 2, 2, 1])[:, None] * step / 6
        turns, pulls = (np.stack(each) for each in zip(*slopes, strict=True))
        return angle + (weights * turns).sum(axis=0), rate + (weights * pulls).sum(axis=0)

    def sensed(self, motion: Motion, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """The encoder's count in EXO_FINE's and the gyro's, by tick and leg."""
        angle, rate, acceleration = motion
        turned = angle + self.zero + self.off_axis * np.sin(angle + self.zero - self.off_way)
        shown = turned + ENCODER_NOISE * rng.normal(size=angle.shape)
        count = np.rint(shown / ENCODER_STEP).astype(int) * FINER + 32768
        period = RENEWAL * (1 + OFF_RATE * rng.uniform(-1, 1, self.size))
        clock = rng.uniform(size=self.size) * period + TICK * np.arange(len(angle))[:, None]
        turning = (1 + self.scale) * (
            rate - (clock % period + self.late) * acceleration
        ) + self.bias
        noisy = turning + GYRO_NOISE * rng.normal(size=rate.shape)
        return count % 65536, np.rint(noisy / GYRO_STEP).astype(int)


def held(angle, duration: float) -> Motion:
    still = np.zeros((round(duration / TICK), np.size(angle)))
    return [still + angle, still, still]


def moved(start, end, duration: float) -> Motion:
    """By a hand, as smoothly as a hand can (Flash and Hogan, J Neurosci 5(7), 1985)."""
    s = np.arange(1, round(duration / TICK) + 1)[:, None] * TICK / duration
    way = np.asarray(end) - start
    return [
        start + way * (10 * s**3 - 15 * s**4 + 6 * s**5),
        way * (30 * s**2 - 60 * s**3 + 30 * s**4) / duration,
        way * (60 * s - 180 * s**2 + 120 * s**3) / duration**2,
    ]


def caught(motion: Motion, duration: float, within: float = 0.03) -> Motion:
    """A hand stops it: its rate fades with the time constant `within` [s]."""
    angle, rate = motion[0][-1], motion[1][-1]
    fading = np.exp(-np.arange(1, round(duration / TICK) + 1)[:, None] * TICK / within)
    return [angle + within * rate * (1 - fading), rate * fading, -rate * fading / within]


def joined(*parts: Motion) -> Motion:
    return [np.concatenate(each) for each in zip(*parts, strict=True)]


def session(legs: Legs, rng: np.random.Generator, drops: int, duration: float = 4.0) -> Motion:
    """Held, let go, caught, held, lifted to the next drop, and so on."""
    parts, last = [], None
    for _ in range(drops):
        start = rng.uniform(-0.5, 0.1, legs.size)
        if last is not None:
            parts.append(moved(last, start, 1.5))
        drop = legs.drop(start, duration)
        stopped = caught(drop, 0.5)
        last = stopped[0][-1]
        parts += [held(start, 0.8), drop, stopped, held(last, 0.5)]
    return joined(*parts)
