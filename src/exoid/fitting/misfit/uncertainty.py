"""Standard errors, and whether the data, the prior or a bound determined a value."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from jaxtyping import Float
from scipy.special import erfcx

Source = Literal["data", "prior", "both", "bound"]

ROUNDING = 1e-11  # relative eigenvalue that is none
NOTHING = 1e-13  # of the largest information: rounding of none
VAGUE = 1e-2  # per typical step squared, known of everything: no leg is tens of them away
ON_BOUND = 1e-4  # relative size of what is left of a gradient where an end point lies on a limit
STEEP = 300.0  # t from which on x^2 is nothing beside t x
EVENLY = 1 / 3  # mean square of what is anywhere between 0 and 1
DECIDED = 0.9  # share of the precision from which on one source alone determined a value


@dataclass(frozen=True)
class Shares:
    """What part of a value's precision came from where; the three add up to 1."""

    data: float
    prior: float
    bound: float
    kind: str | None = None  # of the segments that told what data did, where others told little

    @property
    def source(self) -> Source:
        """Who determined the value."""
        if self.bound > max(self.data, self.prior):
            return "bound"
        if self.data >= DECIDED:
            return "data"
        return "prior" if self.prior >= DECIDED else "both"


HELD = Shares(0.0, 0.0, 1.0)  # on a bound


@dataclass(frozen=True)
class Pressed:
    """Limits g <= 0 that an end point leans against."""

    gradients: Float[np.ndarray, "limit coordinate"]
    beyond: Float[np.ndarray, " limit"]  # the g of the optimum without that limit
    room: Float[np.ndarray, " limit"]  # to the other end, where there is one; else infinite


class Information:
    """Gauss-Newton information of a fit in its own coordinates, around the end point.

    `data` and `prior` are (coordinate, coordinate). Of constraints that hold as equalities there,
    `active` has the gradients, (constraint, coordinate), and `fixed` those of what a user fixed;
    `pressed` are limits that the end point leans against, as in `one_sided`. `kinds`
    has the parts of several kinds of segments, in any unit that they share; `owned` the
    coordinates of what recordings own.
    """

    def __init__(
        self,
        data: np.ndarray,
        prior: np.ndarray,
        active: np.ndarray,
        fixed: np.ndarray | None = None,
        kinds: dict[str, np.ndarray] | None = None,
        owned: dict[str, np.ndarray] | None = None,
        pressed: Pressed | None = None,
    ):
        self.open = np.eye(data.shape[0]) if fixed is None else null_space(fixed, data.shape[0])
        self.free = null_space(active, data.shape[0])
        known = self.free.T @ (data + prior) @ self.free
        if pressed is not None:
            inside = replace(pressed, gradients=pressed.gradients @ self.free)
            known = known + one_sided(known, inside)
        self.posterior = decomposed(known)
        self.likelihood = decomposed(self.free.T @ data @ self.free)
        self.unbounded = decomposed(self.open.T @ (data + prior) @ self.open)
        self.parts = (data, prior)
        self.kinds = {} if kinds is None else kinds
        self.owned = {} if owned is None else owned

    def standard_error(self, gradient: Float[np.ndarray, " coordinate"]) -> float:
        """Of a quantity with this gradient; inf where nothing determines it, 0 on a bound."""
        return spread(self.posterior, self.free, gradient)

    def without_bounds(self, gradient: Float[np.ndarray, " coordinate"]) -> float:
        """The standard error if no bound held, only what the user fixed."""
        return spread(self.unbounded, self.open, gradient)

    def shares(self, gradient: Float[np.ndarray, " coordinate"]) -> Shares | None:
        """Who made the error as small as it is; None where nothing did.

        With I = I_data + I_prior the variance is a'I^-1 a = a'I^-1 (I_data + I_prior) I^-1 a, a sum
        of what each contributes. What the variance would be without the bounds tells their part.
        """
        error = self.standard_error(gradient)
        if error == 0.0:
            return HELD
        if not np.isfinite(error):
            return None
        bound = max(0.0, 1 - (error / self.without_bounds(gradient)) ** 2)
        pull = inverse_times(self.posterior, self.free.T @ gradient)
        data, prior = (pull @ (self.free.T @ part @ self.free) @ pull for part in self.parts)
        rest = (1 - bound) / (data + prior)
        return Shares(float(data * rest), float(prior * rest), float(bound), self.kind(pull))

    def limits(self, gradient: Float[np.ndarray, " coordinate"]) -> dict[str, float]:
        """By what part the variance of a quantity would shrink were each of `owned` known exactly.

        Given x_g, the variance of a'x is a'C a - a'C_g C_gg^-1 C_g'a. The parts need not add up
        to 1: two that go together are each of them a part.
        """
        error = self.standard_error(gradient)
        if not np.isfinite(error) or error == 0.0 or self.root is None:
            return {}
        along = self.root.T @ gradient
        told = {name: axes @ along for name, axes in self.exactly.items()}
        return {name: float(each @ each / (along @ along)) for name, each in told.items()}

    @cached_property
    def root(self) -> np.ndarray | None:
        """W with W W' the covariance; None where rounding left a direction without information."""
        values, vectors = self.posterior
        root = self.free @ vectors / np.sqrt(np.where(values > 0, values, np.nan))
        return root if np.isfinite(root).all() else None

    @cached_property
    def exactly(self) -> dict[str, np.ndarray]:
        """Of each of `owned` the directions of `root` that it tells: orthonormal rows."""
        assert self.root is not None
        found = {}
        for name, at in self.owned.items():
            _, sizes, axes = np.linalg.svd(self.root[at], full_matrices=False)
            found[name] = axes[sizes > np.finfo(float).eps * len(self.root) * sizes.max(initial=0)]
        return found

    def kind(self, pull: Float[np.ndarray, " free"]) -> str | None:
        """Whose segments told nearly all of what is `pull`ed at; None where no one kind did."""
        told = {
            kind: float(pull @ (self.free.T @ part @ self.free) @ pull)
            for kind, part in self.kinds.items()
        }
        most = max(told, key=told.__getitem__, default=None)
        enough = most is not None and told[most] >= DECIDED * sum(told.values()) > 0
        return most if enough else None


def decomposed(information: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Its eigenvalues and vectors, with the vague belief that keeps errors within reason.

    Where hardly anything is told, an error is larger than the range in which the motion answers
    linearly: what leans on it a little must not inherit all of it. An eigenvalue within rounding of
    the largest is none: beside what a long recording tells, that may be as much as the vague belief
    itself, and a mass that no motion shows would seem told.
    """
    values, vectors = np.linalg.eigh(information)
    rounding = np.finfo(float).eps * values.size * np.abs(values).max(initial=0.0)
    return np.where(np.abs(values) > rounding, values, 0.0) + VAGUE, vectors


def one_sided(information: np.ndarray, pressed: Pressed) -> np.ndarray:
    """What limits tell of an end point on them: the truth may lie anywhere inside.

    Without its limit g would be normal around `beyond` with the error sigma. What is inside has the
    density exp(-t x - x^2 / 2), x = -g / sigma, t = beyond / sigma, and the mean square distance
    from the end point that the information returned here leaves.
    """
    told = np.zeros_like(information)
    rows = zip(pressed.gradients, pressed.beyond, pressed.room, strict=True)
    for gradient, beyond, room in rows:
        error = spread(decomposed(information + told), np.eye(gradient.size), gradient)
        if 0.0 < error < np.inf:
            left = min(second_moment(beyond / error), EVENLY * (room / error) ** 2)
            left = max(left, ROUNDING)
            told = told + (1 / left - 1) / error**2 * np.outer(gradient, gradient)
    return told


def second_moment(t: float) -> float:
    """E[x^2] for the density exp(-t x - x^2 / 2), x >= 0: 1 for t = 0, at last 2 / t^2."""
    if t > STEEP:
        return 2 / t**2
    mean = np.sqrt(2 / np.pi) / erfcx(t / np.sqrt(2)) - t
    return float(1 - t * mean)


def spread(decomposed, free, gradient) -> float:
    """sqrt(a' I^-1 a) within the `free` directions, from the eigenvalues and vectors of I there."""
    along = free.T @ gradient
    if along @ along <= ON_BOUND**2 * (gradient @ gradient):
        return 0.0
    values, vectors = decomposed
    variances = (vectors.T @ along) ** 2 / values
    variance = variances.sum()
    if VAGUE * (variances / values).sum() > DECIDED * variance:
        return np.inf  # nothing but the vague belief keeps it within reason
    return float(np.sqrt(variance))


def determined(values: np.ndarray) -> np.ndarray:
    """Which of the eigenvalues of an information are more than rounding."""
    return values > NOTHING * max(values.max(initial=0.0), 1.0)


def null_space(rows, size: int):
    """An orthonormal basis of the directions that leave every row's value unchanged."""
    if rows.shape[0] == 0:
        return np.eye(size)
    _, values, vectors = np.linalg.svd(rows)
    rank = int(np.sum(values > 1e-9 * values[0]))
    return vectors[rank:].T


def inverse_times(decomposed, vector):
    """I^-1 a."""
    values, vectors = decomposed
    return vectors @ ((vectors.T @ vector) / values)


def whitening(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions along which `normal` is the identity, over the units of its diagonal."""
    diagonal = np.sqrt(np.maximum(np.diag(normal), 0.0))
    unit = np.where(diagonal > 0, diagonal, 1.0)
    values, vectors = np.linalg.eigh(normal / np.outer(unit, unit))
    known = values > ROUNDING
    return vectors[:, known] / np.sqrt(values[known]), unit
