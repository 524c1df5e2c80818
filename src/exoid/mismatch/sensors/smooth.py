"""The motion that the sensors show, smoothed without any leg model.

Angle, rate and acceleration of every sample are unknowns tied by a jerk that is white noise;
encoder and gyro are met within their noise. The jerk scatters as makes the data most likely. What
strikes the leg between two samples is no such jerk: nothing ties these samples together.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement

import numpy as np
from jaxtyping import Bool, Float
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded

JERKS = np.logspace(1, 5, 9)  # rad/s^3, deviations to choose from
UNKNOWN = 3  # a sample: angle, rate, acceleration
BAND = 2 * UNKNOWN - 1  # beside the diagonal
FREE = 1e3  # times the jerk's scatter, by which a struck step ties its samples
SLACK = 0.05  # of a step's change by the jerk, that no quadrature need meet
UNSURE = 1.5  # times the middle's error of the acceleration, that is clearly more
FAR, LOOKS = 4, 24  # widths from an end within which it becomes sure, and places to look there
# Of the encoder's noise: where the jerk changes the angle by less in a step, rounding bends the
# motion more than the noise does.
ROUNDED = 5e-4

Samples = Float[np.ndarray, " sample"]
Steps = Bool[np.ndarray, " step"]
Relation = dict[int, Float[np.ndarray, " step"]]  # of which unknown at a step's ends, how much
Pairs = Float[np.ndarray, "sample 2"]  # of encoder [rad] and gyro [rad/s]


@dataclass(frozen=True, eq=False)
class Reference:
    """One segment's motion at its samples."""

    angle: Samples  # rad
    angular_velocity: Samples  # rad/s
    angular_acceleration: Samples  # rad/s^2
    likelihood: float  # log, but for a constant
    jerks: Float[np.ndarray, " step"]  # changes of the acceleration, over how far they scatter
    smoother: "Smoother"


class Smoother:
    """The least squares problem of one segment for one scatter of the jerk."""

    def __init__(self, time: Samples, weights: Pairs, jerk: float, struck: Steps):
        step = np.diff(time)
        change = jerk * step * np.where(struck, FREE, 1.0)
        self.size, self.weights = time.size, weights
        self.made_of = time, jerk, struck
        self.relations = relations(step, change)
        self.log_scale = float(np.sum(np.log(change)))
        normal = banded(self.relations, self.size)
        normal[-1, 0::UNKNOWN] += weights[:, 0] ** 2
        normal[-1, 1::UNKNOWN] += weights[:, 1] ** 2
        self.factor = cholesky_banded(normal)

    @property
    def log_scatter(self) -> float:
        """Log of how far the jerk lets data scatter, but for a constant: part of a likelihood."""
        return -float(np.sum(np.log(self.factor[-1]))) - 3 * self.log_scale

    def solve(self, data: Float[np.ndarray, "sample 2 *column"]) -> np.ndarray:
        """The smoothed unknowns (sample, 3, column) of data and of columns alike."""
        weighted = self.weights.reshape(*self.weights.shape, *[1] * (data.ndim - 2)) ** 2 * data
        right = np.zeros((self.size, UNKNOWN, *data.shape[2:]))
        right[:, :2] = weighted
        flat = right.reshape(UNKNOWN * self.size, -1)
        return cho_solve_banded((self.factor, False), flat).reshape(right.shape)

    def left(self, data: Float[np.ndarray, "sample 2 *column"]) -> np.ndarray:
        """What of the data the motion cannot follow, over the noise; jerk included: one row."""
        smooth = self.solve(data)
        weights = self.weights.reshape(*self.weights.shape, *[1] * (data.ndim - 2))
        misfit = weights * (data - smooth[:, :2])
        ends = [smooth[:-1, place] for place in range(UNKNOWN)]
        ends += [smooth[1:, place] for place in range(UNKNOWN)]
        jerks = [sum_of(each, ends).reshape(self.size - 1, -1) for each in self.relations]
        return np.concatenate([misfit.reshape(2 * self.size, -1), *jerks])

    def spread(self, width: int = 1) -> float:
        """Standard deviation of the acceleration [rad/s^2], averaged over `width` samples in the
        middle: the errors of neighbours cancel.
        """
        return float(self.spreads([max(0, (self.size - width) // 2)], width)[0])

    def spreads(self, first: Sequence[int], width: int) -> np.ndarray:
        """The same of the samples from each of these on."""
        pick = np.zeros((self.size, UNKNOWN, len(first)))
        for column, begin in enumerate(first):
            pick[begin : begin + width, 2, column] = 1 / width
        flat = pick.reshape(-1, len(first))
        return np.sqrt(np.sum(flat * cho_solve_banded((self.factor, False), flat), axis=0))

    def unsure(self, width: int) -> int:
        """At an end, how many samples have an averaged acceleration that is clearly less sure than
        in the middle: beyond it there are no data. What strikes the leg is smeared over as many.
        """
        farthest = min(self.size // 3, FAR * width)
        begins = np.unique(np.linspace(0, farthest, LOOKS).astype(int)).tolist()
        sure = self.spreads(begins, width) <= UNSURE * self.spread(width)
        return begins[int(np.argmax(sure))] if sure.any() else farthest


def relations(step: np.ndarray, change: np.ndarray) -> list[Relation]:
    """How the unknowns at both ends of every `step` hang together, over how far they may differ
    where the jerk's `change` of the acceleration scatters.

    Hermite's and the trapezoidal rule: exact for a constant jerk within the step.
    """
    bend, slope = step**2 / 12, step / 2

    def over(spread, *factors: float | np.ndarray) -> list[np.ndarray]:
        return [np.broadcast_to(factor, step.shape) / spread for factor in factors]

    return [
        dict(
            enumerate(over(SLACK * change * step**2 / 12, -1.0, -slope, -bend, 1.0, -slope, bend))
        ),
        dict(
            zip(
                (1, 2, 4, 5),
                over(SLACK * change * step / 2, -1.0, -slope, 1.0, -slope),
                strict=True,
            )
        ),
        dict(zip((2, 5), over(change * np.sqrt(step[0] / step), -1.0, 1.0), strict=True)),
    ]


def banded(every: list[Relation], size: int) -> np.ndarray:
    """The upper diagonals of the relations' products, as SciPy's banded solvers take them."""
    upper = np.zeros((BAND + 1, UNKNOWN * size))
    for each in every:
        pairs = combinations_with_replacement(each, 2)
        for first, second in sorted(pairs, key=lambda pair: pair[0] < UNKNOWN):
            products = each[first] * each[second]
            upper[BAND - second + first, second::UNKNOWN][: products.size] += products
    return upper


def sum_of(relation: Relation, ends: list[np.ndarray]) -> np.ndarray:
    """What a relation makes of the unknowns at both ends of every step, each (step, *column)."""
    shape = (-1, *[1] * (ends[0].ndim - 1))
    total = np.zeros_like(ends[0])
    for place, factor in relation.items():
        total += factor.reshape(shape) * ends[place]
    return total


def smooth(time: Samples, data: Pairs, weights: Pairs, struck: Steps | None = None) -> Reference:
    """The motion of greatest likelihood; rows of weight 0 were not measured."""
    known = np.zeros(time.size - 1, bool) if struck is None else struck
    made = (smoother_of(time, weights, jerk, known) for jerk in JERKS)
    found = [smoothed(each, data) for each in made if each is not None]
    return max(found, key=lambda each: each.likelihood)


def smoother_of(time: Samples, weights: Pairs, jerk: float, struck: Steps) -> Smoother | None:
    """For one scatter of the jerk [rad/s^3]; None where rounding would be larger than the noise.

    The largest of `JERKS` always leaves one.
    """
    step, weight = float(np.median(np.diff(time))), float(weights[:, 0].max())
    if jerk < JERKS[-1] and jerk * step**3 * weight < ROUNDED:
        return None
    try:
        return Smoother(time, weights, jerk, struck)
    except LinAlgError:  # steps that are much shorter than most
        return None


def reweighed(smoother: Smoother, weights: Pairs) -> Smoother:
    """The same where other samples were measured."""
    time, jerk, struck = smoother.made_of
    return smoother_of(time, weights, jerk, struck) or smoother


def smoothed(smoother: Smoother, data: Pairs) -> Reference:
    """The motion by a smoother."""
    motion = smoother.solve(data)
    left = smoother.left(data)
    likelihood = smoother.log_scatter - float(np.sum(left**2)) / 2
    jerks = left[1 - smoother.size :, 0]
    angle, velocity, acceleration = motion.T
    return Reference(angle, velocity, acceleration, likelihood, jerks, smoother)
