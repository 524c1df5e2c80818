"""What may explain a recording: terms of the library with their values, and a leg with them."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import equinox as eqx
import numpy as np
from jaxtyping import Float

from exoid.physics.motion.step import Drive
from exoid.physics.term import Term

DAMPING = 1e-3  # of the first step, relative to the curvature
HARDER = 8.0  # times as much of the next one, where one failed


class Effect(eqx.Module):
    """What a term does along a motion: torques per inertia, and what the sensors show."""

    push: Drive  # rad/s^2, at the stage times
    shown: Float[Any, "*batch time channel"]  # rad, rad/s


@dataclass(frozen=True, eq=False)
class Linear:
    """The first terms as they were found: what they do, linear in their parameters around `at`."""

    effect: Effect  # (1 + parameter, segment, time)
    at: np.ndarray
    count: int = 1  # of terms


@dataclass(frozen=True, eq=False)
class Hypothesis:
    """Terms with their values, and the leg that goes with them."""

    terms: tuple[type[Term], ...]
    values: tuple[np.ndarray, ...]
    point: Float[np.ndarray, " coordinate"]  # `flattened` and in units of TYPICAL
    zero: np.ndarray = field(default_factory=lambda: np.zeros(2))  # gyro [rad/s], encoder [rad]
    linear: Linear | None = None  # in place of its first terms, while it is pinned

    @property
    def asked(self) -> list[tuple[type[Term], np.ndarray]]:
        """The terms that are worked out while it is pinned, with their values: no linear one."""
        first = 0 if self.linear is None else self.linear.count
        return list(zip(self.terms[first:], self.values[first:], strict=True))

    @property
    def unknowns(self) -> np.ndarray:
        """Everything a fit may change, in one row."""
        return np.concatenate([self.point, self.zero, *self.values])

    def with_term(
        self, term: type[Term], value: np.ndarray, linear: Linear | None = None
    ) -> "Hypothesis":
        """One term more."""
        terms, values = (*self.terms, term), (*self.values, value)
        return replace(self, terms=terms, values=values, linear=linear)

    def without(self, some: Sequence[type[Term]]) -> "Hypothesis":
        """None of these terms."""
        each = zip(self.terms, self.values, strict=True)
        kept = [(term, value) for term, value in each if term not in some]
        terms, values = tuple(term for term, _ in kept), tuple(value for _, value in kept)
        return replace(self, terms=terms, values=values, linear=None)

    def at(self, unknowns: np.ndarray) -> "Hypothesis":
        """The same terms elsewhere."""
        size = self.point.size
        cuts = np.cumsum([2, *(value.size for value in self.values)])[:-1]
        zero, *values = np.split(unknowns[size:], cuts)
        return replace(self, point=unknowns[:size], zero=zero, values=tuple(values))


@dataclass(frozen=True, eq=False)
class Products:
    """(J, r)'(J, r) of a candidate: over all its unknowns, of every segment and of what is usual
    of sensors and seat.
    """

    each: Float[np.ndarray, "segment column column"]
    usual: Float[np.ndarray, "column column"]

    @cached_property
    def total(self) -> np.ndarray:
        return self.each.sum(axis=0) + self.usual

    @property
    def square(self) -> float:
        """The sum of squares of the residual over its noise, and of what is unusual."""
        return float(self.total[-1, -1])


@dataclass(frozen=True, eq=False)
class Optimum:
    """A candidate at its best, and the derivatives there."""

    candidate: Hypothesis
    products: Products
    motion: Any  # pinned: the MeasuredMotion along which; free: what the sensors would show
    damping: float = DAMPING
    harder: float = HARDER  # by how much the next step is damped more, should this one fail
    resting: bool = False

    @property
    def square(self) -> float:
        return self.products.square

    @property
    def sound(self) -> bool:
        """Are its sum of squares and all derivatives finite?"""
        return bool(np.isfinite(self.products.total).all())
