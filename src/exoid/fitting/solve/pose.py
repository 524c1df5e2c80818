"""From movements and what is believed to the problem of a fit."""

from dataclasses import replace

import numpy as np

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.observe import observe
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.systematics import OWNED, deviations, exact
from exoid.fitting.solve.problem import Problem


def pose(
    movements: list[Movement],
    belief: Belief,
    reading: str,
    chain: Chain,
    *,
    owned: tuple[str, ...] = OWNED,
) -> Problem:
    """The problem of fitting one leg to these movements; of what recordings own, `owned` are
    unknowns.
    """
    observation = observe(movements, reading)
    own = 4 + len(owned)
    known = np.zeros((len(movements), own + 3))
    known[:, 0] = [not each.scaled for each in movements]
    known[:, 4:own] = exact(movements, owned)
    known[:, own] = [not each.voluntary for each in movements]
    if belief.raw:
        known[:, 4:own] = 1.0  # Eq. 11 as printed knows nothing of them
    prior = replace(belief.prior, mounting=deviations(movements, owned))
    belief = replace(belief, prior=prior)
    return Problem(movements, observation, known, belief, chain, owned)
