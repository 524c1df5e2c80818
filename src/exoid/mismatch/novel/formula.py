"""A formula as a term of its own: fitted, simulated and proved like any other."""

from dataclasses import dataclass, replace
from itertools import pairwise
from types import new_class
from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.mismatch.novel.dictionary import Feature
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import PhysicsTerm

LARGEST = 100.0  # of a coefficient, either way


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

    @property
    def free(self) -> int:
        """How many features have their shape among the term's parameters."""
        sizes = np.cumsum([len(each.shape) for each in self.features]) + len(self.features)
        return int(np.sum(sizes <= MOST_PARAMETERS))

    @property
    def values(self) -> Float[np.ndarray, " parameter"]:
        """Coefficients, and the shapes that are free."""
        shapes = [each.shape for each in self.features[: self.free]]
        return np.concatenate([self.coefficients, *map(np.asarray, shapes)])

    def at(self, values: Float[np.ndarray, " parameter"]) -> "Formula":
        """The same formula with other values."""
        count = len(self.features)
        shapes = split(values[count:], self.features[: self.free])
        moved = [
            replace(each, shape=tuple(map(float, shape)))
            for each, shape in zip(self.features[: self.free], shapes, strict=True)
        ]
        features = (*moved, *self.features[self.free :])
        return replace(self, features=features, coefficients=values[:count])


def split(values, features) -> list:
    """A row of shape parameters, feature by feature."""
    ends = np.cumsum([0, *(len(each.shape) for each in features)])
    return [values[first:last] for first, last in pairwise(ends)]


def term_of(formula: Formula) -> type[PhysicsTerm]:
    """The formula as a term that can be fitted and simulated."""
    features = formula.features
    free = features[: formula.free]
    names = [f"c_{k}" for k in range(len(features))]
    shapes = [f"s_{k}" for k in range(sum(len(each.shape) for each in free))]

    def torque(self, now: Moment, memory):
        known = split([getattr(self, name) for name in shapes], free)
        moved = [replace(each, shape=tuple(own)) for each, own in zip(free, known, strict=True)]
        parts = [
            getattr(self, name) * each.of(now.angle, now.angular_velocity, now.time, jnp)
            for name, each in zip(names, (*moved, *features[len(free) :]), strict=True)
        ]
        return sum(parts[1:], parts[0])

    body: dict[str, Any] = {
        "__annotations__": {
            **dict.fromkeys(("title", "reference", "explanation", "isolate"), ClassVar[str]),
            **dict.fromkeys((*names, *shapes), Any),
        },
        "__module__": __name__,
        "title": formula.words,
        "reference": "found by sparse regression on this recording",
        "explanation": "A torque that no term of the library describes.",
        "isolate": "the same movement with one thing changed at a time",
        "torque": torque,
    }
    values = [float(value) for value in formula.values]
    for name, value in zip(names, values, strict=False):
        body[name] = parameter(name, "N m", -LARGEST, LARGEST, "", (value,))
    bounds = [pair for each in free for pair in each.family.bounds]
    units = [unit for each in free for unit in each.family.units]
    for name, unit, pair, value in zip(shapes, units, bounds, values[len(names) :], strict=True):
        body[name] = parameter(name, unit, *pair, "", (value,))
    name = "Formula " + " + ".join(each.words for each in features)
    return new_class(name, (PhysicsTerm,), {}, lambda namespace: namespace.update(body))
