"""Drops whose hand lets go over half a second: the swings after it tell the leg."""

import pytest

from exoid.fitting.estimate import fit
from exoid.mismatch.conclude.verdict.cannot_tell import hands
from exoid.mismatch.prepare import prepare
from exoid.recordings.loading.named import named_recordings
from hands import ADULT, Hand, Knee, dropped

TRUTH = ("gravity", "stiffness", "damping")
STARTS = 4


def drop(fade: float, knee: Knee = ADULT):
    return dropped(knee, Hand(fade=fade), lasting=5.0)[0]


def slow(result):
    return [each.slow for each in result.basis.problem.movements]


@pytest.mark.parametrize("fade", [0.5, 0.7])
def test_a_leg_that_is_let_go_slowly_is_told_by_its_swings_after_that(fade):
    result = fit(drop(fade), multistart=STARTS)
    assert result.follows
    assert slow(result)[0] > fade / 2  # by then a soft hand carries less than half
    assert any("lets go slowly" in note for note in result.notes)
    for name in TRUTH:
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - getattr(ADULT, name)) < 4 * found.standard_error
    # a hundredth of the leg's own; with the hand in the fit it is as large as that
    assert result.ratios["damping_over_inertia"].standard_error < 0.01 * ADULT.damping


def test_a_leg_that_is_let_go_quickly_keeps_its_fall():
    assert slow(fit(drop(0.05), multistart=STARTS)) == [0.0]


def test_no_hand_is_looked_for_where_it_let_go_at_once_by_the_user_s_word():
    result = fit(drop(0.5), multistart=STARTS, at_once=True)
    assert slow(result) == [0.0]
    assert not result.follows


def test_a_drop_without_swings_after_it_stays_refused():
    result = fit(drop(0.7, Knee(28.0, 5.0, 12.0)), multistart=STARTS)
    assert slow(result) == [0.0]


def test_a_diagnosis_that_finds_nothing_in_the_swings_speaks_of_the_hand():
    named = named_recordings(drop(0.5))
    prepared, _ = prepare(fit(named, multistart=STARTS), named, ())
    assert "a hand lets go slowly" in hands(prepared)[0]
