"""Does it hold on data that the fit has not seen?"""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.evidence.prediction import Prediction, Proof
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum, Products
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.optimise import FEWER_ROUNDS, STEADY, descend, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording

LOOKS = 3  # at a held-out segment, to find where it begins
EARLY = 0.6  # of a single segment, on which the fit is made where there is no other
TRAINING_ROUNDS = 5  # from where all segments have it


def predict(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """Hold out every segment in turn; of a single one its end."""
    single = prepared.segments == 1
    return predict_end(prepared, at) if single else predict_others(prepared, at)


def proof(prepared: PreparedRecording, before: Prediction, after: Prediction) -> Proof:
    """Two predictions of the same data, side by side."""
    seen = prepared.seen
    noise = seen.angle_weight
    floor = float(np.sqrt(np.mean(1 / noise[noise > 0] ** 2)))
    data = (np.asarray(seen.time), np.asarray(seen.angle))
    return Proof(before, after, *data, floor, prepared.segments == 1)


def predict_others(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """Every segment from the others: leg and terms from them, only its own start from itself."""
    held_out = np.eye(prepared.segments, dtype=bool)[:, :, None]
    training = [masked(prepared.seen, ~each) for each in held_out]
    candidates = side_by_side(
        lambda each: settle_free(prepared, at.candidate, each, rounds=TRAINING_ROUNDS).candidate,
        training,
    )
    began = side_by_side(lambda each: started(prepared, *each), enumerate(candidates))
    shown = np.stack([each.motion[number] for number, each in enumerate(began)])
    return prediction(prepared.seen, shown, np.asarray(prepared.seen.angle_weight) > 0)


def masked(seen: Observation, kept: np.ndarray) -> Observation:
    """The observation with weight only where it is kept."""
    weights = {name: getattr(seen, name) * kept for name in ("angle_weight", "velocity_weight")}
    return replace(seen, **weights)


def started(prepared: PreparedRecording, number: int, candidate: Hypothesis) -> Optimum:
    """The candidate with what the segment `number` owns brought to its best there."""
    own = [each[number] for each in jax.tree.leaves(prepared.numbers.own)]
    asked = np.isin(np.arange(candidate.unknowns.size + 1), [*own, candidate.unknowns.size])

    def evaluate(prepared, tried):
        found = [release(prepared, one) for one, _ in tried]
        return [(there(products), motion) for products, motion in found]

    def there(products: Products) -> Products:
        return Products(products.each[[number]] * np.outer(asked, asked), 0.0 * products.usual)

    return descend(prepared, [(candidate, None)], evaluate, LOOKS, STEADY)[0]


def predict_end(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """The end of a single segment, from a fit of its beginning."""
    seen = prepared.seen
    used = np.asarray(seen.angle_weight) > 0
    last = np.flatnonzero(used[0])
    early = np.arange(used.shape[1]) <= last[int(EARLY * last.size)]
    fitted = settle_free(prepared, at.candidate, masked(seen, early), rounds=FEWER_ROUNDS)
    return prediction(seen, np.asarray(fitted.motion), used & ~early)


def prediction(seen: Observation, shown: np.ndarray, counted: np.ndarray) -> Prediction:
    """Compare what was predicted with the samples that count."""
    angle = np.where(counted, shown[..., 0] - seen.angle, 0.0)
    velocity = np.where(counted, shown[..., 1] - seen.angular_velocity, 0.0)
    squares = (seen.angle_weight * angle) ** 2 + (seen.velocity_weight * velocity) ** 2
    number = counted.sum(axis=1)
    rmse = np.sqrt((angle**2).sum(axis=1) / np.maximum(number, 1))
    return Prediction(shown[..., 0], counted, rmse, squares.sum(axis=1))
