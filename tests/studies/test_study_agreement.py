"""Pairs against Bland and Altman's published example, and against what pairs are made of."""

import numpy as np
import pandas as pd
import pytest

from exoid.studies.statistics.agreement import agreement
from exoid.studies.statistics.pairs import Pairs, pairs_of
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import Values, with_people

# Bland & Altman (1986), table 1: peak flow of 17 people by a large and by a mini meter, l/min.
LARGE = [494, 395, 516, 434, 476, 557, 413, 442, 650, 433, 417, 656, 267, 478, 178, 423, 427]
MINI = [512, 430, 520, 428, 500, 600, 364, 380, 658, 445, 432, 626, 260, 477, 259, 350, 451]
# They take 2 standard deviations where 1.96 are meant, and 3 s^2 / n for the variance of a limit.
ROUNDED = 2.6


def pairs(first, second, error=np.nan):
    columns = {"first": first, "second": second, "first_error": error, "second_error": error}
    frame = pd.DataFrame(columns, index=[f"p{at:02d}" for at in range(len(first))]).astype(float)
    return Pairs("flow", "l/min", "mini", "large", frame.rename_axis("person"))


def test_bias_and_limits_are_those_that_bland_and_altman_published():
    found = agreement(pairs(MINI, LARGE))
    assert found.bias.value == pytest.approx(-2.1, abs=0.05)
    assert found.deviation == pytest.approx(38.8, abs=0.05)
    assert (found.bias.low, found.bias.high) == pytest.approx((-22.0, 17.8), abs=0.1)
    assert (found.lower.value, found.upper.value) == pytest.approx((-79.7, 75.5), abs=ROUNDED)
    assert (found.lower.low, found.lower.high) == pytest.approx((-114.3, -45.1), abs=ROUNDED)
    assert (found.upper.low, found.upper.high) == pytest.approx((40.9, 110.1), abs=ROUNDED)


def test_with_equal_errors_or_none_the_mean_difference_is_that_of_a_paired_t_test():
    from scipy.stats import ttest_rel

    other = ttest_rel(LARGE, MINI)
    for error in (np.nan, 5.0):
        found = agreement(pairs(MINI, LARGE, error))
        # The search for the variance stops 1e-5 off.
        assert found.p == pytest.approx(float(other.pvalue), rel=1e-3)
        assert found.difference.low == pytest.approx(found.bias.low, rel=1e-3)


def test_an_error_of_zero_is_none_and_weighs_no_more_than_another():
    """As of a count, which noise does not change."""
    rows = pd.DataFrame(
        {
            "recording": ["a", "b"],
            "participant": ["p1", "p2"],
            "session": "",
            "side": "",
            "value": [4.0, 5.0],
            "standard_error": [0.0, 0.5],
        }
    )
    found = with_people(rows, pd.DataFrame({"recording": ["a", "b"]}))
    assert found["error"].tolist() == pytest.approx([np.nan, 0.5], nan_ok=True)


def test_the_errors_of_the_estimates_are_told_as_their_share():
    found = agreement(pairs(MINI, LARGE, 10.0))
    assert found.by_error == pytest.approx(2 * 10.0**2 / found.deviation**2)
    assert agreement(pairs(MINI, LARGE)).by_error is None


def test_a_bias_that_grows_with_the_size_is_found_and_no_other():
    draw = np.random.default_rng(0)
    size = draw.uniform(1, 5, 40)
    grown = agreement(pairs(size, 1.2 * size + draw.normal(0, 0.05, 40)))
    # 0.2 x over a mean of 1.1 x; noise and its correlation with the mean leave 0.01.
    assert grown.slope.value == pytest.approx(0.2 / 1.1, abs=0.02)
    assert grown.slope_p < 1e-6
    assert agreement(pairs(size, size + draw.normal(0, 0.05, 40))).slope_p > 0.05


def test_limits_hold_the_truth_as_often_as_they_say():
    draw, held = np.random.default_rng(1), np.zeros(2)
    for _ in range(150):
        found = agreement(pairs(np.zeros(30), draw.normal(0.5, 1.0, 30)))
        held += [
            found.upper.low <= 0.5 + 1.96 <= found.upper.high,
            found.difference.low <= 0.5 <= found.difference.high,
        ]
    # 95 % of 150 with a standard deviation of 2.7; the limits' intervals are an approximation.
    assert held == pytest.approx([142, 142], abs=3.5 * 2.7)


def test_sides_are_paired_on_days_that_have_both():
    sides = {"left": 1.0, "right": 2.0}
    rows = [(f"p{at}", side, "a", sides[side] + at, 0.1) for at in range(4) for side in sides]
    rows.append(("p0", "left", "b", 50.0, 0.1))  # without a right one
    frame = pd.DataFrame(rows, columns=["person", "side", "session", "value", "error"])
    found = pairs_of(Values("q", "1", frame), "side", "left", "right")
    assert found.difference.tolist() == [1.0] * 4
    assert found.frame["first"].tolist() == [1.0, 2.0, 3.0, 4.0]
    assert found.error.tolist() == pytest.approx([0.1 * 2**0.5] * 4)
    with pytest.raises(NotTold, match="by the same in all"):
        agreement(found)
    with pytest.raises(NotTold, match="'z'"):
        pairs_of(Values("q", "1", frame), "session", "a", "z")
    with pytest.raises(NotTold, match="1 person has both"):
        pairs_of(Values("q", "1", frame), "session", "a", "b")
