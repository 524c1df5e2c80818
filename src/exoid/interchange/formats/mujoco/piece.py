"""What a term becomes in a model of MuJoCo."""

from collections.abc import Iterable
from dataclasses import dataclass, fields

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
    every = [Piece(), *pieces]

    def joined(name: str):
        values = [getattr(each, name) for each in every]
        if name == "step":
            return min(values)
        if name == "frame":
            return any(values)
        if name == "carried":
            return next((each for each in values if each is not None), None)
        if name in ("damping", "taken"):
            return tuple(map(sum, zip(*values, strict=True)))
        return sum(values, start=values[0]) if not isinstance(values[0], tuple) else sum(values, ())

    return Piece(**{each.name: joined(each.name) for each in fields(Piece)})
