"""Many candidates at once through the compiled program that pins them to the data."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.program_cache import called
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Linear, Products, spread
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.screen.pinned import Given, Pinned, Requests
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import grouped
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.motion.step import Drive
from exoid.physics.parameter import declarations
from exoid.physics.term import Term

GROUP = 2  # segments of a program, so that one serves every recording
GIVEN = 4  # first terms that lanes may have linear, the first of them none
ROWS, TABLE = np.zeros((1, 1, 1)), np.zeros((1, 1, 1, 1))
NONE = Effect(Drive(ROWS, ROWS, ROWS), ROWS)
PINNED = jax.tree.structure(Pinned(TABLE, MeasuredMotion(ROWS, ROWS, ROWS), NONE))


def evaluate(
    prepared: PreparedRecording,
    candidates: list[Hypothesis],
    courses: list[MeasuredMotion],
    observation: Observation,
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of every candidate, and the course along which they are."""
    results: list[tuple[Products, MeasuredMotion] | None] = [None] * len(candidates)
    waiting = list(range(len(candidates)))
    while waiting:
        batch, waiting = packed(prepared, waiting, candidates)
        found = run(prepared, batch, candidates, courses, observation)
        for lane, number in enumerate(batch):
            own = jax.tree.map(lambda leaf, lane=lane: leaf[lane], found.course)
            results[number] = (placed(prepared, candidates[number], found.gram[lane]), own)
    return results  # type: ignore[return-value]


def linear(
    prepared: PreparedRecording, candidates: list[Hypothesis], courses: list[MeasuredMotion]
) -> list[Linear]:
    """What the terms of a few candidates do along their courses."""
    found = run(prepared, list(range(len(candidates))), candidates, courses, prepared.seen).first
    return [
        Linear(jax.tree.map(lambda leaf, lane=lane: leaf[lane], found), one.values[0])
        for lane, one in enumerate(candidates)
    ]


def together(each: list[Linear]) -> Linear:
    """Several terms that act at once, as one."""
    values = [one.at.size for one in each]

    def joined(*leaves: np.ndarray) -> np.ndarray:
        whole = np.zeros_like(leaves[0])
        whole[0] = sum(leaf[0] for leaf in leaves)
        rows = [leaf[1 : 1 + size] for leaf, size in zip(leaves, values, strict=True)]
        whole[1 : 1 + sum(values)] = np.concatenate(rows)
        return whole

    effect = jax.tree.map(joined, *(one.effect for one in each))
    return Linear(effect, np.concatenate([one.at for one in each]), len(each))


def room(prepared: PreparedRecording) -> dict[type[Term], int]:
    """How many requests of every term the compiled program takes at once."""
    return {term: max(2, len(prepared.starts(term))) for term in prepared.library}


def packed(
    prepared: PreparedRecording, waiting: list[int], candidates: list[Hypothesis]
) -> tuple[list[int], list[int]]:
    """As many of the waiting as fit into one run, and the rest."""
    space = room(prepared)
    lanes = sum(space.values())
    used: Counter[type[Term]] = Counter()
    batch, rest = [], []
    given: list[Linear] = []
    for number in waiting:
        one = candidates[number]
        wanted = Counter(one.asked)
        known = one.linear is None or any(one.linear is other for other in given)
        fits = all(used[term] + n <= space[term] for term, n in wanted.items())
        if fits and len(batch) < lanes and (known or len(given) < GIVEN - 1):
            used += wanted
            batch.append(number)
            given += [] if known or one.linear is None else [one.linear]
        else:
            rest.append(number)
    return batch, rest


def run(prepared: PreparedRecording, batch, candidates, courses, observation) -> Pinned:
    """The program on a batch; the last lane takes the requests that nobody made."""
    space = room(prepared)
    lanes = sum(space.values()) + 1
    lane = [*batch, *[batch[0]] * (lanes - len(batch))]
    first, chosen = ([candidates[number] for number in numbers] for numbers in (batch, lane))
    asked = tuple(
        requests(prepared, term, space[term], first, lanes - 1) for term in prepared.library
    )
    known, points = given(prepared, chosen), stacked([prepared.coordinates(one) for one in chosen])
    along, zero = stacked([courses[number] for number in lane]), np.array([c.zero for c in chosen])
    parts = zip(
        grouped(known.effect, GROUP, axis=2),
        grouped((points.own, along), GROUP, axis=1),
        grouped((prepared.course, observation, prepared.problem.known), GROUP),
        strict=True,
    )
    static = (prepared.library, prepared.problem.chain)
    steps, used = np.asarray(prepared.problem.steps), np.asarray(len(batch))
    found = []
    for effect, (own, course), around in parts:
        of_lanes = (asked, replace(known, effect=effect), replace(points, own=own), zero, course)
        arguments = (*of_lanes, *around, steps, used)
        found.append(called("exoid.mismatch.screen.pinned:evaluate", arguments, static, PINNED))
    return joined(found, prepared.segments)


def joined(parts: list[Pinned], count: int) -> Pinned:
    """What was found of the groups, of so many segments."""

    def all_of(axis: int):
        return lambda *leaves: np.take(np.concatenate(leaves, axis), np.arange(count), axis)

    return Pinned(
        all_of(1)(*(part.gram for part in parts)),
        jax.tree.map(all_of(1), *(part.course for part in parts)),
        jax.tree.map(all_of(2), *(part.first for part in parts)),
    )


def requests(
    prepared: PreparedRecording, term: type[Term], size: int, batch: list[Hypothesis], spare: int
) -> Requests:
    """Everything that a batch asks of a term; what it does not ask goes to a spare lane."""
    value = np.tile(prepared.starts(term)[0], (size, 1)).reshape(
        size, len(list(declarations(term)))
    )
    lanes, slots = np.full(size, spare), np.zeros(size, dtype=int)
    made = 0
    for lane, one in enumerate(batch):
        first = 0 if one.linear is None else 1
        for slot, (own, numbers) in enumerate(
            zip(one.asked, one.pinned[first:], strict=True), first
        ):
            if own is term:
                value[made], lanes[made], slots[made] = numbers, lane, slot
                made += 1
    return Requests(value, lanes, slots)


def given(prepared: PreparedRecording, lanes: list[Hypothesis]) -> Given:
    """The first terms that are linear, each once, and whose they are."""
    segments, size = prepared.seen.time.shape
    rows = (1 + MOST_PARAMETERS, segments)
    push = np.zeros((*rows, size - 1))
    effects = [Effect(Drive(push, push, push), np.zeros((*rows, size, 2)))]
    known: list[Linear] = []
    whose, change = np.zeros(len(lanes), int), np.zeros((len(lanes), MOST_PARAMETERS))
    for lane, one in enumerate(lanes):
        if one.linear is None:
            continue
        if not any(one.linear is other for other in known):
            known.append(one.linear)
            effects.append(one.linear.effect)
        whose[lane] = 1 + next(k for k, other in enumerate(known) if other is one.linear)
        moved = one.pinned[0] - one.linear.at
        change[lane, : moved.size] = moved
    effect = stacked(effects + [effects[0]] * (GIVEN - len(effects)))
    return Given(effect, whose, change)


def stacked(trees: list):
    return jax.tree.map(lambda *leaves: np.stack(leaves), *trees)


def placed(prepared: PreparedRecording, candidate: Hypothesis, gram: np.ndarray) -> Products:
    """The products over all unknowns of a candidate."""
    base = prepared.places.shape[1]
    rows = list(range(base + 2))
    for slot, value in enumerate(candidate.pinned):
        first = base + 2 + slot * MOST_PARAMETERS
        rows += range(first, first + value.size)
    return spread(candidate, prepared.places, prepared.usual, gram, [*rows, gram.shape[-1] - 1])
