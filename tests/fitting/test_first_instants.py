"""Recordings that begin as a hand lets go: the hand is no part of the leg."""

import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.misfit.information import common
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.result.remarks.remarks import of_late
from exoid.mismatch.missing_physics import diagnose
from hands import ADULT, Device, Hand, Knee, dropped

TRUTH = {
    "gravity_over_inertia": ADULT.gravity,
    "stiffness_over_inertia": ADULT.stiffness,
    "damping_over_inertia": ADULT.damping,
}
STARTS = 4


def drop(hold: float, fade: float, knee: Knee = ADULT):
    recording, _ = dropped(knee, Hand(hold=hold, fade=fade), Device(), lasting=4.0)
    return recording


def late(result):
    return [each.late for each in result.basis.problem.movements]


@pytest.mark.parametrize(("hold", "fade"), [(0.0, 0.033), (0.0, 0.081), (0.03, 0.041)])
def test_a_hand_in_the_first_instants_moves_no_number(hold, fade):
    result = fit(drop(hold, fade), multistart=STARTS)
    assert late(result)[0] > 0
    assert any("weigh nothing" in note and "a hand" in note for note in result.notes)
    # Of a model that misses something all the time, as friction that creeps, no hand is likelier.
    creeping = common(Missed("torque", 0.1, 2.0, 1.0, 0.0), ["passive"])
    assert not any("a hand" in note for note in of_late(result.basis.problem, creeping))
    assert result.disturbance.kinds["passive"].cause is None
    for name, truth in TRUTH.items():
        found = result.ratios[name]
        assert abs(found.value - truth) < 4 * found.standard_error
    # as sure as where nobody was in doubt: with the hand in the fit it is a hundred times this
    assert result.ratios["damping_over_inertia"].standard_error < 2e-3 * ADULT.damping


def test_a_leg_that_is_let_go_at_once_keeps_its_first_instants():
    result = fit(drop(0.0, 0.0), multistart=STARTS)
    assert late(result) == [0]


def test_they_count_where_no_hand_was_there_by_the_user_s_word():
    result = fit(drop(0.0, 0.081), multistart=STARTS, at_once=True)
    assert late(result) == [0]
    assert result.disturbance.kinds["passive"].cause is not None


@pytest.mark.proof
@pytest.mark.parametrize(("hold", "fade"), [(0.0, 0.011), (0.0, 0.033), (0.03, 0.041)])
def test_a_diagnosis_names_no_cuffs_for_a_hand(hold, fade):
    found = diagnose(drop(hold, fade), multistart=STARTS)
    assert (found.verdict, found.selected) == ("cannot_tell", [])
    assert "a hand, soft cuffs and play all begin like this" in found.reasons[0]
