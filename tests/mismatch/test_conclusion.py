"""From what a search found to a verdict."""

from dataclasses import replace
from unittest.mock import Mock

import numpy as np
import pytest

from exoid.fitting.result.fit_result import Estimate
from exoid.mismatch.conclude.cannot_tell import chance, unrelaxed
from exoid.mismatch.conclude.conclusion import partial
from exoid.mismatch.evidence.prediction import Prediction, improves
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.missing_physics import for_inertia, noise_alone
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum, Products
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found
from exoid.physics.parameter import declarations
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.cuff_compliance import CuffCompliance
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement

SAMPLES = 1000
NOTHING = Hypothesis((), (), np.zeros(4))


def leaving(square):
    """A candidate that leaves so much."""
    return Optimum(NOTHING, Products(np.zeros((1, 1, 1)), np.array([[square]])), motion=None)


@pytest.mark.parametrize(
    ("left", "doubted"),
    [(1000.0, False), (20_000.0, False), (40_000.0, True)],
    ids=["all", "four fifths", "two thirds"],
)
def test_a_part_is_no_cause_where_nobody_declared_the_noise(left, doubted):
    base = leaving(101_000.0)
    found = Found(
        Mock(spec=PreparedRecording), base, NOTHING, [], [], [], [], Yardstick(SAMPLES, scale=1.0)
    )
    reasons = partial(found, leaving(left))
    assert bool(reasons) == doubted
    if doubted:
        assert "declare the sensors' noise" in reasons[0]


@pytest.mark.parametrize(
    ("samples", "size", "alone"),
    [(40, 1.0, True), (40, 1.5, False), (6, 0.9, False), (4, 0.1, False)],
    ids=["noise", "more", "few samples", "as many parameters"],
)
def test_parameters_may_have_been_spent_on_a_few_first_samples(samples, size, alone):
    """Four of them leave two of six samples to contradict them."""
    assert noise_alone(np.full(samples, size), parameters=4) == alone


@pytest.mark.parametrize(("term", "doubted"), [(MaxwellElement, True), (CuffCompliance, False)])
def test_what_remembers_for_seconds_may_remember_what_nobody_recorded(term, doubted):
    """A leg that was held for a second before the drop has not forgotten how it came there."""
    prepared = Mock(spec=PreparedRecording, rig=False)
    best = leaving(9000.0)
    best = replace(best, candidate=replace(NOTHING, terms=(term,)))
    reasons = unrelaxed(prepared, best)
    assert bool(reasons) == doubted
    assert not doubted or "Hold it still for 10 s" in reasons[0]


def test_a_torque_over_j_is_given_for_the_inertia_of_the_diagnosis_with_its_whole_error():
    declared = dict(declarations(CoulombFriction))["level"]
    ratio = Estimate("F_c / J", "friction, over J", "1/s^2", 0.5, 0.2)
    each = for_inertia(ratio, declared, 0.4)
    assert (each.value, each.standard_error) == pytest.approx((0.2, 0.08))
    soft = dict(declarations(CuffCompliance))["compliance"]
    assert for_inertia(ratio, soft, 0.4).value == pytest.approx(1.25)
    assert for_inertia(replace(ratio, standard_error=None), soft, 0.4).standard_error is None


@pytest.mark.parametrize(
    ("share", "doubted"), [(None, False), (0.96, False), (0.04, True), (0.0, True)]
)
def test_what_other_segments_would_contradict_is_not_asserted(share, doubted):
    assert bool(chance(share)) == doubted


@pytest.mark.parametrize(
    ("after", "better"),
    [((50.0, 60.0), True), ((99.7, 99.9), False), ((50.0, 160.0), False)],
    ids=["both by half", "hardly", "one much worse"],
)
def test_held_out_data_must_be_predicted_better_by_what_matters(after, better):
    def predicted(squares):
        nothing = np.zeros((2, 1))
        return Prediction(nothing, nothing == 0, np.zeros(2), np.array(squares))

    assert improves(predicted((100.0, 100.0)), predicted(after)) == better
