"""Many candidates at once through the compiled programs that pin them to the data."""

from collections import defaultdict
from collections.abc import Sequence

import jax
import numpy as np

from exoid.fitting.solve.program_cache import called
from exoid.mismatch.screen.along_motion import (
    AT_ONCE,
    GROUP,
    Tried,
    effects,
    filled,
    nothing,
    of_legs,
    parts,
    read,
    stacked,
)
from exoid.mismatch.screen.deviation import Deviations
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Products
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import of, of_all_segments, summed

FEW = 4  # parameters that it has room for in a candidate, or twice as many, and so on
LARGEST = 150_000  # samples of candidates that are worked out together: some 100 MB
PROGRAM = 200_000  # derivatives by a sample and a column in one program: some 100 MB
DEVIATE = "exoid.mismatch.screen.pinned:deviate"
FOUND = jax.tree.structure(Deviations(*[np.zeros((1, 1))] * 2))


def evaluate(
    prepared: PreparedRecording, tried: Sequence[Tried], tether: float = 0.0
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of every candidate, and the motion along which they are."""
    return [each for some in in_memory(prepared, tried) for each in folded(prepared, some, tether)]


def in_memory(prepared: PreparedRecording, tried: Sequence[Tried]) -> list[list[Tried]]:
    """As many at a time as memory has room for."""
    return parts(tried, max(1, LARGEST // prepared.seen.time.size))


def folded(
    prepared: PreparedRecording, tried: Sequence[Tried], tether: float
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of as many candidates as memory has room for."""
    seen = read(prepared, tried)
    each = zip(seen, deviations(prepared, seen, nothing(prepared, 0), tether), strict=True)
    return [
        (prepared.products(one, own(prepared, one, found.gram)), motion)
        for (one, motion), found in each
    ]


def with_columns(
    prepared: PreparedRecording, tried: Tried, beside: Effect, tether: float = 0.0
) -> np.ndarray:
    """(J, n, r)'(J, n, r) of a candidate along its motion, over all its unknowns, over what may act
    or be shown `beside`: (column, segment, time), and the residual.
    """
    (found,) = deviations(prepared, [tried], beside, tether, 1)
    kept = own(prepared, tried[0], found.gram, beside.shown.shape[0])
    return summed(kept, prepared.places, tried[0].point.size)


def with_errors(
    prepared: PreparedRecording, tried: Sequence[Tried], errors: np.ndarray
) -> list[np.ndarray]:
    """J'(J, e) of every candidate, over all its unknowns, e being errors that the sensors show
    beside: (error, segment, time, channel).
    """
    still = nothing(prepared, 0)

    def table(one: Hypothesis, found: Deviations) -> np.ndarray:
        count = own_columns(prepared, one)
        slopes, shown = found.rows[:, :count], by_errors(prepared, found.rows, errors)
        both = np.concatenate([found.gram[:, :count, :count], slopes @ shown], axis=2)
        return summed(both, prepared.places, one.point.size)

    return [
        table(one, found)
        for some in in_memory(prepared, tried)
        for (one, _), found in zip(some, deviations(prepared, some, still), strict=True)
    ]


def by_errors(prepared: PreparedRecording, rows: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """What errors do to the residual of a candidate, (segment, sample, error): as much as its zeros
    do, times their size.
    """
    first = prepared.places.shape[1]
    each = rows[:, first : first + 2].reshape(len(rows), 2, -1, 2)
    gyro, encoder = each[:, 0, :, 1], each[:, 1, :, 0]
    seen = errors * np.stack([encoder, gyro], axis=-1)
    return np.moveaxis(seen.reshape(*seen.shape[:2], -1), 0, 2)


def deviations(
    prepared: PreparedRecording,
    seen: Sequence[Tried],
    beside: Effect,
    tether: float = 0.0,
    most: int = AT_ONCE,
) -> list[Deviations]:
    """Of every candidate, of every segment, with what else may act or be shown `beside`; at most
    so many candidates to a program, and fewer where their segments are long.
    """
    found, legs = effects(prepared, seen), [prepared.coordinates(one) for one, _ in seen]
    widths = defaultdict(list)
    for row, effect in enumerate(found):
        widths[room(effect.shown.shape[0] - 1)].append(row)
    batches = [
        (width, filled(rows, size))
        for width, each in widths.items()
        for size in [min(most, at_once(prepared, width + beside.shown.shape[0]))]
        for rows in parts(each, size)
    ]

    def run(batch, segments: np.ndarray) -> Deviations:
        width, rows = batch
        leg = of_legs(segments, [legs[row] for row in rows])
        along = of(segments, stacked(seen[row][1] for row in rows), 1)
        does = of(segments, stacked(widened(found[row], width, beside) for row in rows), 2)
        zero = np.array([seen[row][0].zero for row in rows])
        around = (of(segments, prepared.seen), of(segments, prepared.problem.known))
        numbers = (np.asarray(prepared.problem.steps), np.asarray(float(tether)))
        arguments = (leg, along, does, zero, *around, *numbers)
        return called(DEVIATE, arguments, prepared.problem.chain, FOUND)

    each: dict[int, Deviations] = {}
    answers = of_all_segments(run, batches, prepared.segments, GROUP, 1)
    for (_, rows), answer in zip(batches, answers, strict=True):
        leaves = zip(rows, answer.gram, answer.rows, strict=True)
        each |= {row: Deviations(gram, own) for row, gram, own in leaves}
    return [each[row] for row in range(len(seen))]


def at_once(prepared: PreparedRecording, beside: int) -> int:
    """How many candidates a program takes, by the samples of its segments and their columns."""
    columns = prepared.places.shape[1] + 2 + beside + 1
    return int(np.clip(PROGRAM // (GROUP * prepared.seen.time.shape[1] * columns), 1, AT_ONCE))


def room(parameters: int) -> int:
    """How many parameters the program that serves so many has room for."""
    width = FEW
    while width < parameters:
        width *= 2
    return width


def widened(effect: Effect, width: int, beside: Effect) -> Effect:
    """Derivatives by so many parameters, what is beside, and what all terms do behind them."""

    def wide(leaf: np.ndarray, other: np.ndarray) -> np.ndarray:
        nothing = np.zeros((1 + width - leaf.shape[0], *leaf.shape[1:]))
        return np.concatenate([leaf[1:], nothing, other, leaf[:1]])

    return jax.tree.map(wide, effect, beside)


def own(
    prepared: PreparedRecording, candidate: Hypothesis, gram: np.ndarray, beside: int = 0
) -> np.ndarray:
    """Of every segment's products its own: those of baseline unknowns, zeros, terms, so many
    `beside`, and residual.
    """
    last = gram.shape[-1] - 1
    rows = [*range(own_columns(prepared, candidate)), *range(last - beside, last + 1)]
    return gram[:, rows][:, :, rows]


def own_columns(prepared: PreparedRecording, candidate: Hypothesis) -> int:
    """Of a segment's derivatives: baseline unknowns, zeros and terms."""
    return prepared.places.shape[1] + 2 + sum(value.size for value in candidate.values)
