"""The hierarchical model: nearer to the truth than the mean of a leg's own drops."""

import numpy as np
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.shrunk import shrunk
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import values_of

# Drops that scatter half as much as people do, some badly recorded.
NOISY = Truth(between=0.1, side=0.0, day=0.0, side_on_day=0.0, drop=0.05, bad=0.3)


@pytest.mark.slow
def test_legs_are_nearer_to_the_truth_and_their_errors_are_right():
    pytest.importorskip("numpyro")
    study = simulate(Design(people=30, sides=1, days=1, drops=2, groups=1, truths=(NOISY,)), 0)
    found = shrunk(values_of(study, NOISY.quantity), draws=200).legs.set_index("person")
    truth = study.quantities.groupby("participant")["truth"].first()
    off, plain = found["value"] - truth, found["plain"] - truth
    # The mean of two drops is off by 0.08 or, badly recorded, by 0.15; people scatter by 0.1.
    assert np.mean(off**2) < 0.8 * np.mean(plain**2)
    # The square of an error over its standard error has mean 1, and of 30 a deviation of 0.26.
    assert np.mean((off / found["error"]) ** 2) == pytest.approx(1.0, abs=3.5 * 0.26)
    # Everybody is drawn towards the mean.
    assert found["value"].std() < found["plain"].std()


def test_two_people_are_refused():
    values = values_of(simulate(Design(people=2, drops=2), 0), "relaxation_index")
    with pytest.raises(NotTold, match="too few"):
        shrunk(values)
