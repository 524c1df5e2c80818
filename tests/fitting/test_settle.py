"""Where a search under prior and limits begins."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.model.coordinates import take
from exoid.fitting.model.prior import belief_residual
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.movements import movements_of
from exoid.fitting.multistart.beginning.starts import coordinates
from exoid.fitting.multistart.settle import as_believed
from exoid.fitting.solve.pose import pose
from fit_cases import BODY, DROP, recorded

LEG = (4.5, 0.42, 0.26, 0.33, 2.6, 0.0)  # m, J, l, d, c, tau
HEAVIER = (9.0, 0.84, 0.26, 0.66, 5.2, 0.0)  # of the same motion


def posed(*legs):
    movements = movements_of([("drop", recorded(DROP))])
    problem = pose(movements, believe(BODY), "1/T", Raw())
    return problem, coordinates(np.array(legs), movements)


def test_what_is_believed_most_is_the_same_from_anywhere_and_nothing_near_is_believed_more():
    problem, legs = posed(LEG, HEAVIER)
    point = take(legs, 0)
    begins = ((legs.shared.log_inertia[row], legs.log_mass[row]) for row in (0, 1))
    one, other = (as_believed(problem, point, *map(float, each)) for each in begins)
    assert one == pytest.approx(other, abs=1e-3)  # of a typical step: no nearer

    def doubt(inertia, mass):
        shared = replace(point.shared, log_inertia=inertia)
        away = replace(point, shared=shared, log_mass=mass)
        return np.sum(belief_residual(problem.belief.prior, away, np) ** 2)

    least = doubt(*one)
    for away in ((0.02, 0.0), (-0.02, 0.0), (0.0, 0.02), (0.0, -0.02)):
        assert doubt(*(one + away)) > least
