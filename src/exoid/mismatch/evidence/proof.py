"""Does it hold on data that the fit has not seen?"""

import jax
import numpy as np
from jaxtyping import Bool

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.evidence.prediction import Prediction, Proof
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum, Products
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.optimise import STEADY, descend, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.parameter import declarations

LOOKS = 3  # at a held-out segment, to find where it begins
QUARTERS = 4  # of a single segment, each predicted from the others
ENCODER = 1  # place of its zero among the zeros of a candidate
TRAINING_ROUNDS = 5  # from where all segments have it


def predict(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """Hold out every segment in turn; of a single one every quarter."""
    single = prepared.segments == 1
    return predict_quarters(prepared, at) if single else predict_others(prepared, at)


def proof(prepared: PreparedRecording, before: Prediction, after: Prediction) -> Proof:
    """Two predictions of the same data, side by side."""
    seen = prepared.seen
    noise = seen.angle_weight
    floor = float(np.sqrt(np.mean(1 / noise[noise > 0] ** 2)))
    data = (np.asarray(seen.time), np.asarray(seen.angle))
    return Proof(before, after, *data, floor, prepared.segments == 1)


def predict_others(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """Every segment from the others: leg and terms from them, only its own start from itself, and
    of two segments the zero where that moves from one to the other.
    """
    held_out = np.eye(prepared.segments, dtype=bool)[:, :, None]
    candidates = fitted_without(prepared, at, held_out)
    began = side_by_side(lambda each: started(prepared, at, *each), enumerate(candidates))
    shown = np.stack([each.motion[number] for number, each in enumerate(began)])
    used = np.asarray(prepared.seen.angle_weight) > 0
    return prediction(prepared.seen, shown, used, np.arange(prepared.segments)[:, None])


def predict_quarters(prepared: PreparedRecording, at: Optimum) -> Prediction:
    """Every quarter of a single segment from the others; where it begins only from itself."""
    seen = prepared.seen
    used = np.asarray(seen.angle_weight) > 0
    which = np.where(used, (np.cumsum(used, axis=1) - 1) * QUARTERS // used.sum(), -1)
    held_out = np.arange(QUARTERS)[:, None, None] == which
    first, *later = fitted_without(prepared, at, held_out)
    begun = started(prepared, at, 0, first, seen.weighed(held_out[0])).motion
    motions = [begun, *(release(prepared, each)[1] for each in later)]
    shown = np.select(list(held_out[..., None]), motions, 0.0)
    return prediction(seen, shown, used, which)


def fitted_without(
    prepared: PreparedRecording, at: Optimum, held_out: Bool[np.ndarray, "fold segment sample"]
) -> list[Hypothesis]:
    """The candidate as the rest has it, for each that is held out."""
    training = [prepared.seen.weighed(~each) for each in held_out]
    return side_by_side(
        lambda each: settle_free(prepared, at.candidate, each, rounds=TRAINING_ROUNDS).candidate,
        training,
    )


def started(
    prepared: PreparedRecording,
    at: Optimum,
    number: int,
    candidate: Hypothesis,
    observation: Observation | None = None,
) -> Optimum:
    """The candidate with what the segment `number` begins with brought to its best there."""
    begin = beginning(prepared, number, candidate)
    unknowns = candidate.unknowns
    unknowns[begin] = at.candidate.unknowns[begin]
    asked = np.isin(np.arange(unknowns.size + 1), [*begin, unknowns.size])

    def evaluate(prepared, tried):
        found = [release(prepared, one, observation) for one, _ in tried]
        return [(there(products), motion) for products, motion in found]

    def there(products: Products) -> Products:
        return Products(products.each[[number]] * np.outer(asked, asked), 0.0 * products.usual)

    return descend(prepared, [(candidate.at(unknowns), None)], evaluate, [LOOKS], STEADY)[0]


def beginning(prepared: PreparedRecording, number: int, candidate: Hypothesis) -> list[int]:
    """Which of the unknowns say how a segment begins: its own, those of terms that remember, and
    the encoder's zero where a lone other segment does not tell by how much that moved.
    """
    own = [int(each[number]) for each in jax.tree.leaves(prepared.numbers.own)]
    names = [(term, name) for term in candidate.terms for name, _ in declarations(term)]
    first = candidate.unknowns.size - len(names)
    if prepared.segments == 2 and any(term.moves_zero for term in candidate.terms):
        own.append(candidate.point.size + ENCODER)
    return own + [first + k for k, (term, name) in enumerate(names) if name == term.begun]


def prediction(
    seen: Observation,
    shown: np.ndarray,
    counted: Bool[np.ndarray, "segment sample"],
    fold: np.ndarray,
) -> Prediction:
    """Compare what was predicted with the samples that count, each in its fold.

    The folds are those of all samples, or one of every segment.
    """
    angle = np.where(counted, shown[..., 0] - seen.angle, 0.0)
    velocity = np.where(counted, shown[..., 1] - seen.angular_velocity, 0.0)
    squares = (seen.angle_weight * angle) ** 2 + (seen.velocity_weight * velocity) ** 2
    number = counted.sum(axis=1)
    rmse = np.sqrt((angle**2).sum(axis=1) / np.maximum(number, 1))
    folds = np.broadcast_to(fold, counted.shape)[counted]
    return Prediction(shown[..., 0], counted, rmse, np.bincount(folds, squares[counted]))
