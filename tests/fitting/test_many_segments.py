"""A fit of many segments ends: no program waits for threads on which others wait."""

import numpy as np
import pytest

import exoid
from legs import ADULT, drop, recording

MANY = 50  # whose matrices XLA multiplies, and jaxlib would factorise, on the same few threads


@pytest.mark.slow
def test_fifty_drops_are_fitted_together():
    drops = [drop(duration=3.0, seed=seed) for seed in range(MANY)]
    fit = exoid.fit(recording(*drops), multistart=8)
    found = fit.ratios["gravity_over_inertia"]
    # 15 000 samples: its error is below a thousandth.
    assert found.value == pytest.approx(ADULT[0], rel=2e-3)
    assert np.isfinite(found.standard_error)
