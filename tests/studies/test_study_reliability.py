"""Test and retest of studies whose truth is known."""

import numpy as np
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.icc import icc
from exoid.studies.statistics.reliability import ANOVA, DETECTABLE, MIXED, reliability
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import OCCASION, Values, means, values_of

TRUTH = Truth(bad=0.0)
ONE_LEG = Truth(bad=0.0, side=0.0, side_on_day=0.0)


def of(design, seed=0):
    return values_of(simulate(design, seed), design.truths[0].quantity)


def test_of_one_leg_that_always_came_it_is_the_classical_table():
    values = of(Design(people=15, sides=1, groups=1, truths=(ONE_LEG,)))
    found = reliability(values)
    classical = icc(means(values, OCCASION)["value"].unstack("session").to_numpy())
    assert found.how == ANOVA
    assert found.agreement == classical.agreement
    assert found.sem == classical.sem
    assert found.change.value == pytest.approx(1.96 * 2**0.5 * classical.sem.value, rel=1e-4)


def test_where_both_ways_are_open_the_mixed_model_says_the_same():
    values = of(Design(people=30, sides=1, groups=1, truths=(ONE_LEG,)))
    classical = reliability(values)
    frame = values.frame
    # One visit of one person less, and the table is no longer complete.
    missed = frame[(frame["person"] != "sub-000") | (frame["session"] == "day1")]
    mixed = reliability(Values(values.quantity, values.unit, missed))
    assert mixed.how == MIXED
    # One of thirty people, and drops weighted by their errors instead of equally.
    assert mixed.agreement.value == pytest.approx(classical.agreement.value, abs=0.03)
    assert mixed.agreement.low == pytest.approx(classical.agreement.low, abs=0.06)
    assert mixed.sem.value == pytest.approx(classical.sem.value, rel=0.06)


def test_truth_lies_in_the_intervals_as_often_as_they_say():
    design, held = Design(people=30, groups=1, drops=2, absent=0.3, truths=(TRUTH,)), np.zeros(2)
    for seed in range(60):
        found = reliability(of(design, seed))
        sem, correlation = TRUTH.error_of_occasion(2), TRUTH.correlation(2, 1)
        held += [
            found.sem.low <= sem <= found.sem.high,
            found.consistency.low <= correlation <= found.consistency.high,
        ]
    # 95 % of 60 with a standard deviation of 1.7; intervals of 30 people are a little short.
    assert (held >= 57 - 3.5 * 1.7).all()


def test_a_single_drop_is_worth_less_than_the_mean_of_five():
    found = reliability(of(Design(people=40, groups=1, truths=(TRUTH,))))
    assert found.one_drop is not None
    assert found.one_drop_change is not None
    assert found.one_drop.value < found.agreement.value
    # The variance of drops and of their errors by 5: truth is 0.083 after 0.103.
    ratio = TRUTH.error_of_occasion(1) / TRUTH.error_of_occasion(5)
    assert found.one_drop_change.value / found.change.value == pytest.approx(ratio, rel=0.1)
    single = reliability(of(Design(people=40, drops=1, groups=1, truths=(TRUTH,))))
    assert single.one_drop is None


def test_a_shift_of_all_lowers_agreement_and_leaves_consistency():
    shifted = Truth(bad=0.0, shift=0.3)
    before, after = (
        reliability(of(Design(people=40, groups=1, truths=(each,)))) for each in (TRUTH, shifted)
    )
    assert after.consistency.value == pytest.approx(before.consistency.value, abs=1e-3)
    assert after.sem.value == pytest.approx(before.sem.value, rel=1e-3)
    assert after.agreement.value < before.agreement.value - 0.2


def test_the_detectable_change_is_exceeded_by_chance_in_one_of_twenty():
    sem = TRUTH.error_of_occasion(5)
    draw = np.random.default_rng(0)
    apart = draw.normal(0, sem, 20_000) - draw.normal(0, sem, 20_000)
    # The standard deviation of a share of 20 000 is 0.0015.
    assert np.mean(np.abs(apart) > DETECTABLE * sem) == pytest.approx(0.05, abs=0.006)


def test_one_session_or_few_people_are_refused():
    with pytest.raises(NotTold, match="0 people have values of two sessions"):
        reliability(of(Design(people=10, days=1)))
    with pytest.raises(NotTold, match="2 people have values of two sessions"):
        reliability(of(Design(people=2)))


def test_stated_errors_alone_are_no_narrow_interval():
    truth = Truth(bad=0.0, day=0.0, side_on_day=0.0, drop=0.0, error=0.1, spread=0.0)
    values = of(Design(people=13, groups=1, truths=(truth,)))
    frame = values.frame
    leg = frame.groupby(["person", "side"])["value"].transform("mean")
    # Values lie half as far from their legs as their errors would have them.
    closer = frame.assign(value=leg + (frame["value"] - leg) / 2)
    found = reliability(Values(values.quantity, values.unit, closer))
    assert found.sem.value == pytest.approx(0.1 / 5**0.5, rel=1e-3)
    assert np.isnan([found.sem.low, found.sem.high, found.change.low]).all()
    assert "taken as exactly known" in found.notes[0]
    scattered = reliability(of(Design(people=13, groups=1, truths=(TRUTH,))))
    assert scattered.notes == ()
    assert scattered.change.low < scattered.change.value < scattered.change.high


def test_days_that_tell_nothing_do_not_make_the_detectable_change_of_the_others():
    truth = Truth(bad=0.0, drop=0.0)
    values = of(Design(people=40, drops=1, groups=1, truths=(truth,)))
    frame = values.frame
    lost = np.arange(len(frame)) % 20 == 0
    blurred = frame.assign(error=np.where(lost, 10.0, frame["error"]))
    found = reliability(Values(values.quantity, values.unit, blurred))
    exact = reliability(Values(values.quantity, values.unit, frame[~lost]))
    # Of 8 of 160 days the errors are 50 times what people differ by: they weigh nothing.
    assert found.sem.value == pytest.approx(exact.sem.value, rel=0.02)
    assert found.consistency.value == pytest.approx(exact.consistency.value, abs=0.01)
    assert found.notes[0].startswith("8 of 160 days of a leg have stated errors larger")
    assert exact.notes == ()


def test_where_all_days_tell_as_little_none_is_left_out():
    truth = Truth(bad=0.0, error=2.0, spread=0.1, drop=0.0)
    found = reliability(of(Design(people=40, drops=1, groups=1, truths=(truth,))))
    # 160 errors of 10 % more or less: their root mean square is 2.02.
    assert found.sem.value == pytest.approx(2.02, rel=0.02)
    assert not any("larger" in each for each in found.notes)
