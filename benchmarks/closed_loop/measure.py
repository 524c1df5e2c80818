"""Figures of one person's session."""

from dataclasses import dataclass

import numpy as np
from benchmarks.closed_loop.carrying import LIMIT, RATE_LIMIT
from benchmarks.closed_loop.host import ENABLED
from benchmarks.closed_loop.learners import Known
from benchmarks.closed_loop.rig import Body
from benchmarks.closed_loop.script import Case, Learned, Moved

ROUNDED = 1 / 1024  # N m, the step of EXO_TORQUE
ANGLES = np.radians(np.linspace(-90.0, 0.0, 91))


@dataclass(frozen=True)
class Effort:
    """Torques of one movement [N m]."""

    residual: float  # rms, between frame and leg beyond what was meant
    peak: float
    muscle: float  # rms
    carried: bool  # the motor was on throughout


@dataclass(frozen=True)
class Gravity:
    """How far the weight that is taken off is from that of leg and frame, where it is worst."""

    error: float  # N m
    share: float  # of m l g
    inertia: float  # relative error of J, by which it is off


@dataclass(frozen=True)
class Bounds:
    """The largest of a session, over what is allowed: above 1 a limit was passed."""

    command: float
    rate: float  # but for falls to 0
    motor: float


@dataclass(frozen=True)
class Outcome:
    """A session in figures."""

    case: Case
    first: Learned
    false_alarm: bool  # one more drop of the same leg was taken for another's
    found: float | None  # s after its first release that the second leg was found to be another
    second: Learned
    efforts: dict[str, Effort]
    gravity: dict[str, Gravity]
    bounds: Bounds


def effort(table: np.ndarray, moved: Moved) -> Effort:
    rows = table[moved.rows]
    return Effort(
        rms(rows["residual"]),
        float(np.abs(rows["residual"]).max()),
        rms(rows["muscle"]),
        bool((rows["permit"] == ENABLED).all()),
    )


def gravity_error(known: Known, case: Case, body: Body) -> Gravity:
    """Over all angles from hanging to level, with the zero that nobody knows."""
    weight, inertia = body.leg.weight + case.frame.weight, body.leg.inertia + case.frame.inertia
    shown = ANGLES + case.faults.zero - known.zero
    taken = known.inertia * known.gravity * np.cos(shown)
    error = float(np.abs(taken - weight * np.cos(ANGLES)).max())
    return Gravity(error, error / weight, known.inertia / inertia - 1)


def bounds(table: np.ndarray, case: Case, tick: float, step: float) -> Bounds:
    every = table["command"][:: round(tick / step)]
    change = np.abs(np.diff(every))[every[1:] != 0.0]
    return Bounds(
        float(np.abs(every).max() / LIMIT),
        float((change.max(initial=ROUNDED) - ROUNDED) / (RATE_LIMIT * tick)),
        float(np.abs(table["motor"]).max() / case.motor.limit),
    )


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))
