"""A second cause with one number is tried, though richer ones come nearer at first sight."""

from unittest.mock import Mock

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.fitting.solve.problem import Problem
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search import pairs
from exoid.mismatch.search.likely import foremost
from exoid.mismatch.search.pairs import beside_sticking, plainer_forms
from exoid.mismatch.sensors.agreement import Consistency
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.slack_cubic_stiffness import SlackCubicStiffness
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle

SEEN = {  # mean squares to first order beside dry friction, of a spring slack at -30 deg by SciPy
    EndRangeStiffening: 1.031,
    SlackCubicStiffness: 1.048,
    StiffnessRestAngle: 1.0535,
    TorqueBias: 1.0543,
}


def test_a_spring_that_is_slack_elsewhere_is_tried_beside_dry_friction(monkeypatch):
    known = explaining(2.3 * SAMPLES, CoulombFriction)
    each = [
        (SAMPLES * left, explaining(left, CoulombFriction, term).candidate)
        for term, left in SEEN.items()
    ]
    monkeypatch.setattr(pairs, "beside_free", lambda prepared, usable, one: each)
    tried = beside_sticking(found_of([], []).prepared, [*SEEN], known)
    assert [one.terms[-1] for one in tried] == [*SEEN][:3]


@pytest.mark.parametrize(
    ("left", "numbers", "kept"),
    [
        ([1.0, 1.1, 1.2, 1.3], [4, 2, 1, 1], [0, 1, 2]),
        ([1.0, 1.1, 1.2, 1.3], [4, 1, 1, 1], [0, 1]),  # one of them is simple already
        ([1.0, 1.1, 3.1], [4, 2, 1], [0, 1]),  # far behind
        ([1.0], [4], [0]),
        ([], [], []),
    ],
)
def test_the_best_are_kept_and_the_best_of_what_is_simpler_and_near(left, numbers, kept):
    assert foremost(left, numbers, 2) == kept


@pytest.mark.parametrize(("left", "both"), [(1995.0, False), (1800.0, True)])
def test_friction_that_fades_takes_no_second_cause_where_plain_friction_explains_as_much(
    left, both
):
    plain, fading = explaining(2000.0, CoulombFriction), explaining(left, StribeckFriction)
    found = found_of([plain, fading])
    assert plainer_forms(found, [plain, fading]) == [plain, fading][: 1 + both]


@pytest.mark.parametrize(("left", "tethers"), [(1.05, ()), (200.0, (60.0, 15.0))])
def test_beside_a_cause_that_follows_the_motion_no_tether_hides_a_slow_one(left, tethers):
    """Tied to the motion, a leg with a reflex and a spring slack at -20 deg shows the reflex alone:
    of mean squares of 0.987 and 0.977 without a tether 0.987 and 3.2 are left with one.
    """
    problem, sensors = Mock(spec=Problem), Mock(spec=Consistency)
    prepared = PreparedRecording(problem, sensors, (), 0.0, False, 0.0, tethers=(60.0, 15.0))
    prepared.__dict__["samples"] = SAMPLES
    assert prepared.untethered(left * SAMPLES).tethers == tethers
