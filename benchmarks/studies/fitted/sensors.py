"""What encoder and gyro write down of the drops of visits, some of them badly."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .swing import STEP, Ratios, swing
from .world import Visit

FINER = 4  # steps of the simulation for each sample
HELD, SWUNG = 40, 240  # samples before the release, and after it
TIME = STEP * FINER * np.arange(HELD + SWUNG)  # s
HIGHEST, LOWEST = -0.05, -0.35  # rad, from which legs are dropped
NOISE = 7.5e-4, 1.8e-3  # rad, rad/s: as it is declared
COUNT = 2 * np.pi / 4096  # rad, of the encoder
ZERO, BIAS = 0.01, 5e-4  # rad, rad/s: of a recording, one standard deviation
WORSE = 6.0  # times the noise that is declared
LATE = (2, 5)  # samples, by which a gyro is late
MOVED = (0.035, 0.09)  # rad, by which the zero moves between two drops


@dataclass(frozen=True, eq=False)
class Recording:
    """Of a visit, (drop, sample)."""

    visit: Visit
    angle: np.ndarray  # rad
    rate: np.ndarray  # rad/s


def record(visits: Sequence[Visit], draw: np.random.Generator) -> list[Recording]:
    """All visits, whose legs swing at once."""
    drops = visits[0].drops["damping_over_inertia"].size
    gravity = np.repeat([each.person.gravity[each.side] for each in visits], drops)
    friction = gravity * np.repeat([each.person.friction for each in visits], drops)
    stiffness, damping = (
        np.concatenate([each.drops[f"{name}_over_inertia"] for each in visits])
        for name in ("stiffness", "damping")
    )
    start = draw.uniform(LOWEST, HIGHEST, gravity.size)
    ratios = Ratios(gravity, stiffness, damping, friction)
    motion = [sampled(each) for each in swing(ratios, start, SWUNG * FINER)]
    shape = (len(visits), drops, HELD + SWUNG)
    angle, rate = (each.reshape(shape) for each in motion)
    return [measured(*each, draw) for each in zip(visits, angle, rate, strict=True)]


def sampled(motion: np.ndarray) -> np.ndarray:
    """At every sample, with the rest before the release."""
    held = np.repeat(motion[:, :1], HELD, axis=1)
    return np.concatenate([held, motion[:, FINER::FINER]], axis=1)


def measured(
    visit: Visit, angle: np.ndarray, rate: np.ndarray, draw: np.random.Generator
) -> Recording:
    """By an encoder and a gyro, with what went wrong."""
    worse = WORSE if visit.fault == "noise" else 1.0
    if visit.fault == "late gyro":
        by = int(draw.integers(*LATE, endpoint=True))
        rate = np.concatenate([np.zeros_like(rate[:, :by]), rate[:, :-by]], axis=1)
    zero = np.full((len(angle), 1), draw.normal(0, ZERO))
    if visit.fault == "moved zero":
        zero[int(draw.integers(1, len(angle))) :] += draw.uniform(*MOVED) * draw.choice([-1, 1])
    noisy = angle + zero + worse * NOISE[0] * draw.normal(size=angle.shape)
    rate = rate + draw.normal(0, BIAS) + worse * NOISE[1] * draw.normal(size=rate.shape)
    return Recording(visit, COUNT * np.round(noisy / COUNT), rate)
