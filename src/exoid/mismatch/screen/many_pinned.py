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
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Products
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import of, of_all_segments, summed

FEW = 4  # parameters that it has room for in a candidate, or twice as many, and so on
LARGEST = 150_000  # samples of candidates that are worked out together: some 100 MB
KEPT = 300_000  # samples of candidates whose terms' effects are held at once: some 50 MB
PROGRAM = 200_000  # derivatives by a sample and a column in one program: some 100 MB
FOLD = "exoid.mismatch.screen.pinned:fold"
GRAM = jax.tree.structure(np.zeros(()))


def evaluate(
    prepared: PreparedRecording, tried: Sequence[Tried], tether: float = 0.0
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of every candidate, and the motion along which they are."""
    most = max(1, LARGEST // prepared.seen.time.size)
    return [each for some in parts(tried, most) for each in folded(prepared, some, tether)]


def folded(
    prepared: PreparedRecording, tried: Sequence[Tried], tether: float
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of as many candidates as memory has room for."""
    seen = read(prepared, tried)
    grams = fold(prepared, seen, nothing(prepared, 0), tether)
    each = zip(seen, grams, strict=True)
    return [(placed(prepared, one, gram), motion) for (one, motion), gram in each]


def with_columns(
    prepared: PreparedRecording, tried: Sequence[Tried], beside: Effect, tether: float = 0.0
) -> list[np.ndarray]:
    """(J, n, r)'(J, n, r) of each candidate along its motion, over all its unknowns, over what may
    act or be shown `beside`: (column, segment, time), and the residual.
    """
    size = beside.shown.shape[0]

    def whole(one: Hypothesis, gram: np.ndarray) -> np.ndarray:
        count, last = own_columns(prepared, one), gram.shape[-1] - 1
        rows = [*range(count), *range(last - size, last + 1)]
        return summed(gram[:, rows][:, :, rows], prepared.places, one.point.size)

    most = max(AT_ONCE, KEPT // prepared.seen.time.size)
    return [
        whole(one, gram)
        for some in parts(tried, most)
        for (one, _), gram in zip(
            some, fold(prepared, some, beside, tether, len(tried)), strict=True
        )
    ]


def fold(
    prepared: PreparedRecording,
    seen: Sequence[Tried],
    beside: Effect,
    tether: float = 0.0,
    most: int = AT_ONCE,
) -> list[np.ndarray]:
    """(J, r)'(J, r) of every candidate and segment, with what else may act or be shown `beside`;
    at most so many candidates to a program, and fewer where their segments are long.
    """
    found = effects(prepared, seen)
    widths = defaultdict(list)
    for row, effect in enumerate(found):
        widths[room(effect.shown.shape[0] - 1)].append(row)
    batches = [
        (width, filled(rows, size))
        for width, each in widths.items()
        for size in [min(most, at_once(prepared, width + beside.shown.shape[0]))]
        for rows in parts(each, size)
    ]

    def run(batch, segments: np.ndarray) -> np.ndarray:
        width, rows = batch
        legs = [prepared.coordinates(seen[row][0]) for row in rows]
        along = of(segments, stacked(seen[row][1] for row in rows), 1)
        does = of(segments, stacked(widened(found[row], width, beside) for row in rows), 2)
        zero = np.array([seen[row][0].zero for row in rows])
        around = (of(segments, prepared.seen), of(segments, prepared.problem.known))
        numbers = (np.asarray(prepared.problem.steps), np.asarray(float(tether)))
        arguments = (of_legs(segments, legs), along, does, zero, *around, *numbers)
        return called(FOLD, arguments, prepared.problem.chain, GRAM)

    grams: dict[int, np.ndarray] = {}
    answers = of_all_segments(run, batches, prepared.segments, GROUP, 1)
    for (_, rows), answer in zip(batches, answers, strict=True):
        grams.update(zip(rows, answer, strict=True))
    return [grams[row] for row in range(len(seen))]


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


def placed(prepared: PreparedRecording, candidate: Hypothesis, gram: np.ndarray) -> Products:
    """The products over all unknowns of a candidate."""
    count = own_columns(prepared, candidate)
    return prepared.products(candidate, gram, [*range(count), gram.shape[-1] - 1])


def own_columns(prepared: PreparedRecording, candidate: Hypothesis) -> int:
    """Of a segment's derivatives: baseline unknowns, zeros and terms."""
    return prepared.places.shape[1] + 2 + sum(value.size for value in candidate.values)
