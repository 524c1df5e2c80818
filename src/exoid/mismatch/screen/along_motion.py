"""What the terms of many candidates do along their motions, by the programs of each term."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeVar

import jax
import numpy as np

from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.solve.program_cache import called
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Linear
from exoid.mismatch.screen.measured_motion import MeasuredMotion, SegmentMotion, behind
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import of, of_all_segments
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.motion.step import Drive
from exoid.physics.ratios import Ratios
from exoid.physics.term import Term, brief

GROUP = 2  # segments of a program, so that one serves every recording
AT_ONCE = 8  # candidates of a program that serves all terms
ALONG = "exoid.mismatch.screen.pinned:along"
SHOW = "exoid.mismatch.screen.pinned:show"
ACT = "exoid.mismatch.screen.pinned:act"
NUMBER, ROW = np.zeros(()), np.zeros(1)
CYCLE = Cycle(NUMBER, NUMBER, NUMBER, NUMBER)
PLACE = SegmentConstants(Ratios(NUMBER, NUMBER, NUMBER), NUMBER, CYCLE, NUMBER)
MOMENT = Moment(NUMBER, NUMBER, NUMBER, NUMBER, PLACE)
MOTION = jax.tree.structure(SegmentMotion(MOMENT, MOMENT, MOMENT, MOMENT, ROW, ROW))
STEPS, SAMPLES = np.zeros((1, 1, 1)), np.zeros((1, 1, 1, 2))
ANGLE = jax.tree.structure(STEPS)
EFFECT = jax.tree.structure(Effect(Drive(STEPS, STEPS, STEPS), SAMPLES))
Row = TypeVar("Row")
Tried = tuple[Hypothesis, MeasuredMotion]  # a candidate, and the motion that it had last


def linear(prepared: PreparedRecording, tried: Sequence[Tried]) -> list[Linear]:
    """What all terms of candidates do along their motions."""
    seen = read(prepared, [(replace(one, linear=None), motion) for one, motion in tried])
    return [
        Linear(effect, np.concatenate(one.values), len(one.terms))
        for (one, _), effect in zip(seen, effects(prepared, seen), strict=True)
    ]


def read(prepared: PreparedRecording, tried: Sequence[Tried]) -> list[Tried]:
    """The candidates with the leg's motion behind what the sensors show, if their terms are right.

    What the sensors show otherwise depends on the motion itself: it is that along the last one.
    """
    found = asked(prepared, tried, SHOW, ANGLE, lambda term: term.shown is not Term.shown)
    time = prepared.seen.time

    def error(row: int, one: Hypothesis) -> np.ndarray:
        shown = [] if one.linear is None else [moved(one, one.linear).shown[0, ..., 0]]
        return sum([*shown, *found[row].values()], np.full(time.shape, one.zero[1]))

    return [
        (one, behind(prepared.measured_motion, error(row, one), time))
        for row, (one, _) in enumerate(tried)
    ]


def effects(prepared: PreparedRecording, seen: Sequence[Tried]) -> list[Effect]:
    """What all terms of every candidate do together: (1 + parameter, segment, time)."""
    found = asked(prepared, seen, ACT, EFFECT)
    still = nothing(prepared, 1)

    def joined(*leaves: np.ndarray) -> np.ndarray:
        together = sum(leaf[:1] for leaf in leaves)
        return np.concatenate([together, *(leaf[1:] for leaf in leaves)])

    def all_of(row: int, one: Hypothesis) -> Effect:
        known = [] if one.linear is None else [moved(one, one.linear)]
        each = [*known, *(found[row][term] for term, _ in one.asked)]
        return jax.tree.map(joined, still, *each)

    return [all_of(row, one) for row, (one, _) in enumerate(seen)]


def effects_of_last(
    prepared: PreparedRecording, starts: list[Hypothesis], motion: MeasuredMotion
) -> list[Effect]:
    """What the last cause of each does along the same motion: (1 + parameter, segment, time)."""
    found = asked(prepared, [(start, motion) for start in starts], ACT, EFFECT)
    return [one[start.terms[-1]] for start, one in zip(starts, found, strict=True)]


def nothing(prepared: PreparedRecording, rows: int) -> Effect:
    """So many that do nothing."""
    segments, size = prepared.seen.time.shape
    still = np.zeros((rows, segments, size - 1))
    return Effect(Drive(still, still, still), np.zeros((rows, segments, size, 2)))


def moved(one: Hypothesis, known: Linear) -> Effect:
    """What the linear terms of a candidate do now."""
    change = np.concatenate(one.values[: known.count]) - known.at

    def now(leaf: np.ndarray) -> np.ndarray:
        return np.concatenate([leaf[:1] + np.tensordot(change, leaf[1:], 1), leaf[1:]])

    return jax.tree.map(now, known.effect)


def asked(
    prepared: PreparedRecording,
    tried: Sequence[Tried],
    program: str,
    structure: Any,
    wanted: Callable[[type[Term]], bool] = lambda term: True,
) -> list[dict[type[Term], Any]]:
    """What a program of the terms that candidates ask for finds along their motions, of each."""
    requests = defaultdict(list)
    for row, (one, _) in enumerate(tried):
        for term, value in one.asked:
            if wanted(term):
                requests[term].append((row, value))
    if not requests:
        return [{} for _ in tried]
    asking = sorted({row for each in requests.values() for row, _ in each})
    place = {row: number for number, row in enumerate(asking)}
    motions = motions_of(prepared, [tried[row] for row in asking])

    def run(batch, segments: np.ndarray):
        term, rows, values = batch
        which = np.array([place[row] for row in rows])[:, None]
        along = jax.tree.map(lambda leaf: leaf[which, segments], motions)
        return called(program, (values, along), term, structure, brief=brief(term))

    batches = []
    for term, each in requests.items():
        size = max(2, len(prepared.starts(term)))
        for some in parts(each, size):
            rows, values = zip(*filled(some, size), strict=True)
            batches.append((term, rows, np.array(values, float)))
    axis = {ANGLE: 1, EFFECT: 2}[structure]
    results: list[dict[type[Term], Any]] = [{} for _ in tried]
    answers = of_all_segments(run, batches, prepared.segments, GROUP, axis)
    for (term, rows, _), answer in zip(batches, answers, strict=True):
        for number, row in enumerate(rows):
            results[row][term] = jax.tree.map(lambda leaf, at=number: leaf[at], answer)
    return results


def motions_of(prepared: PreparedRecording, tried: Sequence[Tried]) -> SegmentMotion:
    """What terms see of every candidate's motion: (candidate, segment, ...)."""
    legs = [prepared.coordinates(one) for one, _ in tried]

    def run(rows: list[int], segments: np.ndarray) -> SegmentMotion:
        own = of_legs(segments, [legs[row] for row in rows])
        measured = of(segments, stacked(tried[row][1] for row in rows), 1)
        given = (own, measured, of(segments, prepared.seen))
        return called(ALONG, given, None, MOTION, brief=True)

    batches = [filled(some, AT_ONCE) for some in parts(range(len(tried)), AT_ONCE)]
    answers = of_all_segments(run, batches, prepared.segments, GROUP, 1)
    return jax.tree.map(lambda *leaves: np.concatenate(leaves)[: len(tried)], *answers)


def of_legs(segments: np.ndarray, points: Iterable[Coordinates]) -> Coordinates:
    """These segments of many legs."""
    legs = stacked(points)
    return replace(legs, own=of(segments, legs.own, 1))


def parts(each: Sequence[Row], size: int) -> list[list[Row]]:
    """So many at a time."""
    return [list(each[first : first + size]) for first in range(0, len(each), size)]


def filled(each: list[Row], size: int) -> list[Row]:
    """With the first again, until there are so many."""
    return [*each, *each[:1] * (size - len(each))]


def stacked(trees: Iterable[Any]) -> Any:
    return jax.tree.map(lambda *leaves: np.stack(leaves), *trees)
