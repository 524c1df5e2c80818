"""What a formula may be made of; x is the angle [rad], v its rate [rad/s], t the time [s]."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

CENTRES = np.radians(np.arange(-130.0, 11.0, 10.0))
WIDTHS = np.radians((6.0, 12.0))
WAVES = (2, 3, 4, 5, 6, 8, 10, 12)
TIMES = (0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0, 1.5)  # s after the segment begins
FADES = (0.3, 1.0, 3.0)  # s
KICK = 0.05  # s


@dataclass(frozen=True)
class Feature:
    """One function of the moment, and how it is written."""

    words: str
    of: Callable[[Any, Any, Any, Any], Any]  # (angle, velocity, time, xp)
    known: bool = False  # a term of the library is just this


@cache
def dictionary() -> tuple[Feature, ...]:
    """What a formula may be made of; x is the angle [rad], v its rate [rad/s], t the time [s]."""
    plain = [
        Feature("1", lambda x, v, t, xp: xp.ones_like(x), True),
        Feature("sin(x)", lambda x, v, t, xp: xp.sin(x), True),
        Feature("x^2", lambda x, v, t, xp: x**2),
        Feature("x^3", lambda x, v, t, xp: x**3, True),
        Feature("sgn(v)", lambda x, v, t, xp: xp.tanh(v / 0.02), True),
        Feature("v|v|", lambda x, v, t, xp: v * xp.abs(v), True),
        Feature("v^2", lambda x, v, t, xp: v**2),
        Feature("v^3", lambda x, v, t, xp: v**3),
        Feature("v^4", lambda x, v, t, xp: v**4),
        Feature("x v", lambda x, v, t, xp: x * v),
        Feature("x^2 v", lambda x, v, t, xp: x**2 * v),
        Feature("x v|v|", lambda x, v, t, xp: x * v * xp.abs(v)),
        Feature("x v^2", lambda x, v, t, xp: x * v**2),
        Feature("max(0, v)", lambda x, v, t, xp: xp.maximum(v, 0.0)),
        Feature("|v|", lambda x, v, t, xp: xp.abs(v)),
        Feature("t", lambda x, v, t, xp: t),
        Feature("t x", lambda x, v, t, xp: t * x),
        Feature("t v", lambda x, v, t, xp: t * v),
    ]
    return (*plain, *waves(), *bumps(), *times())


def waves() -> list[Feature]:
    return [
        feature
        for k in WAVES
        for feature in (
            Feature(f"sin({k} x)", lambda x, v, t, xp, k=k: xp.sin(k * x)),
            Feature(f"cos({k} x)", lambda x, v, t, xp, k=k: xp.cos(k * x)),
        )
    ]


def bumps() -> list[Feature]:
    def bump(x, centre, width, xp):
        return xp.exp(-(((x - centre) / width) ** 2) / 2)

    found = []
    for c in CENTRES:
        for w in WIDTHS:
            name = f"bump(x, {np.degrees(c):.0f} deg, {np.degrees(w):.0f} deg)"
            found.append(Feature(name, lambda x, v, t, xp, c=c, w=w: bump(x, c, w, xp)))
            found.append(Feature(f"v {name}", lambda x, v, t, xp, c=c, w=w: v * bump(x, c, w, xp)))
    return found


def times() -> list[Feature]:
    fading = [
        Feature(f"exp(-t/{fade:g} s)", lambda x, v, t, xp, fade=fade: xp.exp(-t / fade))
        for fade in FADES
    ]
    kicks = [
        Feature(
            f"kick(t, {at:g} s)",
            lambda x, v, t, xp, at=at: xp.exp(-(((t - at) / KICK) ** 2) / 2),
        )
        for at in TIMES
    ]
    return [*fading, *kicks]
