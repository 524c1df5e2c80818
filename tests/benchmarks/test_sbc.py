"""Ranks of true values among the draws of their posteriors, in few recordings."""

import numpy as np
import pytest
from benchmarks.sbc.ranks import DRAWS, Ranks, ranked

pytest.importorskip("blackjax")
RECORDINGS = 8


def test_even_ranks_are_uniform_and_crowded_ones_are_not():
    even = Ranks({"a": np.arange(200) * (DRAWS + 1) // 200})
    assert np.array_equal(even.histogram("a"), np.full(10, 20))
    assert even.surprise("a") == 1.0
    assert even.mean("a") == pytest.approx(0.0, abs=1e-9)
    low = Ranks({"a": np.arange(200) * (DRAWS + 1) // 300})
    assert low.surprise("a") < 1e-6
    assert low.mean("a") < -5


@pytest.mark.proof
def test_ranks_of_legs_that_the_prior_has_are_uniform():
    """`python -m benchmarks.sbc` ranks 300.

    Of eight quantities one leans by more than 4 in two thousand runs; a chi-square of nine degrees
    of freedom is below 1e-4 in one thousand.
    """
    found = ranked(RECORDINGS, seed=1)
    for name in found.ranks:
        assert abs(found.mean(name)) < 4, name
        assert found.surprise(name) > 1e-4, name
