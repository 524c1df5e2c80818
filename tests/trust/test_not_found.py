"""What is said of an effect that a model has and its recording does not show."""

from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.stats import truncnorm

import exoid
from exoid.fitting.estimate import fit
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.trust.identify import identify
from exoid.trust.not_found import none_of, not_found, upper
from exoid.twin.protocols import record
from fit_cases import BODY, DROP, leg, recorded

FRICTION: Any = CoulombFriction
ONCE = FRICTION(jnp.asarray(0.05))


def friction(value: float, error: float, symbol="F_c / J", unit="1/s^2") -> Estimate:
    return Estimate(symbol, "friction level", unit, value, error)


@pytest.mark.parametrize("value", [0.0, 0.3, 1.9])
def test_the_limit_holds_all_but_a_twentieth_of_what_it_may_be(value):
    cut = truncnorm(-value / 0.5, np.inf, value, 0.5)
    assert upper(friction(value, 0.5)) == pytest.approx(float(cut.ppf(0.95)))


def test_the_limit_holds_the_truth_in_nineteen_of_twenty():
    """Of normal draws that no search lets below 0; where there is nothing, always."""
    random = np.random.default_rng(1)
    for truth in (0.0, 0.5, 1.0, 1.5):
        drawn = np.maximum(truth + random.standard_normal(2000), 0.0)
        seen = [friction(float(each), 1.0) for each in drawn]
        missed = [upper(each) < truth for each in seen if none_of(each)]
        assert np.mean(missed) < 0.06


def test_what_may_be_the_zero_of_a_torque_instead_is_not_absent():
    """Of 6 ± 3.5 all but 0.05 is the sensor's zero: what is there is friction, or that."""
    seen = friction(6.1, 3.5)
    assert none_of(seen)
    assert not none_of(replace(seen, limited_by={"torque_zero": 0.9998}))
    assert none_of(replace(friction(0.05, 3.5), limited_by={"torque_zero": 0.9998}))


@pytest.fixture(scope="module")
def smooth() -> FitResult:
    """A leg without friction, fitted with it."""
    found = fit(recorded(DROP), terms=(ONCE,), multistart=2)
    own = found.terms["coulomb_friction"]
    assert own["level_over_inertia"].value is not None
    error = own["level_over_inertia"].standard_error or 1e-3
    small = {
        "level": friction(0.1 * error, error, "F_c", "N m"),
        "level_over_inertia": friction(0.2 * error, error),
    }
    return replace(found, terms={"coulomb_friction": small})


def test_what_is_not_found_has_one_limit(smooth):
    told = identify(smooth)
    (limit,) = told.not_found
    said = [each for each in told.sentences if "F_c / J" in each]
    assert said == [limit.words]
    assert said[0].startswith("no dry friction (Coulomb) found: F_c / J is below ")
    assert said[0].endswith(" 1/s^2 (95 %).")


@pytest.mark.parametrize("form", ["mjcf", "urdf", "python"])
def test_an_export_calls_no_effect_exact_that_was_not_found(smooth, form):
    found = exoid.export(smooth, form)
    (kept,) = (each for each in found.kept if each.what == "coulomb_friction")
    assert kept.how == "none found"
    assert " N m (95 %)" in kept.where
    assert "none found, below" in found.text


def test_what_is_found_is_told_as_it_was():
    model = LegModel(leg(), NoTorque(), terms=(FRICTION(jnp.asarray(0.2)),))
    found = fit(
        record(model, (DROP,), jax.random.key(0), subject=BODY), terms=(ONCE,), multistart=2
    )
    assert not_found(found) == []
    kept = exoid.export(found, "mjcf").kept
    assert ("coulomb_friction", "exact", "frictionloss") in [each.cells for each in kept]
