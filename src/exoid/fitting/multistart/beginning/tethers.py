"""How a start is brought to the data: tied to the measured motion at first, then ever less."""

from dataclasses import replace

import numpy as np

from exoid.fitting.data.pace import quickest
from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.solve.ask import ROUNDS, advance, task
from exoid.fitting.solve.problem import Problem

TETHERS = (60.0, 15.0)  # rad/s, of the first stage and the second; then free
QUICKER = 2.0  # times the pace of a recording that is quicker than a leg: its first tether
SPRING = 0.5  # greatest frequency of a start's own spring, over its tether's
STIFF = 0.6  # greatest tether times step: Runge-Kutta carries it with room for the leg
COARSE, FINE = 10.0, 1e-2  # tolerances, in units of noise
LOOKING = np.inf  # tolerance of a solver that is not to leave its point


def tethers(problem: Problem) -> tuple[float, float]:
    """Of both stages, as far as the sampling allows."""
    pace = quickest(problem.movements)
    first = min(max(TETHERS[0], QUICKER * pace), STIFF / problem.longest_step)
    return first, min(max(TETHERS[1], first / 4), first / 2)


def within_reach(starts: Coordinates, tether: float, step: float) -> Coordinates:
    """The same, damping and springs no stronger than a tether [rad/s] can lead to the data.

    d/J beyond what the time step [s] carries beside it would run away, and c/J of a spring that
    alone swings at more than half its frequency would hold the leg off the measured motion.
    """
    shared = starts.shared
    damping = np.minimum(shared.damping, 2 / step - 2 * tether)
    stiffness = np.minimum(shared.stiffness, (SPRING * tether) ** 2)
    return replace(starts, shared=replace(shared, damping=damping, stiffness=stiffness))


def led(
    problem: Problem, starts: Coordinates, scale: np.ndarray | float = 1.0, rounds: int = ROUNDS
) -> Coordinates:
    """Where these starts come to, tied to the measured motion and then less, over all of it."""
    for tether in tethers(problem):
        asked = task(problem, tether, problem.steps, COARSE, rounds=rounds)
        starts = without_thrust(advance(problem, starts, asked, scale).coordinates)
    return starts


def without_thrust(at: Coordinates) -> Coordinates:
    """No negative damping: it would run away once the tether that held it is loosened."""
    damped = replace(at.shared, damping=np.maximum(at.shared.damping, 0.0))
    return replace(at, shared=damped)
