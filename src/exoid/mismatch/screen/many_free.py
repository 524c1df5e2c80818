"""Candidates running free, through the compiled program of their terms."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.program_cache import called
from exoid.mismatch.screen.hypothesis import Hypothesis, Products
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import of, of_all_segments
from exoid.physics.term import busy

GROUP = 4  # segments of a program, so that one serves every recording
LEAST = 1024  # samples of it, or twice as many, and so on
TABLE = np.zeros((1, 1, 1))
RELEASED = jax.tree.structure((TABLE, TABLE))


def release(
    prepared: PreparedRecording, candidate: Hypothesis, observation: Observation | None = None
) -> tuple[Products, np.ndarray]:
    """The products of a candidate, and what it shows: (segment, time, channel)."""
    observation = prepared.seen if observation is None else observation
    size = observation.time.shape[1]
    at = prepared.coordinates(candidate)
    whole = (prolonged(observation, size), prepared.problem.known)
    static = (candidate.terms, prepared.problem.chain)
    together = 1 if any(map(busy, candidate.terms)) else GROUP

    def group(values, segments: np.ndarray):
        point = replace(at, own=of(segments, at.own))
        seen, known = of(segments, whole)
        arguments = (values, point, candidate.zero, seen, known, np.asarray(last_of(seen)))
        return called("exoid.mismatch.screen.free_run:release", arguments, static, RELEASED)

    ((gram, shown),) = of_all_segments(group, [candidate.values], prepared.segments, together)
    return prepared.products(candidate, gram), shown[:, :size]


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
