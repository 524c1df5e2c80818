"""How well what is declared of the recordings is known, as a problem has it."""

from dataclasses import replace

import numpy as np

from exoid.fitting.solve.problem import Problem


def deviation_of(problem: Problem, name: str) -> np.ndarray:
    """The standard deviations of all recordings."""
    return np.asarray(getattr(problem.belief.prior.mounting, name))


def widened(problem: Problem, **deviations: np.ndarray) -> Problem:
    """The same with these standard deviations of what recordings own."""
    prior = problem.belief.prior
    assert prior.mounting is not None  # `pose` gives one
    mounting = replace(prior.mounting, **deviations)
    return replace(problem, belief=replace(problem.belief, prior=replace(prior, mounting=mounting)))
