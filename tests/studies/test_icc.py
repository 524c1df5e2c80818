"""Intraclass correlations against published tables and an independent implementation."""

import numpy as np
import pandas as pd
import pytest

from exoid.studies.statistics.icc import icc
from exoid.studies.statistics.tables.said import NotTold

# Shrout & Fleiss (1979), table 2: six targets, four judges.
JUDGES = np.array(
    [
        [9.0, 2.0, 5.0, 8.0],
        [6.0, 1.0, 3.0, 2.0],
        [8.0, 4.0, 6.0, 8.0],
        [7.0, 1.0, 2.0, 6.0],
        [10.0, 5.0, 6.0, 9.0],
        [6.0, 2.0, 4.0, 7.0],
    ]
)
PUBLISHED = 0.005  # half of the last digit of the published two


def test_the_correlations_are_those_of_shrout_and_fleiss():
    found = icc(JUDGES)
    assert found.one_way.value == pytest.approx(0.17, abs=PUBLISHED)
    assert found.agreement.value == pytest.approx(0.29, abs=PUBLISHED)
    assert found.consistency.value == pytest.approx(0.71, abs=PUBLISHED)
    assert found.of_mean == pytest.approx((0.44, 0.62, 0.91), abs=PUBLISHED)


@pytest.mark.filterwarnings("ignore:The inplace keyword")
@pytest.mark.parametrize("people", [5, 40])
def test_values_and_intervals_are_those_of_pingouin(people):
    pingouin = pytest.importorskip("pingouin")
    draw = np.random.default_rng(people)
    table = draw.normal(0, 1, (people, 1)) + draw.normal(0, 0.7, (people, 3)) + [0.0, 0.3, 0.5]
    long = pd.DataFrame(table).melt(ignore_index=False).reset_index()
    other = pingouin.intraclass_corr(long, targets="index", raters="variable", ratings="value")
    ours = icc(table)
    rows = zip((ours.one_way, ours.agreement, ours.consistency), other.to_numpy()[:3], strict=True)
    for mine, theirs in rows:
        assert mine.value == pytest.approx(theirs[1], abs=1e-9)  # the same sums, otherwise ordered
        # pingouin rounds its intervals to two digits.
        assert [mine.low, mine.high] == pytest.approx(list(theirs[-1]), abs=0.00501)


def test_the_error_of_measurement_holds_the_truth_as_often_as_it_says():
    draw, held = np.random.default_rng(0), 0
    for _ in range(400):
        table = draw.normal(0, 1, (12, 1)) + draw.normal(0, 0.5, (12, 2))
        sem = icc(table).sem
        held += sem.low <= 0.5 <= sem.high
    # 95 % of 400 with a standard deviation of 4.4; chi squared is exact here.
    assert held == pytest.approx(380, abs=3 * 4.4)


@pytest.mark.parametrize(
    ("table", "word"),
    [
        (np.ones((6, 2)), "vary"),
        (np.arange(12.0).reshape(6, 2), "vary"),  # a shift of all, and nothing else
        (np.ones((2, 2)), "few"),
        (np.ones((6, 1)), "few"),
        (np.array([[1.0, 2.0], [np.nan, 1.0], [3.0, 1.0]]), "complete"),
    ],
)
def test_a_table_that_tells_nothing_is_refused(table, word):
    with pytest.raises(NotTold, match=word):
        icc(table)
