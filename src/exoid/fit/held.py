"""What a model misses is not to be made up for by what recordings own.

A fit by least squares sees white noise only. Where something is missing, zero, seat or clock would
leave what is declared of them, to explain what they did not do: their misfit is less sure than it
looks. Each is therefore held to what is declared by as much more as the data tell less of it.
"""

import numpy as np

from exoid.fit.coordinates import TYPICAL, flattened, unflattened
from exoid.fit.problem import Problem, around, take
from exoid.fit.sandwich import Disturbance
from exoid.fit.seldom import widened
from exoid.fit.systematics import OWNED
from exoid.fit.task import Solved

Less = dict[str, np.ndarray]  # of every leaf of the mounting: how much wider, at least 1


def less_told(problem: Problem, at: Solved, row: int, found: Disturbance) -> Less:
    """By how much the errors of what recordings own are wider than white noise makes them.

    Each as all but its own declaration tells it.
    """
    local = around(problem, at, row=row)
    point = take(at.coordinates, row)
    places = unflattened(np.arange(flattened(point).size), point).mounting
    white, true = (total + local.prior for total in (local.data, found.information))
    return {
        name: np.array([widening(problem, white, true, name, *each) for each in enumerate(place)])
        for name, place in ((name, getattr(places, name)) for name in OWNED)
    }


def widening(
    problem: Problem, white: np.ndarray, true: np.ndarray, name: str, entry: int, place: int
) -> float:
    """Of one of them, from the information with noise only, and with what is missed."""
    deviation = getattr(problem.belief.prior.mounting, name)[entry]
    own = (getattr(TYPICAL.mounting, name) / deviation) ** 2
    told = [max(1 / inverse(total)[place, place] - own, 0.0) for total in (white, true)]
    return float(np.sqrt(max(told[0] / max(told[1], 1e-9 * told[0]), 1.0))) if told[0] else 1.0


def inverse(total: np.ndarray) -> np.ndarray:
    return np.linalg.inv(total + 1e-9 * np.diag(1 + np.diag(total)))


def held(problem: Problem, less: Less, scale: float = 1.0) -> Problem:
    """The problem in which they are held so, where residuals count 1 / `scale`."""
    mounting = problem.belief.prior.mounting
    assert mounting is not None  # `pose` gives one
    return widened(
        problem, **{name: getattr(mounting, name) * scale / less[name] for name in OWNED}
    )
