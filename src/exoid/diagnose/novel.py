"""A torque that no term of the library describes: a formula for it, by sparse regression.

The baseline and a few features of a dictionary are regressed on the measured motion's acceleration,
best feature first; each must earn its place. The formula then becomes a term like any other, and is
refitted and proved as one.
"""

from dataclasses import dataclass
from types import new_class
from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.diagnose.bench import Bench
from exoid.diagnose.dictionary import Feature, dictionary
from exoid.diagnose.hypothesis import Hypothesis
from exoid.diagnose.locate import lacking
from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import PhysicsTerm

MOST = 3  # features of a formula
LARGEST = 1e3  # of a coefficient, either way


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
