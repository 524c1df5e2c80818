"""From what a search found to a verdict."""

from dataclasses import replace
from itertools import permutations
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
from found_by_hand import NOTHING, explaining, found_of, leaving, sprung

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.mismatch.conclude.asserted import (
    at_its_most,
    certain_of,
    equivalents,
    weight,
)
from exoid.mismatch.conclude.numbers import widening
from exoid.mismatch.conclude.plainest import plainest
from exoid.mismatch.conclude.rivals import ONE_AT_A_TIME, REPEAT, advice
from exoid.mismatch.conclude.verdict.cannot_tell import unrelaxed
from exoid.mismatch.conclude.verdict.undecided import undecided
from exoid.mismatch.evidence.prediction import Prediction, improves
from exoid.mismatch.evidence.proof import beginning
from exoid.mismatch.missing_physics import noise_alone
from exoid.mismatch.novel.dictionary import dictionary
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.challenge import as_near
from exoid.mismatch.with_model import for_inertia
from exoid.physics.parameter import declarations
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.sensing.encoder_gain import EncoderGain
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.zero_drift import ZeroDrift
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.cuff_compliance import CuffCompliance
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.hysteresis import Hysteresis
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.physics.terms.tissue.wobbling_mass import WobblingMass


@pytest.mark.parametrize(
    ("square", "widened"),
    [(1000.0, 1.0), (1090.0, 1.0), (1910.0, 911.0), (101_000.0, 100_001.0)],
)
def test_what_remains_may_lie_along_any_number_as_much_as_beside_all(square, widened):
    """Noise is 1000. Of nine reflexes that follow another law, errors by the noise and
    its correlation missed by 17, 5 and 15 of them, these by 1.0, 0.3 and 0.9 (root mean squares).
    """
    best = explaining(square, CoulombFriction)
    assert widening(found_of([best]), best) == pytest.approx(widened)


@pytest.mark.parametrize(
    ("segments", "term", "more"),
    [(2, ZeroDrift, [5]), (3, ZeroDrift, []), (2, CoulombFriction, [])],
)
def test_a_zero_that_moves_is_a_held_out_segments_own_where_one_other_tells_none(
    segments, term, more
):
    """Of 4 unknowns of the leg, a gyro's bias and an encoder's zero, and the term's."""
    prepared = Mock(spec=PreparedRecording, segments=segments)
    prepared.numbers = SimpleNamespace(own=(np.array([2, 3, 3]),))
    one = explaining(1000.0, term).candidate
    assert beginning(prepared, 1, one) == [3, *more]


def test_what_leaves_only_noise_is_certain_where_its_rivals_leave_clearly_more():
    best = explaining(1000.0, CoulombFriction)
    assert certain_of(found_of([best, explaining(1030.0, QuadraticDrag)]), best) == (
        CoulombFriction,
    )
    assert certain_of(found_of([best, explaining(1003.0, QuadraticDrag)]), best) == ()


def test_what_even_the_best_leaves_may_tell_it_from_its_rivals():
    """It leaves 20 times the noise: what nobody knows is 19 000, as much as lies between it and a
    rival that leaves twice as much; four times as much is another matter.
    """
    best = explaining(20_000.0, CoulombFriction)
    assert certain_of(found_of([best, explaining(38_000.0, QuadraticDrag)]), best) == ()
    assert certain_of(found_of([best, explaining(80_000.0, QuadraticDrag)]), best) == (
        CoulombFriction,
    )


@pytest.mark.parametrize(
    ("share", "left", "certain"),
    [
        (0.3, 3_000.0, (WobblingMass,)),
        (0.5, 3_000.0, ()),
        (0.5, 1_000.0, (WobblingMass,)),
    ],
)
def test_a_lone_cause_as_large_as_it_can_be_is_certain_only_down_to_the_noise(share, left, certain):
    one = explaining(left, WobblingMass)
    values = (np.array([share, *one.candidate.values[0][1:]]),)
    best = replace(one, candidate=replace(one.candidate, values=values))
    assert certain_of(found_of([best]), best) == certain


def test_beside_another_cause_none_is_certain_that_would_have_to_be_larger_than_it_can_be():
    pair = explaining(1_000.0, CoulombFriction, WobblingMass)
    friction, tissue = pair.candidate.values
    for share, certain in ((0.3, (CoulombFriction, WobblingMass)), (0.5, (CoulombFriction,))):
        values = friction, np.array([share, *tissue[1:]])
        best = replace(pair, candidate=replace(pair.candidate, values=values))
        assert certain_of(found_of([], [best]), best) == certain


@pytest.mark.parametrize(
    ("left", "gyro", "certain"),
    [(30_000.0, True, (ZeroDrift,)), (30_000.0, False, ()), (1_000.0, False, (ZeroDrift,))],
)
def test_an_encoder_that_no_gyro_watches_is_blamed_only_down_to_the_noise(left, gyro, certain):
    best = explaining(left, ZeroDrift)
    found = found_of([best])
    found.prepared.has_gyro = gyro
    assert certain_of(found, best) == certain


def test_tissue_that_does_not_ring_is_no_tissue_that_wobbles():
    """Tissue that relaxes in several times looks like that beside one that relaxes in one."""
    pair = explaining(1_000.0, MaxwellElement, WobblingMass)
    relaxing, tissue = pair.candidate.values
    for ratio, certain in ((0.3, (MaxwellElement, WobblingMass)), (1.0, (MaxwellElement,))):
        values = relaxing, np.array([*tissue[:-1], ratio])
        best = replace(pair, candidate=replace(pair.candidate, values=values))
        assert certain_of(found_of([], [best]), best) == certain


@pytest.mark.parametrize(
    ("term", "size", "most"),
    [
        (EncoderGain, -0.2, True),
        (StiffnessRestAngle, -2.0, False),
        (TorqueBias, 0.0, False),
        (CoulombFriction, 0.0, False),
        (CoulombFriction, 50.0, True),
    ],
)
def test_a_size_without_a_sign_is_not_at_its_limit_where_it_is_nothing(term, size, most):
    assert at_its_most(term, size, found_of([])) is most


def test_what_a_formula_has_once_in_a_motion_may_be_a_moment():
    """A swing that passes -1 rad again and again, and is beyond -1.5 rad only as it begins."""
    time = np.arange(0.0, 10.0, 0.01)
    angle = -1.0 - 0.65 * np.exp(-0.5 * time) * np.cos(6.0 * time)
    velocity = np.gradient(angle, time)
    bump = next(one for one in dictionary() if one.words.startswith("bump(x"))

    def moment_of(place):
        feature = replace(bump, shape=(place, 0.05))
        return Formula((feature,), np.array([1.0]), 1.0, 0.0).moment_of(angle, velocity, time)

    assert moment_of(-1.0) is None
    assert moment_of(-1.65) == (0.0, pytest.approx(0.1, abs=0.1))


def test_forms_of_one_cause_and_exact_twins_are_one_answer():
    best = explaining(20_000.0, CoulombFriction, TorqueBias)
    rival = explaining(21_000.0, StribeckFriction, StiffnessRestAngle)
    assert certain_of(found_of([best], [rival]), best) == (CoulombFriction, TorqueBias)


def test_of_two_causes_only_the_one_is_certain_that_all_sets_have():
    best = explaining(1000.0, CoulombFriction, QuadraticDrag)
    rival = explaining(1004.0, CoulombFriction, TorqueBias)
    assert certain_of(found_of([], [best, rival]), best) == (CoulombFriction,)


def test_a_cause_that_is_not_needed_takes_nothing_from_the_best():
    best = explaining(1000.0, CoulombFriction)
    wider = explaining(995.0, CoulombFriction, QuadraticDrag)
    assert equivalents(found_of([best], [wider]), best) == [best]


def test_where_noise_is_not_reached_what_came_as_near_at_first_sight_is_asked_again():
    best, seen = explaining(20_000.0, CoulombFriction), explaining(25_000.0, CoulombFriction)
    near, far = explaining(26_000.0, QuadraticDrag), explaining(90_000.0, TorqueBias)
    found = found_of([best], pinned=[seen, near, far])
    assert as_near(found, best) == [near]
    assert as_near(found_of([best, near], pinned=[seen, near, far]), best) == []


@pytest.mark.parametrize(("friction", "certain"), [(0.2, (CoulombFriction,)), (0.0, ())])
def test_a_frame_that_rubs_has_dry_friction_however_far_its_play_reaches(friction, certain):
    best = explaining(1000.0, CoulombFriction)
    value = np.array([0.03, 0.01, 1.0, friction, 0.0, 0.01, 0.7])
    play = explaining(960.0, Backlash)  # its six parameters more are worth 41
    play = replace(play, candidate=replace(play.candidate, values=(value,)))
    found = found_of([best, play])
    assert certain_of(found, best) == certain
    assert plainest(found, best) is best


def test_what_all_explanations_have_is_certain_whichever_of_them_is_the_best():
    value = np.array([0.03, 0.01, 1.0, 0.2, 0.0, 0.01, 0.7])
    play = explaining(20_000.0, Backlash)
    play = replace(play, candidate=replace(play.candidate, values=(value,)))
    rubbing, rough = explaining(21_000.0, CoulombFriction), explaining(22_000.0, StribeckFriction)
    found = found_of([play, rough, rubbing, explaining(90_000.0, TorqueBias)])
    assert certain_of(found, play) == (CoulombFriction,)
    assert plainest(found, play) is rubbing
    found = found_of([play, rough])
    assert certain_of(found, play) == (CoulombFriction,)  # of play, no friction that falls is known
    assert plainest(found, play) is rough
    apart = found_of([play, rubbing, explaining(21_000.0, TorqueBias)])
    assert certain_of(apart, play) == ()
    assert plainest(apart, play) is play


def test_the_friction_of_a_frame_is_a_part_of_its_play():
    value = np.array([0.03, 0.01, 1.0, 0.2, 0.0, 0.01, 0.7])
    play = explaining(1000.0, Backlash)
    play = replace(play, candidate=replace(play.candidate, values=(value,)))
    assert certain_of(found_of([play, explaining(9000.0, TorqueBias)]), play) == (Backlash,)


def test_a_finer_form_is_named_only_where_it_explains_more_than_what_remains():
    rough, rubbing = explaining(20_000.0, StribeckFriction), explaining(25_000.0, CoulombFriction)
    assert plainest(found_of([rough, rubbing]), rough) is rubbing
    far = explaining(45_000.0, CoulombFriction)
    assert plainest(found_of([rough, far]), rough) is rough
    yields = explaining(20_000.0, Hysteresis)  # which is no form of what sticks
    assert plainest(found_of([yields, rubbing]), yields) is yields


@pytest.mark.parametrize("simpler", list(permutations((QuadraticDrag, CoulombFriction))))
def test_the_order_in_which_causes_were_found_does_not_hide_a_simpler_form(simpler):
    rough, plain = explaining(20_000.0, QuadraticDrag, StribeckFriction), explaining(25e3, *simpler)
    assert plainest(found_of([], [rough, plain]), rough) is plain


def test_of_exact_twins_that_is_named_which_every_gyro_has_some_of():
    late = explaining(1000.0, ClockRate, TorqueBias)
    wide = explaining(1000.2, TorqueBias, GyroScale)
    assert plainest(found_of([late], [wide]), late) is wide
    assert plainest(found_of([late]), late) is late
    far = explaining(1100.0, TorqueBias, GyroScale)
    assert plainest(found_of([late], [far]), late) is late
    other = explaining(1000.2, HardStop, GyroScale)
    assert plainest(found_of([late], [other]), late) is late


@pytest.mark.parametrize(
    ("rest", "rig", "named"),
    [
        (0.5, False, TorqueBias),  # 29 deg beyond full extension: no knee's spring is slack there
        (-0.5, False, StiffnessRestAngle),
        (0.5, True, StiffnessRestAngle),  # whose zero is anywhere
    ],
)
def test_a_constant_torque_is_no_spring_that_is_slack_where_no_knee_is(rest, rig, named):
    best, twin = explaining(1000.0, StiffnessRestAngle), explaining(1000.2, TorqueBias)
    best = replace(best, candidate=replace(best.candidate, values=(np.array([rest]),)))
    found = found_of([best, twin])
    found.prepared.rig = rig
    assert plainest(found, best).candidate.terms == (named,)
    far = found_of([best, explaining(1100.0, TorqueBias)])
    far.prepared.rig = rig
    assert plainest(far, best) is best


def test_a_hysteresis_that_yields_at_once_is_dry_friction_and_no_hysteresis():
    best = explaining(1000.0, Hysteresis)
    sharp = replace(best, candidate=replace(best.candidate, values=(np.array([0.5, 0.004]),)))
    soft = replace(best, candidate=replace(best.candidate, values=(np.array([0.5, 0.03]),)))
    far = explaining(9000.0, TorqueBias)
    assert certain_of(found_of([sharp, far]), sharp) == (CoulombFriction,)
    assert certain_of(found_of([soft, far]), soft) == (Hysteresis,)


def test_a_frame_without_play_is_not_called_play():
    value = np.array([0.0, 0.05, 3.0, 0.5, 0.0, 0.02, 0.0])
    play = explaining(1000.0, Backlash)
    play = replace(play, candidate=replace(play.candidate, values=(value,)))
    assert certain_of(found_of([play, explaining(9000.0, TorqueBias)]), play) == (CoulombFriction,)


@pytest.mark.parametrize(("bounce", "stops"), [(0.2, True), (0.8, False)])
def test_what_is_softer_than_gravity_is_not_called_a_stop(bounce, stops):
    best = explaining(1000.0, CoulombFriction, HardStop)
    values = (np.array([0.5]), np.array([bounce, -1.0, -3.2, 0.0]))
    best = replace(best, candidate=replace(best.candidate, values=values))
    found = found_of([explaining(20_000.0, CoulombFriction)], [best])
    certain = certain_of(found, best)
    assert certain == ((CoulombFriction, HardStop) if stops else (CoulombFriction,))


@pytest.mark.parametrize(("left", "second"), [(1000.0, True), (5000.0, False)])
def test_a_second_cause_is_certain_only_where_noise_is_left(left, second):
    """A reflex that was not followed to its end had friction beside it, at 17 times the noise."""
    best = explaining(left, CoulombFriction, QuadraticDrag)
    singles = [explaining(20_000.0, CoulombFriction), explaining(60_000.0, QuadraticDrag)]
    certain = certain_of(found_of(singles, [best]), best)
    assert certain == ((CoulombFriction, QuadraticDrag) if second else (CoulombFriction,))


def test_of_two_that_explain_nothing_without_each_other_neither_is_certain_above_the_noise():
    """A robot's joint had a constant torque beside hysteresis that alone left more than Eq. 9."""
    for left, certain in ((1000.0, (CoulombFriction, TorqueBias)), (5000.0, ())):
        best = explaining(left, CoulombFriction, TorqueBias)
        found = found_of([explaining(102_000.0, TorqueBias)], [best])
        assert certain_of(found, best) == certain
    assert "alone" in undecided(found, [best])[0]
    # a robot's link had dry friction, of which Coulomb's form alone stopped at nothing
    form = found_of(
        [explaining(102_000.0, TorqueBias), explaining(60_000.0, StribeckFriction)], [best]
    )
    assert certain_of(form, best) == (CoulombFriction,)


def test_explanations_weigh_by_their_evidence_and_by_what_even_the_best_leaves():
    """Twenty better than another in units of the noise is e^10; twice as much left, where a lot is,
    e^5; and what holds the cause among others weighs for it.
    """
    best = explaining(1000.0, CoulombFriction)
    assert weight(found_of([best, explaining(1020.0, QuadraticDrag)]), (CoulombFriction,)) == (
        pytest.approx(1 / (1 + np.exp(-10)), rel=1e-9)
    )
    left = explaining(11_100.0, CoulombFriction)
    rivals = [left, explaining(21_100.0, QuadraticDrag)]
    assert weight(found_of(rivals), (CoulombFriction,)) == pytest.approx(1 / (1 + np.exp(-5)))
    both = explaining(21_100.0, CoulombFriction, QuadraticDrag)
    assert weight(found_of([left], [both]), (CoulombFriction,)) == pytest.approx(1.0)


def test_nothing_is_certain_where_the_baseline_leaves_hardly_more():
    best = explaining(60_000.0, CoulombFriction)  # 41 of 100 times the noise explained
    assert certain_of(found_of([best]), best) == ()


@pytest.mark.parametrize(
    ("samples", "size", "alone"),
    [(60, 1.0, True), (60, 1.5, False), (30, 0.9, False), (6, 0.9, False), (4, 0.1, False)],
    ids=["noise", "more", "some samples", "few samples", "as many parameters"],
)
def test_parameters_may_have_been_spent_on_a_few_first_samples(samples, size, alone):
    """A hand that lets go slowly in 0.1 s at 50 Hz was compliant cuffs."""
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


@pytest.mark.parametrize(("segments", "then"), [(1, [REPEAT]), (5, [ONE_AT_A_TIME])])
def test_nobody_is_told_to_repeat_what_was_repeated(segments, then):
    assert advice([], "cannot_tell", None, segments) == then
    twice = advice([], "mismatch", Formula((), np.array([]), 0.9, 0.0), segments)
    assert (REPEAT in twice) == (segments == 1)


def test_a_torque_over_j_is_given_for_the_inertia_of_the_diagnosis_with_its_whole_error():
    declared = dict(declarations(CoulombFriction))["level"]
    ratio = Estimate("F_c / J", "friction, over J", "1/s^2", 0.5, 0.2)
    each = for_inertia(ratio, declared, 0.4)
    assert (each.value, each.standard_error) == pytest.approx((0.2, 0.08))
    soft = dict(declarations(CuffCompliance))["compliance"]
    assert for_inertia(ratio, soft, 0.4).value == pytest.approx(1.25)
    assert for_inertia(replace(ratio, standard_error=None), soft, 0.4).standard_error is None


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


def test_what_takes_the_place_of_the_legs_spring_is_not_certain_but_an_error_of_a_sensor_is():
    best = explaining(2300.0, HardStop, GyroScale)
    found = found_of([best])
    assert certain_of(found, best) == (HardStop, GyroScale)

    def at(candidate):
        return sprung(0.04 if candidate is best.candidate else 4.0)

    found.prepared.coordinates = at
    assert certain_of(found, best) == (GyroScale,)
    found.prepared.rig = True
    assert certain_of(found, best) == (HardStop, GyroScale)


def test_what_has_many_numbers_and_leaves_much_of_what_is_missing_is_not_named():
    few, many = explaining(20_000.0, CoulombFriction), explaining(20_000.0, WobblingMass)
    assert certain_of(found_of([few]), few) == (CoulombFriction,)
    assert certain_of(found_of([many]), many) == ()
    nearly = explaining(3000.0, WobblingMass)
    assert certain_of(found_of([nearly]), nearly) == (WobblingMass,)
