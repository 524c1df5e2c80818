"""Where the truth ranks among the draws, and whether ranks are uniform."""

from contextlib import suppress
from dataclasses import dataclass

import jax
import numpy as np
from scipy.stats import chi2

from exoid.fitting.errors.posterior import sample
from exoid.fitting.estimate import fit
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.recordings.motion.extent import Motionless

from .people import dropped, person

DRAWS = 99  # kept of each posterior: ranks 0 to 99
THIN = 6  # draws apart, nearly independent
CHAINS, WARMUP = 2, 100
BINS = 10


@dataclass(frozen=True)
class Ranks:
    """Of every quantity: how many of the kept draws lie below the truth, per recording."""

    ranks: dict[str, np.ndarray]

    def histogram(self, name: str) -> np.ndarray:
        """How many recordings fall into each of `BINS` equal parts of the ranks."""
        return np.bincount(self.ranks[name] * BINS // (DRAWS + 1), minlength=BINS)

    def surprise(self, name: str) -> float:
        """How often uniform ranks give a chi-square as large."""
        found = self.histogram(name)
        expected = found.sum() / BINS
        return float(chi2.sf(np.sum((found - expected) ** 2 / expected), BINS - 1))

    def mean(self, name: str) -> float:
        """Of the ranks over the greatest, in standard errors from one half."""
        part = (self.ranks[name] + 0.5) / (DRAWS + 1)
        return float((part.mean() - 0.5) * np.sqrt(12 * part.size))


def ranked(recordings: int, seed: int) -> Ranks:
    """Of so many legs, each drawn, dropped, fitted and sampled.

    A leg that is too stiff or too damped to move is refused. The posterior of the others is the
    same without it: what was seen decides, not the truth behind it.
    """
    each = []
    for number in range(recordings):
        with suppress(Motionless):
            each.append(rank_one(np.random.default_rng((seed, number))))
    return Ranks({name: np.array([one[name] for one in each]) for name in each[0]})


def rank_one(rng: np.random.Generator) -> dict[str, int]:
    """The ranks of one leg."""
    leg = person(rng)
    result = fit(dropped(leg, rng), multistart=2, seed=0)
    draws = -(-DRAWS * THIN // CHAINS)
    seed = int(rng.integers(2**31))
    drawn = sample(result, draws=draws, warmup=WARMUP, chains=CHAINS, seed=seed)
    truth = quantities(leg)
    return {
        name: int(np.sum(drawn.samples[name].ravel()[::THIN][:DRAWS] < value))
        for name, value in truth.items()
    }


def quantities(leg: LegParameters) -> dict[str, float]:
    """Parameters and ratios."""
    names = ("mass", "inertia", "com_distance", "damping", "stiffness")
    values = dict(zip(names, map(float, jax.tree.leaves(leg)), strict=True))
    weight = values["mass"] * values["com_distance"] * GRAVITY
    return values | {
        "gravity_over_inertia": weight / values["inertia"],
        "stiffness_over_inertia": values["stiffness"] / values["inertia"],
        "damping_over_inertia": values["damping"] / values["inertia"],
    }
