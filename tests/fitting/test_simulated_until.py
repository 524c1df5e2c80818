"""A simulation ends with the last sample that counts: what comes after it is no motion."""

from unittest.mock import Mock

import numpy as np

from exoid.fitting.result.agreement import simulated
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.problem import Problem
from exoid.interchange.model.gather import reach


def test_samples_that_were_not_simulated_are_no_angle():
    problem = Mock(spec=Problem, steps=3)
    problem.own_rows = lambda number: np.array([0, 2, 3, 5])  # one lies between its samples
    table = np.arange(12.0).reshape(1, 2, 6)
    np.testing.assert_equal(simulated(problem, table, 1), [6.0, 8.0, 9.0, np.nan])


def test_where_a_leg_has_been_is_where_it_was_simulated():
    fit = Mock(spec=FitResult)
    fit.segments = [
        Mock(simulated_angle=np.array(each)) for each in ([-0.3, -2.0, np.nan], [-0.5, -1.0])
    ]
    assert reach(fit) == (-2.0, -0.3)
