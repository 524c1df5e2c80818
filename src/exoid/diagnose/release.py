"""Candidates running free, through the compiled program of their terms."""

import jax
import numpy as np

from exoid.diagnose.bench import Bench
from exoid.diagnose.hypothesis import Hypothesis, Products, spread
from exoid.fit.observation import Observation
from exoid.fit.program import called

TABLE = np.zeros((1, 1, 1))
RELEASED = jax.tree.structure((TABLE, TABLE))


def release(
    bench: Bench, candidates: list[Hypothesis], observation: Observation
) -> list[tuple[Products, np.ndarray]]:
    """The products of candidates, one after the other, and what each shows: (segment, time,
    channel).
    """
    return [release_one(bench, each, observation) for each in candidates]


def release_one(
    bench: Bench, candidate: Hypothesis, observation: Observation
) -> tuple[Products, np.ndarray]:
    arguments = (
        candidate.values,
        bench.with_spare(bench.coordinates(candidate), axis=0),
        candidate.zero,
        *bench.surroundings(observation),
    )
    static = (candidate.terms, bench.problem.chain)
    gram, shown = called("exoid.diagnose.free:release", arguments, static, RELEASED)
    found = spread(candidate, bench.places, gram, list(range(gram.shape[-1])))
    return found, shown[: bench.segments]
