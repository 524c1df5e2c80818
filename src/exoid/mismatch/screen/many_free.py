"""Candidates running free, through the compiled program of their terms."""

from dataclasses import replace
from functools import partial

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.data.pace import parts_of
from exoid.fitting.solve.program_cache import called
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Products
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import of, of_all_segments, summed
from exoid.physics.term import busy

GROUP = 4  # segments of a program, so that one serves every recording
LEAST = 1024  # samples of it, or twice as many, and so on
HERE = "exoid.mismatch.screen.free_run"
TABLE = np.zeros((1, 1, 1))
RELEASED, GRAM = jax.tree.structure((TABLE, TABLE)), jax.tree.structure(TABLE)


def release(
    prepared: PreparedRecording, candidate: Hypothesis, observation: Observation | None = None
) -> tuple[Products, np.ndarray]:
    """The products of a candidate, and what it shows: (segment, time, channel)."""
    observation = prepared.seen if observation is None else observation
    size = observation.time.shape[1]

    def group(given, segments: np.ndarray):
        arguments, static = given(segments)
        return called(f"{HERE}:release", arguments, static, RELEASED)

    given = partial(of_group, prepared, candidate, prolonged(observation, size))
    ((gram, shown),) = of_all_segments(group, [given], prepared.segments, together(candidate))
    return prepared.products(candidate, gram), shown[:, :size]


def respond(prepared: PreparedRecording, candidate: Hypothesis, beside: Effect) -> np.ndarray:
    """(J, n, r)'(J, n, r) of a candidate, over all its unknowns, over what may act or be shown
    `beside` its terms: (column, segment, time), and the residual.
    """
    seen = prolonged(prepared.seen, prepared.seen.time.shape[1])
    room = seen.time.shape[1] - beside.shown.shape[2]

    def longer(leaf: np.ndarray) -> np.ndarray:
        return np.pad(leaf, [(0, 0), (0, 0), (0, room), *[(0, 0)] * (leaf.ndim - 3)])

    beside = jax.tree.map(longer, beside)

    def group(given, segments: np.ndarray):
        arguments, static = given(segments)
        return called(f"{HERE}:respond", (*arguments, of(segments, beside, 1)), static, GRAM)

    given = partial(of_group, prepared, candidate, seen)
    (grams,) = of_all_segments(group, [given], prepared.segments, together(candidate))
    return summed(grams, prepared.places, candidate.point.size)


def of_group(
    prepared: PreparedRecording, candidate: Hypothesis, seen: Observation, segments: np.ndarray
) -> tuple[tuple, tuple]:
    """The arguments of these segments' program, and what is a part of it."""
    at = prepared.coordinates(candidate)
    point = replace(at, own=of(segments, at.own))
    seen = replace(seen, parts=parts_of(prepared.problem.movements, candidate.terms))
    own, known = of(segments, (seen, prepared.problem.known))
    arguments = (candidate.values, point, candidate.zero, own, known, np.asarray(last_of(own)))
    return arguments, (candidate.terms, prepared.problem.chain)


def together(candidate: Hypothesis) -> int:
    """How many segments of it a program runs at once."""
    return 1 if any(map(busy, candidate.terms)) else GROUP


def last_of(observation: Observation) -> int:
    """The last sample that weighs anything: no simulation goes on behind it."""
    weight = np.asarray(observation.angle_weight) + np.asarray(observation.velocity_weight)
    return int(np.flatnonzero(weight.any(axis=0)).max(initial=1))


def prolonged(observation: Observation, size: int) -> Observation:
    """With samples that weigh nothing up to the size of the program, the clock going on."""
    room = LEAST
    while room < size:
        room *= 2
    more = room - size
    longer = jax.tree.map(
        lambda leaf: np.pad(leaf, ((0, 0), (0, more))) if leaf.ndim == 2 else leaf, observation
    )
    last, step = observation.time[:, -1:], np.diff(observation.time[:, -2:])
    time = np.concatenate([observation.time, last + step * np.arange(1, more + 1)], axis=1)
    return replace(longer, time=time)
