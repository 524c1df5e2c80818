"""Does it hold on data that the fit has not seen?"""

from dataclasses import dataclass

import equinox as eqx
import numpy as np
from jaxtyping import Float

from exoid.diagnose.bench import Bench, Candidate, Products
from exoid.diagnose.settle import Settled, bounded, settle_free
from exoid.fit.observation import Observation

LOOKS = 3  # at a held-out segment, to find where it begins
EARLY = 0.6  # of a single segment, on which the fit is made where there is no other
ROUNDS = 12


@dataclass(frozen=True, eq=False)
class Prediction:
    """Segments as they were predicted by a fit of the others."""

    shown: Float[np.ndarray, "segment time channel"]  # rad, rad/s
    rmse: Float[np.ndarray, " segment"]  # rad
    counted: Float[np.ndarray, " segment"]  # samples
    squares: Float[np.ndarray, " segment"]  # of both channels over their noise

    @property
    def total(self) -> float:
        """rad, over all segments."""
        return float(np.sqrt(self.counted @ self.rmse**2 / self.counted.sum()))


@dataclass(frozen=True, eq=False)
class Proof:
    """The same prediction without and with what was found."""

    before: Prediction
    after: Prediction
    noise_floor: float  # rad
    in_time: bool  # a single segment, its end predicted from its beginning

    @property
    def better(self) -> int:
        """Segments that are predicted better than before."""
        return int(np.sum(self.after.squares < self.before.squares))

    @property
    def holds(self) -> bool:
        """Is most of it predicted better, and all of it together?"""
        most = 2 * self.better > self.after.squares.size
        return most and self.after.squares.sum() < self.before.squares.sum()


def prove(bench: Bench, base: Settled, best: Settled) -> Proof:
    """Hold out every segment in turn; of a single one its end."""
    single = len(bench.problem.movements) == 1
    predict = predict_end if single else predict_others
    noise = bench.seen.angle_weight
    floor = float(np.sqrt(np.mean(1 / noise[noise > 0] ** 2)))
    return Proof(predict(bench, base), predict(bench, best), floor, single)


def predict_others(bench: Bench, at: Settled) -> Prediction:
    """Every segment from the others: leg and terms from them, only its own start from itself."""
    count = len(bench.problem.movements)
    candidates = [without(bench, at, held_out) for held_out in range(count)]
    for _ in range(LOOKS):
        found = bench.release(candidates, bench.seen)
        candidates = [
            started(bench, candidate, products, number)
            for number, (candidate, (products, _)) in enumerate(zip(candidates, found, strict=True))
        ]
    found = bench.release(candidates, bench.seen)
    shown = np.stack([seen[number] for number, (_, seen) in enumerate(found)])
    return prediction(bench.seen, shown, np.asarray(bench.seen.angle_weight) > 0)


def without(bench: Bench, at: Settled, held_out: int) -> Candidate:
    """The candidate as the other segments have it: one Gauss-Newton step from where all do."""
    total = at.products.total - at.products.each[held_out]
    return moved(bench, at.candidate, total, np.zeros(at.candidate.unknowns.size, bool))


def started(bench: Bench, candidate: Candidate, products: Products, number: int) -> Candidate:
    """The candidate with what the segment `number` owns brought to its best there."""
    own = bench.places[number][-3:]
    fixed = np.ones(candidate.unknowns.size, bool)
    fixed[own] = False
    return moved(bench, candidate, products.each[number], fixed)


def moved(bench: Bench, candidate: Candidate, total: np.ndarray, fixed: np.ndarray) -> Candidate:
    unknowns = candidate.unknowns
    lower, upper = bench.bounds(candidate)
    lower, upper = lower - unknowns, upper - unknowns
    lower[fixed] = upper[fixed] = 0.0
    normal, gradient = total[:-1, :-1].copy(), total[:-1, -1].copy()
    normal[fixed], normal[:, fixed], gradient[fixed] = 0.0, 0.0, 0.0
    return candidate.at(unknowns + bounded(normal, gradient, 0.0, lower, upper))


def predict_end(bench: Bench, at: Settled) -> Prediction:
    """The end of a single segment, from a fit of its beginning."""
    seen = bench.seen
    used = np.asarray(seen.angle_weight) > 0
    last = np.flatnonzero(used[0])
    early = np.arange(used.shape[1]) <= last[int(EARLY * last.size)]
    training = eqx.tree_at(
        lambda seen: (seen.angle_weight, seen.velocity_weight),
        seen,
        (seen.angle_weight * early, seen.velocity_weight * early),
    )
    fitted = settle_free(bench, [at.candidate], training, rounds=ROUNDS)[0]
    return prediction(seen, np.asarray(fitted.course), used & ~early)


def prediction(seen: Observation, shown: np.ndarray, counted: np.ndarray) -> Prediction:
    """Compare what was predicted with the samples that count."""
    angle = np.where(counted, shown[..., 0] - seen.angle, 0.0)
    velocity = np.where(counted, shown[..., 1] - seen.angular_velocity, 0.0)
    squares = (seen.angle_weight * angle) ** 2 + (seen.velocity_weight * velocity) ** 2
    number = counted.sum(axis=1)
    rmse = np.sqrt((angle**2).sum(axis=1) / np.maximum(number, 1))
    return Prediction(shown, rmse, number.astype(float), squares.sum(axis=1))
