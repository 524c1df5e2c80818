"""Many candidates at once through the compiled program that pins them to the data."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.solve.program_cache import called
from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Linear, Products
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.screen.pinned import LinearTerms, Pinned, Requests
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import grouped
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.motion.step import Drive
from exoid.physics.term import Term

GROUP = 2  # segments of a program, so that one serves every recording
GIVEN = 4  # first terms that candidates may have linear, the first of them none
Tried = tuple[Hypothesis, MeasuredMotion]  # a candidate, and the motion that it had last
ROWS, TABLE = np.zeros((1, 1, 1)), np.zeros((1, 1, 1, 1))
NONE = Effect(Drive(ROWS, ROWS, ROWS), ROWS)
PINNED = jax.tree.structure(Pinned(TABLE, MeasuredMotion(ROWS, ROWS, ROWS), NONE))


def evaluate(
    prepared: PreparedRecording, tried: Sequence[Tried], tether: float = 0.0
) -> list[tuple[Products, MeasuredMotion]]:
    """The products of every candidate, and the motion along which they are."""
    results = {}
    waiting = list(range(len(tried)))
    while waiting:
        batch, waiting = packed(prepared, waiting, [one for one, _ in tried])
        found = run(prepared, [tried[number] for number in batch], tether)
        for row, number in enumerate(batch):
            gram = placed(prepared, tried[number][0], found.gram[row])
            results[number] = (gram, row_of(found.motion, row))
    return [results[number] for number in range(len(tried))]


def linear(prepared: PreparedRecording, tried: Sequence[Tried]) -> list[Linear]:
    """What the terms of a few candidates do along their motions."""
    found = run(prepared, tried).first
    return [Linear(row_of(found, row), one.values[0]) for row, (one, _) in enumerate(tried)]


def row_of(tree, row: int):
    return jax.tree.map(lambda leaf: leaf[row], tree)


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
    most = sum(space.values())
    used: Counter[type[Term]] = Counter()
    batch, rest = [], []
    given: set[Linear] = set()
    for number in waiting:
        one = candidates[number]
        wanted = Counter(one.asked)
        needed = given | ({one.linear} if one.linear else set())
        fits = all(used[term] + n <= space[term] for term, n in wanted.items())
        if fits and len(batch) < most and len(needed) < GIVEN:
            used, given = used + wanted, needed
            batch.append(number)
        else:
            rest.append(number)
    return batch, rest


def run(prepared: PreparedRecording, batch: Sequence[Tried], tether: float = 0.0) -> Pinned:
    """The program on a batch; the last row takes the requests that nobody made."""
    space = room(prepared)
    spare = sum(space.values())
    candidates, motions = zip(*batch, *[batch[0]] * (spare + 1 - len(batch)), strict=True)
    asked = tuple(
        requests(prepared, term, space[term], candidates[: len(batch)], spare)
        for term in prepared.library
    )
    known = linear_terms(prepared, candidates)
    points, along = stacked(map(prepared.coordinates, candidates)), stacked(motions)
    zero = np.array([one.zero for one in candidates])
    around = (prepared.measured_motion, prepared.seen, prepared.problem.known)
    parts = zip(
        grouped(known.effect, GROUP, axis=2),
        grouped((points.own, along), GROUP, axis=1),
        grouped(around, GROUP),
        strict=True,
    )
    static = (prepared.library, prepared.problem.chain)
    numbers = prepared.problem.steps, len(batch), float(tether)

    def group(part) -> Pinned:
        effect, (own, motion), around = part
        rows = (asked, replace(known, effect=effect), replace(points, own=own), zero, motion)
        arguments = (*rows, *around, *map(np.asarray, numbers))
        return called("exoid.mismatch.screen.pinned:evaluate", arguments, static, PINNED)

    return joined(side_by_side(group, parts), prepared.segments)


def joined(parts: list[Pinned], count: int) -> Pinned:
    """What was found of the groups, of so many segments."""

    def all_of(axis: int):
        return lambda *leaves: np.take(np.concatenate(leaves, axis), np.arange(count), axis)

    return Pinned(
        all_of(1)(*(part.gram for part in parts)),
        jax.tree.map(all_of(1), *(part.motion for part in parts)),
        jax.tree.map(all_of(2), *(part.first for part in parts)),
    )


def requests(
    prepared: PreparedRecording,
    term: type[Term],
    size: int,
    batch: Sequence[Hypothesis],
    spare: int,
) -> Requests:
    """Everything that a batch asks of a term; what it does not ask goes to the `spare` row."""
    asked = [
        (value, row, slot)
        for row, one in enumerate(batch)
        for slot, (own, value) in one.slots
        if own is term
    ]
    asked += [(prepared.starts(term)[0], spare, 0)] * (size - len(asked))
    values, rows, slots = zip(*asked, strict=True)
    return Requests(np.array(values, float), np.array(rows), np.array(slots))


def linear_terms(prepared: PreparedRecording, rows: Sequence[Hypothesis]) -> LinearTerms:
    """The first terms that are linear, each once, and whose they are."""
    segments, size = prepared.seen.time.shape
    push = np.zeros((1 + MOST_PARAMETERS, segments, size - 1))
    nothing = Effect(Drive(push, push, push), np.zeros((*push.shape[:2], size, 2)))
    known = list(dict.fromkeys(one.linear for one in rows if one.linear))
    which, change = np.zeros(len(rows), int), np.zeros((len(rows), MOST_PARAMETERS))
    for row, one in enumerate(rows):
        if one.linear:
            which[row] = 1 + known.index(one.linear)
            moved = one.pinned[0] - one.linear.at
            change[row, : moved.size] = moved
    effects = [nothing, *(each.effect for each in known), *[nothing] * (GIVEN - 1 - len(known))]
    return LinearTerms(stacked(effects), which, change)


def stacked(trees: Iterable):
    return jax.tree.map(lambda *leaves: np.stack(leaves), *trees)


def placed(prepared: PreparedRecording, candidate: Hypothesis, gram: np.ndarray) -> Products:
    """The products over all unknowns of a candidate."""
    base = prepared.places.shape[1]
    rows = list(range(base + 2))
    for slot, value in enumerate(candidate.pinned):
        first = base + 2 + slot * MOST_PARAMETERS
        rows += range(first, first + value.size)
    return prepared.products(candidate, gram, [*rows, gram.shape[-1] - 1])
