"""What zero of a torque's sensor a residual shows, told beside all that a fit takes for it."""

import numpy as np
import pytest

from exoid.fitting.result.estimates.moved import shown, variance_left

RANDOM = np.random.default_rng(4)
SAMPLES, UNKNOWNS = 60, 3


@pytest.mark.parametrize("ended", [0.0, 1e-3, 0.5])
@pytest.mark.parametrize("alike", [0.0, 1.0])
def test_it_is_that_of_joint_least_squares_wherever_the_search_ended(ended, alike):
    """Beside a constant torque, which the fit takes a zero for, the little that a search had not
    come to its end by made it 40,000 times as large as it can be.
    """
    rows, own = RANDOM.normal(size=(SAMPLES, UNKNOWNS)), RANDOM.normal(size=SAMPLES)
    response = 1e4 * rows[:, 0] if alike else own
    missed = RANDOM.normal(size=SAMPLES)
    best = np.linalg.lstsq(rows, missed)[0]
    residual = missed - rows @ (best + ended * np.array([1.0, -1.0, 0.5]))
    prior = np.diag([0.0] * UNKNOWNS + [1.0])  # of the zero, by its own deviation
    both = np.column_stack([rows, response])
    joint = np.linalg.solve(both.T @ both + prior, -both.T @ residual)
    crossed = (rows.T @ response)[None]
    moved = np.linalg.solve(rows.T @ rows, crossed.T)
    told = variance_left(crossed, moved, np.array([response @ response]))
    each = shown(told, moved, np.array([response @ residual]), rows.T @ residual)
    assert -each[0] == pytest.approx(joint[-1], abs=1e-3)
    assert abs(each[0]) < 1.0
