"""A session: drops from random angles by a hand, and which part of it was kept."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from .hand import Tremor
from .leg import Physics
from .motion import static_torque

HIGHEST = 0.1  # rad, to which a hand lifts
ENDS = ("rest", "caught", "stopped")


@dataclass(frozen=True)
class Drop:
    """What is meant to happen to the leg once."""

    angle: float  # rad, from which it is dropped
    hold: float  # s
    ramp: float  # s, in which the hand lets go
    end: str  # "rest", "caught" or "stopped": the recording ends while the leg swings
    swing: float  # s until it is caught or the recording stops
    after: float  # s of rest or of the hand's hold that are kept
    skipped: float  # s after the release at which the recording begins; 0: it shows the hold
    tremor: Tremor


@dataclass(frozen=True)
class Protocol:
    """How a session is done and kept."""

    drops: tuple[Drop, ...]
    table: bool  # everything in one segment, lifts too; else a segment for each drop
    hanging: float  # s of the leg hanging still at the begin: a motionless segment


def resting_angle(physics: Physics) -> float:
    """Where the leg hangs, in rad."""
    return float(brentq(lambda angle: static_torque(physics, angle), -2.4, 0.6))


def draw_protocol(physics: Physics, noise: float, rng: np.random.Generator) -> Protocol:
    """`noise` of the angle in rad is what a faint tremor stays below."""
    table = rng.random() < 0.25
    count = int(rng.integers(2, 7))
    rest = resting_angle(physics)
    moving = not table and rng.random() < 0.08
    hanging = rng.uniform(1.5, 4.0) if rng.random() < (0.5 if table else 0.15) else 0.0
    shaky = rng.random() < 0.35
    drops = tuple(
        draw_drop(rest, table, moving, draw_tremor(noise, shaky, rng), rng) for _ in range(count)
    )
    return Protocol(drops, table, float(hanging))


def draw_drop(rest: float, table: bool, moving: bool, tremor: Tremor, rng: np.random.Generator):
    kinds = (0.7, 0.3, 0.0) if table else (0.6, 0.2, 0.2)
    return Drop(
        angle=rest + (HIGHEST - rest) * float(rng.uniform(0.35, 1.0)),
        hold=float(np.exp(rng.uniform(np.log(0.05), np.log(2.0)))),
        ramp=float(rng.uniform(0.02, 0.10)),
        end=str(rng.choice(ENDS, p=kinds)),
        swing=float(rng.uniform(0.8, 4.0)),
        after=float(rng.uniform(0.1, 1.5)),
        skipped=float(rng.uniform(0.03, 0.5)) if moving else 0.0,
        tremor=tremor,
    )


def draw_tremor(noise: float, shaky: bool, rng: np.random.Generator) -> Tremor:
    """Physiological tremor of a hand, or what is left of it below the noise."""
    size = rng.uniform(0.05, 0.3) * np.pi / 180 if shaky else rng.uniform(0.0, 0.3) * noise
    first, second = rng.uniform(4, 7), rng.uniform(7, 12)
    phase = rng.uniform(0, 2 * np.pi, 2)
    return Tremor(float(size), (first, second), (float(phase[0]), float(phase[1])))
