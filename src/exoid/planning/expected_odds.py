"""How badly one model could follow the recording that another one would make.

The rival bends as far as what it knows allows. To first order in all that it may change, what is
left is chi2 = r'r - r'J (J'J + P)^-1 J'r, r being the difference of the two motions in units of
noise, J the rival's sensitivities and P its information (Box & Hill, Technometrics 9(1), 1967).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import log, sqrt

import jax
import numpy as np
from jaxtyping import Float
from scipy.optimize import lsq_linear
from scipy.stats import norm

from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.condensed import Sensed
from exoid.fitting.misfit.uncertainty import VAGUE
from exoid.fitting.model.coordinates import flattened, scaled
from exoid.fitting.model.term_parameters import over_inertia
from exoid.fitting.solve.ask import sensed
from exoid.planning.expected_information import posed, without_own
from exoid.planning.next_mountings import with_recordings
from exoid.planning.planned import Candidate
from exoid.planning.prior_knowledge import PriorKnowledge

DECISIVE = log(20.0)  # log odds at which one of two is believed
BY_A_HAIR = 1e-9  # of a step of order one: how far a fixed value may move


@dataclass(frozen=True, eq=False)
class RivalFit:
    """The fit of one model to what another one would make of the candidates."""

    rival: PriorKnowledge
    told: dict[Candidate, np.ndarray]  # by each, of leg and terms, of the misfit, of a mounting

    @cached_property
    def start(self) -> np.ndarray:
        """What the rival believes before; the misfit comes behind the coordinates."""
        known = self.rival.prior
        return np.pad(known + VAGUE * np.eye(len(known)), (0, 1))

    @cached_property
    def room(self) -> Float[np.ndarray, "2 known"]:
        """How far down and up every coordinate may go."""
        return steps_to_limits(self.rival)

    def log_odds(self, chosen: Sequence[Candidate]) -> float:
        """To expect against the rival, where it is wrong, of these candidates."""
        total = with_recordings(self.start, self.rival, self.told, chosen)
        normal, slope = total[:-1, :-1], total[:-1, -1]
        factor = np.linalg.cholesky(normal)
        aim = np.linalg.solve(factor, -slope)
        missed = lsq_linear(factor.T, aim, tuple(self.room)).cost * 2 - aim @ aim
        return max(0.0, float(total[-1, -1] + missed)) / 2


def rival_fit(
    rival: PriorKnowledge, made: dict[Candidate, Movement], own: Sensed, noise: float
) -> RivalFit:
    """What the rival has to change for motions that another model made, whose `own` simulation of
    them is known; `noise` is over the declared one.
    """
    found = sensed(*posed(rival, made))
    difference = np.asarray(found.residual) - np.asarray(own.residual)
    rows = np.concatenate([found.columns, difference[:, None]], axis=1)
    flat = rows.reshape(*rows.shape[:2], -1) / noise
    told = [without_own(each @ each.T, rival) for each in flat]
    return RivalFit(rival, dict(zip(made, told, strict=True)))


def steps_to_limits(known: PriorKnowledge) -> Float[np.ndarray, "2 known"]:
    """From the point that is known to the limits, in steps of order one."""
    at, limits = known.point, known.belief.limits
    inertia = np.exp(known.shared.log_inertia)

    def place(leg, terms, far: float) -> np.ndarray:
        with np.errstate(divide="ignore"):
            log_inertia = np.log(np.maximum(leg.inertia, 0.0))  # a rig has no limits
        shared = replace(
            at.shared,
            log_inertia=log_inertia,
            gravity=np.asarray(far),
            stiffness=leg.stiffness / inertia,
            damping=leg.damping / inertia,
        )
        own = tuple(over_inertia(term, inertia) for term in terms)
        there = replace(at, shared=shared, log_mass=np.asarray(far), terms=own)
        return flattened(jax.tree.map(np.asarray, scaled(there))) - flattened(scaled(at))

    lower = place(limits.lower, limits.lower_terms, -np.inf)
    upper = place(limits.upper, limits.upper_terms, np.inf)
    return np.stack([np.minimum(lower, 0.0) - BY_A_HAIR, np.maximum(upper, 0.0) + BY_A_HAIR])


def probability(log_odds: float) -> float:
    """That the odds reach 20 to 1: their logarithm is normal, its variance twice its mean."""
    if log_odds == 0:
        return 0.0
    return float(norm.cdf((log_odds - DECISIVE) / sqrt(2 * log_odds)))
