"""A formula as a term of its own: fitted, simulated and proved like any other."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from types import new_class
from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.mismatch.novel.dictionary import Feature, dictionary, reshaped
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import PhysicsTerm, Term

FAINT, ONCE = 0.01, 0.75  # of its largest square, where it pauses; of its sum, that acts at once
LARGEST = 100.0  # of a coefficient, either way
BETWEEN = "; "  # the features of a formula, in the name of its term


@dataclass(frozen=True, eq=False)
class Formula:
    """Features with their coefficients [N m], and the share of the missing torque they explain."""

    features: tuple[Feature, ...]
    coefficients: Float[np.ndarray, " feature"]
    explained: float
    known: float  # share of it that is in the library already

    @property
    def words(self) -> str:
        return f"tau = {self.sum_for(1.0)} N m"

    def over(self, inertia: float) -> str:
        """The torque over J in words, of a leg of this inertia [kg m^2]."""
        return f"tau / J = {self.sum_for(inertia)} rad/s^2"

    def times(self, factor: float) -> "Formula":
        """So many times as large a torque."""
        return replace(self, coefficients=factor * self.coefficients)

    def sum_for(self, inertia: float) -> str:
        """The features with their coefficients over an inertia."""
        parts = [
            f"{value / inertia:+.3g} {feature.words}"
            for value, feature in zip(self.coefficients, self.features, strict=True)
        ]
        return " ".join(parts).removeprefix("+")

    @property
    def simple(self) -> str:
        """The torque without a name that is this formula; empty where it is none."""
        return self.features[0].family.simple if len(self.features) == 1 else ""

    @property
    def free(self) -> tuple[Feature, ...]:
        """The features that have their shape among the term's parameters: as many as fit."""
        sizes = np.cumsum([len(each.shape) for each in self.features]) + len(self.features)
        return self.features[: int(np.sum(sizes <= MOST_PARAMETERS))]

    @property
    def values(self) -> Float[np.ndarray, " parameter"]:
        """Coefficients, and the shapes that are free."""
        return np.concatenate([self.coefficients, *(np.asarray(each.shape) for each in self.free)])

    def moment_of(
        self,
        angle: Float[np.ndarray, " time"],
        velocity: Float[np.ndarray, " time"],
        time: Float[np.ndarray, " time"],
    ) -> tuple[float, float] | None:
        """When nearly all of it acts in a motion, by its square, with one turn at most: from, to;
        None where it acts time and again. A place that a leg passes once may be a moment.
        """
        each = zip(self.coefficients, self.features, strict=True)
        acting = [size * one.of(angle, velocity, time, np) for size, one in each]
        square = np.square(np.sum(acting, axis=0))
        most = int(np.argmax(square))
        faint = np.flatnonzero(square < FAINT * square[most])
        first = max(faint[faint < most], default=-1) + 1
        last = min(faint[faint > most], default=time.size) - 1
        within = slice(first, last + 1)
        turns = np.count_nonzero(np.diff(np.sign(velocity[within])))
        if turns > 1 or square[within].sum() < ONCE * square.sum():
            return None
        return float(time[first]), float(time[last])

    def at(self, values: Float[np.ndarray, " parameter"]) -> "Formula":
        """The same formula with other values."""
        coefficients, shapes = np.split(values, [len(self.features)])
        features = reshaped(self.features, shapes.tolist())
        return replace(self, features=features, coefficients=coefficients)


def term_of(formula: Formula) -> type[PhysicsTerm]:
    """The formula as a term that can be fitted and simulated."""
    features, free = formula.features, formula.free
    names = [f"c_{k}" for k in range(len(features))]
    shapes = [f"s_{k}" for k in range(sum(len(each.shape) for each in free))]

    def torque(self, now: Moment, memory):
        moved = reshaped(features, [getattr(self, name) for name in shapes])
        parts = [
            getattr(self, name) * each.of(now.angle, now.angular_velocity, now.time, jnp)
            for name, each in zip(names, moved, strict=True)
        ]
        return sum(parts[1:], parts[0])

    body: dict[str, Any] = {
        "__annotations__": {
            **dict.fromkeys(("title", "reference", "explanation", "isolate"), ClassVar[str]),
            "formula": ClassVar[Formula],
            **dict.fromkeys((*names, *shapes), Parameter),
        },
        "__module__": __name__,
        # by which a kept program is known again: what it works out, but for the size of its parts
        "__qualname__": BETWEEN.join(map(spelled, features)),
        "formula": formula,
        "title": formula.words,
        "reference": "found by sparse regression on this recording",
        "explanation": "A torque that no term of the library describes.",
        "isolate": "the same movement with one thing changed at a time",
        "torque": torque,
    }
    limits = [("N m", -LARGEST, LARGEST)] * len(names) + [
        (unit, *pair)
        for each in free
        for unit, pair in zip(each.family.units, each.family.bounds, strict=True)
    ]
    for name, limit, value in zip((*names, *shapes), limits, formula.values, strict=True):
        body[name] = parameter(name, *limit, "", (float(value),))
    return new_class("Formula", (PhysicsTerm,), {}, lambda namespace: namespace.update(body))


def spelled(feature: Feature) -> str:
    """A family and a shape, as `features_called` reads them."""
    return f"{feature.family.words} ({', '.join(map(repr, map(float, feature.shape)))})"


def features_called(name: str) -> tuple[Feature, ...]:
    """The features that the qualified name of a term spells; none where it spells no formula."""
    families = {each.family.words: each.family for each in dictionary()}
    found = []
    for each in name.split(BETWEEN):
        words, _, shape = each.removesuffix(")").rpartition(" (")
        if words not in families:
            return ()
        sizes = tuple(map(float, shape.split(", "))) if shape else ()
        found.append(Feature(families[words], sizes))
    return tuple(found)


@cache
def term_called(name: str, values: tuple[float, ...]) -> type[PhysicsTerm]:
    """The term of this name again, as of a saved result, with the values that it had there. What it
    explained of a recording is no part of it.
    """
    features = features_called(name)
    formula = Formula(features, np.ones(len(features)), np.nan, np.nan)
    return term_of(formula.at(np.array(values)))


def fitted_formula(terms: Sequence[Term]) -> Formula:
    """The formula among fitted terms, with its own values; errors of sensors may be beside it."""
    (term,) = (each for each in terms if hasattr(type(each), "formula"))
    formula: Formula = type(term).formula  # pyright: ignore[reportAttributeAccessIssue]
    return formula.at(np.array([*map(float, jax.tree.leaves(term))]))
