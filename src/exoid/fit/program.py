"""Runs the compiled program."""

import jax
import numpy as np

from exoid.fit.solve import Solved, solve


def run(starts, observation, known, prior, limits, task, chain) -> Solved:
    """`solve`, with NumPy arrays in and out."""
    return jax.tree.map(np.asarray, solve(starts, observation, known, prior, limits, task, chain))
