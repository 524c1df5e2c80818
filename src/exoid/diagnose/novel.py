"""A torque that no term of the library describes: a formula for it, by sparse regression.

The baseline and a few features of a dictionary are regressed on the measured motion's acceleration,
best feature first; each must earn its place. The formula then becomes a term like any other, and is
refitted and proved as one.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from types import new_class
from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.diagnose.bench import Bench
from exoid.diagnose.hypothesis import Hypothesis
from exoid.diagnose.locate import lacking
from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import PhysicsTerm

MOST = 3  # features of a formula
LARGEST = 1e3  # of a coefficient, either way
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


@dataclass(frozen=True, eq=False)
class Formula:
    """Features with their coefficients [N m], and the share of the missing torque they explain."""

    features: tuple[Feature, ...]
    coefficients: Float[np.ndarray, " feature"]
    explained: float
    known: float  # share of it that is in the library already

    @property
    def words(self) -> str:
        parts = [
            f"{value:+.3g} {feature.words}"
            for value, feature in zip(self.coefficients, self.features, strict=True)
        ]
        return "tau = " + " ".join(parts).removeprefix("+") + " N m"


def describe(bench: Bench, base: Hypothesis) -> Formula:
    """The sparsest formula for what the baseline lacks."""
    rows = [lacking(bench, base, number) for number in range(bench.segments)]
    baseline = np.concatenate([leg(each, k, len(rows)) for k, each in enumerate(rows)])
    angle, velocity, time, torque = (
        np.concatenate([getattr(each, name) for each in rows])
        for name in ("angle", "angular_velocity", "time", "torque")
    )
    table = np.stack([one.of(angle, velocity, time, np) for one in dictionary()], axis=1)
    kept = np.isfinite(table).all(axis=0)
    left = np.where(kept, project(baseline, np.where(kept, table, 0.0)), 0.0)
    target = project(baseline, torque[:, None])[:, 0]
    chosen: list[int] = []
    for _ in range(MOST):
        residual = target - fitted(left[:, chosen], target)
        size = np.linalg.norm(left, axis=0)
        gain = np.where(size > 1e-9 * size.max(), (left.T @ residual) / np.maximum(size, 1e-12), 0)
        gain[chosen] = 0.0
        chosen.append(int(np.argmax(np.abs(gain))))
    sums = [sum_left(left[:, chosen[:n]], target) for n in range(MOST + 1)]
    prices = np.log(len(target)) * np.arange(MOST + 1)
    best = int(np.argmin(effective(rows) * np.log(sums) + prices))
    best = max(best, 1)
    picked = chosen[:best]
    coefficients = np.linalg.lstsq(left[:, picked], target, rcond=None)[0]
    features = tuple(dictionary()[at] for at in picked)
    sizes = np.abs(coefficients) * np.linalg.norm(left[:, picked], axis=0)
    known = float(sizes @ [feature.known for feature in features] / sizes.sum())
    return Formula(features, coefficients, 1 - sums[best] / sums[0], known)


def leg(each, number: int, count: int) -> np.ndarray:
    """What the leg's own parameters can take up."""
    rows = [np.cos(each.angle), each.angle, each.angular_velocity]
    return np.stack(rows, axis=1)


def effective(rows) -> float:
    """Independent values of the averaged torque."""
    return sum(each.time[-1] - each.time[0] for each in rows) / 0.05


def project(basis: np.ndarray, table: np.ndarray) -> np.ndarray:
    """What the basis cannot take up."""
    return table - basis @ np.linalg.lstsq(basis, table, rcond=None)[0]


def fitted(table: np.ndarray, target: np.ndarray) -> np.ndarray:
    if not table.shape[1]:
        return np.zeros_like(target)
    return table @ np.linalg.lstsq(table, target, rcond=None)[0]


def sum_left(table: np.ndarray, target: np.ndarray) -> float:
    return float(np.sum((target - fitted(table, target)) ** 2)) + 1e-12


def term_of(formula: Formula) -> type[PhysicsTerm]:
    """The formula as a term that can be fitted and simulated."""
    features = formula.features

    def torque(self, now: Moment, memory):
        values = [getattr(self, f"c_{k}") for k in range(len(features))]
        parts = [
            value * feature.of(now.angle, now.angular_velocity, now.time, jnp)
            for value, feature in zip(values, features, strict=True)
        ]
        return sum(parts[1:], parts[0])

    name = "Formula " + " + ".join(feature.words for feature in features)
    body: dict[str, Any] = {
        "__annotations__": {
            "title": ClassVar[str],
            "reference": ClassVar[str],
            "explanation": ClassVar[str],
            "isolate": ClassVar[str],
            **{f"c_{k}": Any for k in range(len(features))},
        },
        "__module__": __name__,
        "title": formula.words,
        "reference": "found by sparse regression on this recording",
        "explanation": "A torque that no term of the library describes.",
        "isolate": "the same movement with one thing changed at a time",
        "torque": torque,
    }
    for k, value in enumerate(formula.coefficients):
        body[f"c_{k}"] = parameter(f"c_{k}", "N m", -LARGEST, LARGEST, "", (float(value),))
    return new_class(name, (PhysicsTerm,), {}, lambda namespace: namespace.update(body))
