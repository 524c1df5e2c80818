"""Who takes part in the speed benchmark: how each is run, and how well what it found fits."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from problem import Problem, write
from rival_kernels import compiled_residuals, flatten
from rivals import Fits, slsqp_numba, slsqp_numpy, success_rate, trf_numba

LEG = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


@dataclass(frozen=True)
class Contestant:
    """`run` fits from starts, the part that is timed; `judge` gives best cost and share at it."""

    name: str
    run: Callable[[np.ndarray], Any]
    judge: Callable[[Any], tuple[float, float]]
    warms_up: bool = True


def exoid_contestant(problem: Problem, table: Path) -> Contestant:
    """exoid's `fit` of the recording that it reads from `table`."""
    from exoid.fitting.estimate import fit
    from exoid.recordings.loading.load import load

    write(problem, table)
    recording = load(table).recording

    def judge(result) -> tuple[float, float]:
        share = result.multistart.at_best / result.multistart.starts
        return full_cost(problem, ratios_of(result)), share

    return Contestant("exoid", lambda begin: fit(recording, starts=begin), judge)


def rival_contestants(problem: Problem, mapper: Callable) -> list[Contestant]:
    """SLSQP in NumPy, SLSQP in numba, trust region, and that again over `mapper`'s processes."""

    def judge(found: Fits) -> tuple[float, float]:
        best = float(found.cost.min())
        return best, success_rate(found, best)

    return [
        Contestant("SLSQP, NumPy", partial(slsqp_numpy, problem), judge, warms_up=False),
        Contestant("SLSQP, numba", partial(slsqp_numba, problem), judge),
        Contestant("TRF, numba", partial(trf_numba, problem), judge),
        Contestant("TRF, 2 processes", partial(trf_numba, problem, mapper=mapper), judge),
    ]


def ratios_of(result) -> np.ndarray:
    """m l g / J, c / J, d / J, then tau / J of each cycle, of exoid's result."""
    inertia = result.parameters["inertia"].value
    torques = [each.torque_amplitude for each in result.segments if each.torque_amplitude]
    leg = [result.ratios[name].value for name in LEG]
    return np.array([*leg, *(each.value / inertia for each in torques)])


def full_cost(problem: Problem, ratios: np.ndarray) -> float:
    """The rivals' misfit of these ratios on all samples, with the initial states that suit them.

    exoid fits from the first sample above 20 deg/s, so it knows no state at a segment's start.
    """
    data = flatten(problem)
    states = np.array([[s.angle[0], s.angular_velocity[0]] for s in problem]).ravel()
    return float(
        least_squares(
            lambda x: compiled_residuals(np.concatenate([ratios, x]), data), states, x_scale="jac"
        ).cost
    )
