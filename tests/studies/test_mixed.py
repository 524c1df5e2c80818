"""The mixed model against statsmodels, against a weighted mean, and against the truth."""

import numpy as np
import pandas as pd
import pytest
from statsmodels.regression.mixed_linear_model import MixedLM

from exoid.studies.statistics.mixed.fit_mixed import fit_mixed
from exoid.studies.statistics.mixed.intervals import Sum, error_interval
from exoid.studies.statistics.mixed.likelihood import likelihood
from exoid.studies.statistics.tables.said import NotTold


def frame(seed, people=20, days=2, drops=3, error=0.0, absent=0.0):
    """Values of people on days, both groups alternating; the truth is 1, 0.5 and 0.4."""
    draw, rows = np.random.default_rng(seed), []
    for person in range(people):
        mean = draw.normal(0, 1.0)
        for day in range(days):
            if day and draw.random() < absent:
                continue
            shift = draw.normal(0, 0.5)
            for _ in range(drops):
                known = error * float(draw.uniform(0.2, 2.0))
                value = 5 + mean + shift + draw.normal(0, 0.4) + draw.normal(0, known)
                rows.append(
                    (f"p{person:02d}", "left", f"d{day}", value, known or np.nan, person % 2)
                )
    return pd.DataFrame(rows, columns=["person", "side", "session", "value", "error", "group"])


def effects(table):
    return np.column_stack([np.ones(len(table)), table["group"].to_numpy(float)])


@pytest.mark.parametrize("absent", [0.0, 0.4])
def test_without_known_errors_it_is_the_model_of_statsmodels(absent):
    table = frame(1, absent=absent)
    ours = fit_mixed(table, effects(table))
    days = {"day": "0 + C(session)"}
    model = MixedLM.from_formula(
        "value ~ group", table, groups="person", re_formula="1", vc_formula=days
    )
    theirs = model.fit(reml=True, method=["lbfgs"])
    # Both stop where the likelihood is flat to about 1e-8; variances are 1e-4 off there.
    assert ours.effects == pytest.approx(theirs.fe_params.to_numpy(), rel=1e-3)
    assert np.sqrt(np.diag(ours.covariance)) == pytest.approx(theirs.bse_fe.to_numpy(), rel=1e-3)
    assert ours.variances["person"] == pytest.approx(float(theirs.cov_re.iloc[0, 0]), rel=5e-3)
    assert ours.variances["day"] == pytest.approx(float(theirs.vcomp[0]), rel=5e-3)
    assert ours.variances["drop"] == pytest.approx(float(theirs.scale), rel=5e-3)


def test_one_value_of_each_person_with_its_error_is_a_meta_analysis():
    draw = np.random.default_rng(3)
    error = draw.uniform(0.1, 1.0, 30)
    value = draw.normal(2.0, 0.5, 30) + draw.normal(0, error)
    table = pd.DataFrame({"person": [f"p{at}" for at in range(30)], "value": value, "error": error})
    ours = fit_mixed(table.assign(side="", session=""), np.ones((30, 1)))
    weights = 1 / (ours.variances["person"] + error**2)
    # At its variance the mean is the weighted one, and its error that of the weights.
    assert ours.effects[0] == pytest.approx(np.sum(weights * value) / weights.sum(), rel=1e-6)
    assert ours.covariance[0, 0] == pytest.approx(1 / weights.sum(), rel=1e-6)
    # The variance is where the restricted likelihood has no slope: Q = expected Q.
    square = np.sum(weights**2 * (value - ours.effects[0]) ** 2)
    expected = weights.sum() - np.sum(weights**2) / weights.sum()
    assert square == pytest.approx(expected, rel=1e-3)


def test_the_slope_of_the_likelihood_is_that_of_its_differences():
    table = frame(2, error=0.3)
    problem = fit_mixed(table, effects(table)).problem
    place = np.array([0.7, 0.3, 0.2])
    for at in range(3):
        step = np.zeros(3)
        step[at] = 1e-5
        above, below = likelihood(place + step, problem), likelihood(place - step, problem)
        slope = (above.deviance - below.deviance) / 2e-5
        assert likelihood(place, problem).slope[at] == pytest.approx(slope, rel=1e-6)


def test_a_value_that_is_known_badly_hardly_counts():
    table = frame(4, error=0.3)
    table.loc[table["group"] == 0, "error"] = 0.1
    spoiled = table.copy()
    spoiled.loc[0, ["value", "error"]] = [5000.0, 1e5]
    before, after = (fit_mixed(each, effects(each)) for each in (table, spoiled))
    # It weighs 1e-10 of the others; it takes their place in one drop of one person.
    assert after.effects == pytest.approx(before.effects, abs=0.1)


def test_in_a_balanced_study_the_interval_of_a_variance_is_the_classical_one():
    table = frame(5, days=2, drops=1)
    found = fit_mixed(table, np.column_stack([np.ones(len(table)), table["session"] == "d1"]))
    sem = error_interval(found, Sum(np.array([0.0, 1.0])))
    from exoid.studies.statistics.icc import icc

    wide = table.pivot(index="person", columns="session", values="value").to_numpy()
    classical = icc(wide).sem
    # The same sums of squares; the search stops 1e-4 off.
    for end in ("value", "low", "high"):
        assert getattr(sem, end) == pytest.approx(getattr(classical, end), rel=1e-3)


def test_fewer_than_three_people_or_no_scatter_is_refused():
    table = frame(6)
    with pytest.raises(NotTold, match="too few"):
        fit_mixed(table[table["person"] < "p02"], np.ones((12, 1)))
    with pytest.raises(NotTold, match="vary"):
        fit_mixed(table.assign(value=3.0), np.ones((len(table), 1)))
    with pytest.raises(NotTold, match="told apart"):
        fit_mixed(table, np.ones((len(table), 2)))
