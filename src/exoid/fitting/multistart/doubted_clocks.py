"""Encoder and gyro that disagree in scale: the gyro, the encoder's gain or the clock is off.

The width of the clock's prior follows the disagreement.
"""

from dataclasses import replace

import numpy as np

from exoid.fitting.misfit.condensed import Neighbourhood
from exoid.fitting.model.coordinates import TYPICAL
from exoid.fitting.model.term_parameters import parameters_of
from exoid.fitting.multistart.rare import place_of, places_of, undeclared, variances
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.recordings.signal.both_sensors.sensor_scales import DISAGREE, suspected

BEYOND = 2.0  # times it the gyro's own may be


def with_doubted_clocks(problem: Problem, best: Solved, local: Neighbourhood) -> Problem | None:
    """With wider priors for the clocks of recordings in which the sensors disagree in scale.

    Motion shows only (1 + gyro scale) / (1 + clock) over the encoder's gain, but m l g / J goes by
    the square of the clock. None where no sensors disagree.
    """
    if "clock" not in problem.owned:
        return None
    clock, scale = (problem.deviation_of(name).copy() for name in ("clock", "gyro_scale"))
    total = variances(local.data + local.prior)
    chosen = False
    for entry in undeclared(problem, "clock"):
        value, gradient = gyro_scale(problem, best, local, entry)
        wide = suspected(value)
        error = float(np.sqrt(gradient @ total @ gradient))
        if abs(value) > DISAGREE * error and wide > clock[entry]:
            clock[entry], chosen = wide, True
            if scale.size:
                scale[entry] = max(scale[entry], BEYOND * abs(value))
    return problem.widened(clock=clock, gyro_scale=scale) if chosen else None


def doubted(before: Problem, after: Problem, at: Solved) -> list[int]:
    """The coordinates of the clocks whose priors are wider `after` than `before`."""
    grown = after.deviation_of("clock") > before.deviation_of("clock")
    return places_of(at, "clock", np.flatnonzero(grown).tolist())


def not_by_anatomy(local: Neighbourhood, clocks: list[int]) -> Neighbourhood:
    """The same, where what is believed of the leg narrows none of these coordinates.

    The values are those of clocks as declared: what anatomy then asks of another clock, their
    errors are not to take for evidence of this one. With the clocks k all others y go by U k,
    U = -H_yy^-1 H_yk; what is believed is believed of y - U k, of which they are no part.
    """
    total = local.data + local.prior
    others = np.setdiff1d(np.arange(len(total)), clocks)
    own = np.ix_(others, np.array(clocks))
    left = np.eye(len(total))
    left[own] = variances(total[np.ix_(others, others)]) @ total[own]
    left[clocks, clocks] = 0.0
    believed = left.T @ (local.prior - local.declared) @ left
    return replace(local, prior=believed + local.declared)


def gyro_scale(
    problem: Problem, best: Solved, local: Neighbourhood, entry: int
) -> tuple[float, np.ndarray]:
    """By how much the gyro of a recording shows too much, and the gradient of that: as the
    recording owns it, or as a term in its place has it. Zeros where it is known.
    """
    gradient = np.zeros(len(local.data))
    if entry in problem.estimated("gyro_scale"):
        gradient[place_of(best, "gyro_scale", entry)] = TYPICAL.mounting.gyro_scale
        return float(best.coordinates.mounting.gyro_scale[0, entry]), gradient
    for term in problem.terms:
        if term.replaces == "gyro_scale":
            (name,) = (each for each, _ in parameters_of((term,)))
            row = problem.quantities.index(name)
            return float(best.quantities[0, row]), local.quantities[row]
    return 0.0, gradient
