"""Groups and doses whose difference is known, and against other programs where they agree."""

import numpy as np
import pandas as pd
import pytest
from benchmarks.studies.tables import Design, Truth, simulate
from scipy.stats import ttest_ind

from exoid.studies.statistics.groups import compare_groups
from exoid.studies.statistics.multiple import corrected
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import Values, values_of


def people(values, groups, errors=np.nan):
    """One value of each person."""
    columns = {"value": values, "group": groups, "error": errors, "side": "", "session": ""}
    frame = pd.DataFrame(columns).assign(person=[f"p{at:03d}" for at in range(len(values))])
    return Values("q", "N", frame)


def test_one_value_each_is_a_t_test():
    draw = np.random.default_rng(0)
    values, groups = draw.normal(0, 1, 30), ["a", "b"] * 15
    values[1::2] += 0.8
    found = compare_groups(people(values, groups), "group")
    other = ttest_ind(values[1::2], values[::2])
    (pair,) = found.differences
    # The search for the variance stops 1e-5 off.
    assert found.p == pytest.approx(float(other.pvalue), rel=1e-3)
    interval = other.confidence_interval()
    assert (pair.effect.low, pair.effect.high) == pytest.approx(tuple(interval), rel=1e-3)
    assert [each.people for each in found.groups] == [15, 15]


def test_the_standardised_difference_is_that_of_pingouin():
    pingouin = pytest.importorskip("pingouin")
    draw = np.random.default_rng(1)
    values = draw.normal(0, 1, 21)
    found = compare_groups(people(values, ["a"] * 8 + ["b"] * 13), "group")
    other = pingouin.compute_effsize(values[8:], values[:8], eftype="hedges")
    # pingouin has Hedges' approximation of the correction, 1 - 3 / (4 n - 9).
    assert found.differences[0].g.value == pytest.approx(float(other), rel=1e-3)


def test_three_groups_are_an_analysis_of_variance_and_pairs_are_corrected():
    from scipy.stats import f_oneway

    draw = np.random.default_rng(2)
    values = draw.normal(0, 1, 45) + np.repeat([0.0, 0.0, 1.0], 15)
    found = compare_groups(people(values, np.repeat(["a", "b", "c"], 15)), "group")
    assert found.p == pytest.approx(float(f_oneway(*values.reshape(3, 15)).pvalue), rel=1e-3)
    assert [(each.first, each.second) for each in found.differences] == [
        ("a", "b"), ("a", "c"), ("b", "c"),
    ]  # fmt: skip
    raw = 2 * min(each.p for each in found.differences)
    assert raw > found.p  # Holm's: the smallest of three counts three times


def test_numbers_are_a_dose_and_covariates_are_held():
    draw = np.random.default_rng(3)
    dose, age = np.repeat([0.0, 10.0, 20.0, 30.0], 10), draw.uniform(20, 70, 40)
    values = people(0.05 * dose + 0.1 * age + draw.normal(0, 0.05, 40), dose)
    values.frame["age_years"] = age
    found = compare_groups(values, "group", ["age_years"])
    assert found.kind == "dose"
    assert found.slope is not None
    # 0.05 / (11 sqrt(40)) is the error of the slope.
    assert found.slope.value == pytest.approx(0.05, abs=4 * 0.05 / (11 * 40**0.5))
    assert found.slope.low > 0


def test_the_difference_is_held_as_often_as_the_interval_says():
    design, held = Design(people=24, drops=2, absent=0.2), 0
    truth = Truth()
    for seed in range(24):
        values = values_of(simulate(design, seed), truth.quantity)
        effect = compare_groups(values, "participant_group").differences[0].effect
        held += effect.low <= truth.effect <= effect.high
    assert held >= 22.8 - 3 * 1.07  # 22.8 of 24 are expected, with that standard deviation


@pytest.mark.parametrize(
    ("groups", "word"),
    [
        (["a"] * 6, "All people with a value are of one group: a"),
        (["a"] * 5 + ["b"], "People with a value: a 5, b 1; 2 of each group"),
        ([None] * 6, "known of nobody"),
        ([""] * 6, "known of nobody"),
        ([str(at) for at in range(26)], "26 groups"),
    ],
)
def test_groups_that_cannot_be_compared_are_refused(groups, word):
    values = people(np.random.default_rng(0).normal(size=len(groups)), groups)
    with pytest.raises(NotTold, match=word):
        compare_groups(values, "group")


def test_people_of_no_group_are_left_out_and_named():
    values = people(np.random.default_rng(0).normal(size=7), ["a"] * 3 + ["b"] * 3 + [None])
    found = compare_groups(values, "group")
    assert found.people == 6
    assert found.notes == ("1 person left out (p006): group is not known.",)


def test_a_person_of_two_groups_is_named():
    values = people(np.random.default_rng(0).normal(size=6), ["a", "b"] * 3)
    values.frame.loc[1, "person"] = "p000"
    with pytest.raises(NotTold, match="p000"):
        compare_groups(values, "group")


def test_holm_and_benjamini_hochberg_as_they_are_defined():
    raw = [0.01, 0.04, float("nan"), 0.03]
    assert corrected(raw, "holm") == pytest.approx([0.03, 0.06, np.nan, 0.06], nan_ok=True)
    assert corrected(raw, "benjamini-hochberg") == pytest.approx(
        [0.03, 0.04, np.nan, 0.04], nan_ok=True
    )
    assert corrected([], "holm") == []


def test_the_standardised_difference_has_the_sign_of_the_difference():
    draw = np.random.default_rng(4)
    values, errors = np.repeat([0.0, 1.0, 0.0, -0.6], 6) + draw.normal(0, 0.1, 24), np.full(24, 0.1)
    # Half of the second group is measured so badly that only a plain mean believes it.
    values[18:] += 8.0
    errors[18:] = 30.0
    found = compare_groups(people(values, ["a"] * 12 + ["b"] * 12, errors), "group").differences[0]
    assert values[12:].mean() > values[:12].mean()
    assert found.effect.value < 0
    assert found.g.value < 0
    assert found.g.low < found.g.value < found.g.high


def sited(sites, groups, effect=0.5):
    """People of two sites that differ by 3, whose groups differ by `effect`."""
    draw = np.random.default_rng(5)
    sites, groups = np.array(sites), np.array(groups)
    values = 3.0 * (sites == "south") + effect * (groups == "b") + draw.normal(0, 0.1, len(sites))
    made = people(values, groups)
    made.frame["site"] = sites
    return made


def test_a_site_of_words_is_held_equal_between_groups():
    # Three of four people of a group are of one site: the plain difference holds half of 3.
    sites = ["north"] * 15 + ["south"] * 5 + ["north"] * 5 + ["south"] * 15
    values = sited(sites, ["a"] * 20 + ["b"] * 20)
    plain = compare_groups(values, "group").differences[0].effect
    held = compare_groups(values, "group", ["site"])
    assert plain.value > 1.0
    # 0.1 sqrt(2 / 20) is the error, and somewhat more as the sites overlap with the groups.
    assert held.differences[0].effect.value == pytest.approx(0.5, abs=4 * 0.04)
    # Means of groups are those at the sites' shares of all people, half and half.
    assert held.groups[0].mean.value == pytest.approx(1.5, abs=4 * 0.04)


@pytest.mark.parametrize("groups", [["a"] * 10 + ["b"] * 10, ["b"] * 10 + ["a"] * 10])
def test_groups_that_are_sites_are_refused(groups):
    values = sited(["north"] * 10 + ["south"] * 10, groups)
    with pytest.raises(NotTold, match="'group' and 'site' part people in the same way"):
        compare_groups(values, "group", ["site"])


def test_a_dose_that_follows_from_the_age_is_refused():
    values = people(np.random.default_rng(0).normal(size=8), [1.0, 2.0, 3.0, 4.0] * 2)
    values.frame["age_years"] = 10.0 * values.frame["group"]
    with pytest.raises(NotTold, match="part people in the same way"):
        compare_groups(values, "group", ["age_years"])
