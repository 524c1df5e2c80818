"""Candidates running free, through the compiled program of their terms."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.program_cache import called
from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.screen.hypothesis import Hypothesis, Products
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.segment_groups import grouped

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
    every = (at.own, prolonged(observation, size), prepared.problem.known)
    static, steps = (candidate.terms, prepared.problem.chain), np.asarray(prepared.problem.steps)

    def group(part):
        own, *surroundings = part
        point = replace(at, own=own)
        arguments = (candidate.values, point, candidate.zero, *surroundings, steps)
        return called("exoid.mismatch.screen.free_run:release", arguments, static, RELEASED)

    found = side_by_side(group, grouped(every, GROUP))
    gram, shown = (np.concatenate(each)[: prepared.segments] for each in zip(*found, strict=True))
    return prepared.products(candidate, gram), shown[:, :size]


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
