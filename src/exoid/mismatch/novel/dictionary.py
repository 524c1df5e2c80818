"""What a formula may be made of; x is the angle [rad], v its rate [rad/s], t the time [s].

A family has shape parameters: where a bump lies, how wide it is. A search begins at its `shapes`
and refines them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from typing import Any

import numpy as np

CENTRES = tuple(np.radians(np.arange(-130.0, 11.0, 10.0)))  # rad
WIDTHS = tuple(np.radians((6.0, 12.0)))  # rad
WAVES = (2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 14.0)  # in a turn
TIMES = (0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0, 1.5)  # s after the segment begins
LASTING = (0.03, 0.08)  # s, of a kick
FADES = (0.3, 1.0, 3.0)  # s
SHARP = 0.02  # rad/s, over which a sign changes
SATURATED = (0.3, 1.0)  # rad/s, from about where on a torque grows no more with the rate

Shape = tuple[Any, ...]
PLACE = ((-2.8, 0.4), (0.03, 0.8))  # rad
OF_ANGLE = ("rad", "rad")


@dataclass(frozen=True)
class Family:
    """Functions of the moment that differ by their shape."""

    words: str
    of: Callable[[Shape, Any, Any, Any, Any], Any]  # (shape, angle, velocity, time, xp)
    known: bool = False  # a term of the library is just this
    shapes: tuple[Shape, ...] = ((),)  # where a search begins
    bounds: tuple[tuple[float, float], ...] = ()
    units: tuple[str, ...] = ()
    simple: str = ""  # the torque without a name (`nameless.py`) that is just this


@dataclass(frozen=True)
class Feature:
    """One function of the moment, and how it is written."""

    family: Family
    shape: Shape

    def of(self, angle: Any, velocity: Any, time: Any, xp: Any) -> Any:
        return self.family.of(self.shape, angle, velocity, time, xp)

    @property
    def words(self) -> str:
        shown = map(in_words, self.shape, self.family.units)
        return self.family.words.format(*shown)


def reshaped(features: Sequence[Feature], row: Any) -> tuple[Feature, ...]:
    """The features with the shapes in a row, one after the other; where it ends, as they were."""
    moved = []
    for each in features:
        own, row = row[: len(each.shape)], row[len(each.shape) :]
        moved.append(replace(each, shape=tuple(own)) if len(own) else each)
    return tuple(moved)


def in_words(value: float, unit: str) -> str:
    if unit == "rad":
        return f"{np.degrees(value):.0f} deg"
    return f"{value:.3g}" if unit == "1" else f"{value:.2g} {unit}"


@cache
def dictionary() -> tuple[Feature, ...]:
    """Every family at every shape where a search begins."""
    families = (*plain(), of_rate(), *of_angle(), *of_time())
    return tuple(Feature(family, shape) for family in families for shape in family.shapes)


def plain() -> list[Family]:
    return [
        Family("1", lambda s, x, v, t, xp: xp.ones_like(x), True),
        Family("sin(x)", lambda s, x, v, t, xp: xp.sin(x), True),
        Family("x^2", lambda s, x, v, t, xp: x**2),
        Family("x^3", lambda s, x, v, t, xp: x**3, True),
        Family("sgn(v)", lambda s, x, v, t, xp: sign(v, xp), True),
        Family("v|v|", lambda s, x, v, t, xp: v * xp.abs(v), True),
        Family("v^2", lambda s, x, v, t, xp: v**2),
        Family("v^3", lambda s, x, v, t, xp: v**3),
        Family("v^4", lambda s, x, v, t, xp: v**4),
        Family("x v", lambda s, x, v, t, xp: x * v, simple="damping_by_angle"),
        Family("x^2 v", lambda s, x, v, t, xp: x**2 * v),
        Family("x v|v|", lambda s, x, v, t, xp: x * v * xp.abs(v)),
        Family("x v^2", lambda s, x, v, t, xp: x * v**2),
        Family("x sgn(v)", lambda s, x, v, t, xp: x * sign(v, xp)),
        Family("max(0, v)", lambda s, x, v, t, xp: xp.maximum(v, 0.0)),
        Family("|v|", lambda s, x, v, t, xp: xp.abs(v), simple="damping_by_direction"),
        Family("t", lambda s, x, v, t, xp: t),
        Family("t x", lambda s, x, v, t, xp: t * x),
        Family("t v", lambda s, x, v, t, xp: t * v),
    ]


def of_rate() -> Family:
    """What grows with the rate up to some rate: between a damper and dry friction."""
    return Family(
        "tanh(v/{0})",
        lambda s, x, v, t, xp: xp.tanh(v / s[0]),
        shapes=tuple((rate,) for rate in SATURATED),
        bounds=((0.05, 3.0),),
        units=("rad/s",),
    )


def sign(velocity, xp):
    return xp.tanh(velocity / SHARP)


def bell(value, shape, xp):
    return xp.exp(-(((value - shape[0]) / shape[1]) ** 2) / 2)


def of_angle() -> list[Family]:
    """Waves, bumps and snaps: of the angle alone, with the speed, and with its direction."""
    places = tuple(product(CENTRES, WIDTHS))
    turns = tuple(product(WAVES, (0.0, np.pi / 2)))
    forms = (
        ("sin({0} x + {1})", wave, turns, ((1.5, 25.0), (-20.0, 20.0)), ("1", "1")),
        ("bump(x, {0}, {1})", bump, places, PLACE, OF_ANGLE),
        ("snap(x, {0}, {1})", snap, places, PLACE, OF_ANGLE),
    )
    factors = (("", lambda v, xp: xp.ones_like(v)), ("v ", lambda v, xp: v), ("sgn(v) ", sign))
    return [
        Family(
            name + words,
            lambda s, x, v, t, xp, by=by, form=form: form(by(v, xp), s, x, xp),
            shapes=shapes,
            bounds=bounds,
            units=units,
        )
        for name, by in factors
        for words, form, shapes, bounds, units in forms
    ]


def wave(factor, shape, angle, xp):
    return factor * xp.sin(shape[0] * angle + shape[1])


def bump(factor, shape, angle, xp):
    return factor * bell(angle, shape, xp)


def snap(factor, shape, angle, xp):
    return factor * (angle - shape[0]) / shape[1] * bell(angle, shape, xp)


def of_time() -> list[Family]:
    """What fades, and what comes at one time after the segment begins."""
    return [
        Family(
            "exp(-t/{0})",
            lambda s, x, v, t, xp: xp.exp(-t / s[0]),
            shapes=tuple((fade,) for fade in FADES),
            bounds=((0.03, 20.0),),
            units=("s",),
            simple="fading_torque",
        ),
        Family(
            "kick(t, {0}, {1})",
            lambda s, x, v, t, xp: bell(t, s, xp),
            shapes=tuple(product(TIMES, LASTING)),
            bounds=((0.0, 20.0), (0.01, 1.0)),
            units=("s", "s"),
        ),
    ]
