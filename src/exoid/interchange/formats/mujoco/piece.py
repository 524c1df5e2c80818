"""What a term becomes in a model of MuJoCo."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce

from exoid.interchange.formula.expression import Expression
from exoid.interchange.model.joint import Kept


@dataclass(frozen=True)
class Piece:
    """What is added to the knee's joint, to the model, and to where it begins."""

    kept: tuple[Kept, ...] = ()
    rest: float = 0.0  # rad, of the knee's spring
    friction: float = 0.0  # N m
    damping: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of v, v |v| and v^3
    limits: tuple[str, ...] = ()  # attributes of the knee
    tendons: tuple[str, ...] = ()
    actuators: tuple[str, ...] = ()
    bodies: tuple[str, ...] = ()  # that ride on the shank
    taken: tuple[float, float, float] = (0.0, 0.0, 0.0)  # off the shank: kg, kg m, kg m^2
    positions: tuple[float, ...] = ()  # of the bodies' joints, where it begins
    speeds: tuple[float, ...] = ()
    drives: tuple[Expression, ...] = ()  # N m over time, beside the cycle
    lag: float = 0.0  # s, by which the drive acts late
    carried: float | None = None  # N m, of the drive where it begins, where it is late
    frame: bool = False  # do the sensors ride on one
    step: float = 1e-3  # s, the longest that it allows


def together(pieces: Iterable[Piece]) -> Piece:
    """All of them as one."""
    return reduce(both, pieces, Piece())


def both(one: Piece, other: Piece) -> Piece:
    """Two as one: at most one of a model's terms has a frame, or makes the drive late."""
    (a, b, c), (d, e, f) = one.damping, other.damping
    (mass, moment, inertia), (more, further, larger) = one.taken, other.taken
    return Piece(
        kept=one.kept + other.kept,
        rest=one.rest + other.rest,
        friction=one.friction + other.friction,
        damping=(a + d, b + e, c + f),
        limits=one.limits + other.limits,
        tendons=one.tendons + other.tendons,
        actuators=one.actuators + other.actuators,
        bodies=one.bodies + other.bodies,
        taken=(mass + more, moment + further, inertia + larger),
        positions=one.positions + other.positions,
        speeds=one.speeds + other.speeds,
        drives=one.drives + other.drives,
        lag=one.lag + other.lag,
        carried=other.carried if one.carried is None else one.carried,
        frame=one.frame or other.frame,
        step=min(one.step, other.step),
    )
