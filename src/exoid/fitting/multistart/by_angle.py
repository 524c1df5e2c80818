"""What a model misses of the angle alone: where the gyro shows another motion, a slow error of the
encoder stands for that, and hides what else the model lacks.
"""

from dataclasses import replace

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.multistart.beginning.tethers import FINE
from exoid.fitting.multistart.weight_by_kind import explained
from exoid.fitting.solve.ask import advance, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved


def missed_by_angle(problem: Problem, best: Solved, found: Disturbance) -> Disturbance | None:
    """What is in the residual of the free fit near the `best` to the angles of all segments; None
    where no gyro was, or what was `found` in that to both is no error of the encoder.
    """
    seen = problem.observation
    if found.cause != "encoder" or not seen.velocity_weight.any():
        return None
    unseen = replace(seen, velocity_weight=np.zeros_like(seen.velocity_weight))
    alone = replace(problem, observation=unseen)
    return explained(alone, advance(alone, best.coordinates, task(alone, 0.0, alone.steps, FINE)))
