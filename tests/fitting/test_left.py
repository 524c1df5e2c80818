"""What is left of the information that data carry."""

import numpy as np

from exoid.fitting.estimate import fit
from exoid.fitting.solve.ask import grams_at, left, left_by
from fit_cases import DROP, LOADED, recorded


def test_where_nothing_disturbs_the_information_is_that_of_all_samples():
    """It is taken from what the search knows: the same products, there condensed on the way."""
    basis = fit(recorded(DROP, LOADED), multistart=4).basis
    assert basis is not None
    problem, best, found = basis.problem, basis.ended.best, basis.ended.disturbance
    assert found.cause is None
    each = left_by(grams_at(problem, best), problem, best, 0, found)
    brief = left(problem, best, 0, found)
    scale = np.sqrt(np.outer(*[np.diag(each.information) + 1e-12] * 2))
    # Normal equations keep half of the digits of what is nearly parallel, and these are not.
    assert np.abs((brief.information - each.information) / scale).max() < 1e-8
    np.testing.assert_allclose(brief.widening, each.widening, rtol=1e-8)
