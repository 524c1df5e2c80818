"""A diagnosis in words."""

from dataclasses import replace
from io import StringIO
from typing import Any

import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_by_hand import doubtful, found, nothing, novel
from rich.console import Console

from exoid.fitting.misfit.uncertainty import Shares
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.remarks.remarks import ASK_DIAGNOSE
from exoid.mismatch.answer.diagnosis import Booked, Finding, NovelTorque, Parameter, Suspect
from exoid.mismatch.answer.own_words import in_own_words
from exoid.mismatch.novel.nameless import FadingTorque
from exoid.mismatch.sensors.agreement import OwnValue, SensorError
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.report.tables.mismatch.diagnosis import print_diagnosis, suspects
from exoid.report.words.astray import astray
from exoid.report.words.diagnosis.asserted import ran_free
from exoid.report.words.diagnosis.cause import parameter
from exoid.report.words.diagnosis.certainty import by_push, others
from exoid.report.words.diagnosis.leg import beside
from exoid.report.words.diagnosis.remainder import remains
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.used import used
from exoid.report.words.diagnosis.verdict import headline, verdict
from exoid.report.words.estimate import written


def test_what_was_used_does_not_say_again_why_the_rest_was_not():
    hand = "as where a hand lets go slowly or moves as it lets go, or a muscle holds the leg"
    aside = f"the first 0.3 s were left out: the leg is kept back, {hand}. Let go at once."
    other = "segment 3 was left out: nothing moves freely in there, or hardly ever"
    reason = f"nothing is missing but in the first 0.3 s: there the leg is kept back, {hand}."
    assert used([aside, other], "") == [aside, other]
    assert used([aside, other], f"{reason} Let go at once.") == [
        "the first 0.3 s were left out: the leg is kept back.",
        other,
    ]


def test_a_parameter_without_an_error_is_no_measurement():
    stop = Parameter("hard_stop.extension_angle", 1.2, "rad", None)
    assert parameter(stop) == "extension angle not determined (at 68.8 deg, its limit)"
    assert parameter(Parameter("coulomb_friction.level", 0.1, "N m", 0.002)) == (
        "level 0.1000 ± 0.0020 N m"
    )


def test_what_the_fit_estimates_anyway_is_told_as_an_error_of_a_sensor():
    """A bias of the gyro is free in every fit: no torque is missing, and nothing gets better."""
    one = found()
    bias = Parameter("gyro_bias.bias", 0.012, "rad/s", 0.0001)
    finding = Finding("gyro_bias", "bias of the gyro", "It shows a rate at rest.", "a data sheet")
    alone = replace(one, findings=[finding], parameters=[bias], best=one.baseline)
    assert headline(alone) == "A sensor errs; of the leg's motion nothing is missing."
    said = sentences(alone)
    assert said["Missing"] == "bias of the gyro, bias 0.6875 ± 0.0057 deg/s"
    assert "Where" not in said
    assert "without any leg model" in said["How sure"]
    assert "chance of" not in said["How sure"]
    assert headline(one) == "Something is missing."
    assert "chance of" in sentences(one)["How sure"]


def biased(alone: float, named: float) -> str:
    """What is said of the sensors where a gyro's bias [rad/s] is named beside another cause."""
    bias = Finding("gyro_bias", "bias of the gyro", "It shows a rate at rest.", "a data sheet")
    one = found()
    one = replace(one, sensors=[SensorError("gyro_bias", alone, 0.0001, "rad/s")])
    assert "as if by gyro bias" in sentences(one)["Sensors"]  # where nothing else has named it
    size = Parameter("gyro_bias.bias", named, "rad/s", 0.0001)
    both = replace(one, findings=[*one.findings, bias], parameters=[*one.parameters, size])
    return sentences(both)["Sensors"]


def test_an_error_that_is_named_beside_another_cause_has_one_number():
    said = biased(0.0069, 0.0070)
    assert said == "encoder and gyro differ by the gyro bias that is named above."


def test_two_numbers_of_one_error_are_told_apart():
    """With what else is missing a bias is another than encoder and gyro say of it alone."""
    said = biased(0.0044, 0.0087)
    assert "as if by gyro bias 0.2521 ± 0.0057 deg/s" in said
    assert said.endswith("were there no dry friction: beside that it is as large as named above.")


def test_delays_that_differ_between_segments_are_each_told():
    """The one that all of them would have is none of theirs, however sure it seems."""
    own = [OwnValue(0, 0.004, 3e-5), OwnValue(1, -0.009, 2e-5)]
    skew = SensorError("sensor_skew", 0.001, 9e-5, "s", own)
    one = replace(found(), sensors=[SensorError("gyro_scale", 0.1, 0.001, "1"), skew])
    said = sentences(one)["Sensors"]
    assert "late by 4 ms in segment leg 0, -9 ms in segment leg 1 (± 0.03 ms" in said
    assert "sensor skew" not in said
    assert "as if by gyro scale" in said


def test_a_delay_that_differs_by_the_size_of_a_swing_is_none():
    skew = SensorError("sensor_skew", 0.012, 9e-5, "s", by_size=[0.0112, 0.021])
    said = sentences(replace(found(), sensors=[skew]))["Sensors"]
    assert "as by a delay of 11 ms in the larger swings, of 21 ms in the smaller ones" in said
    assert "a thigh that rocks or sinks" in said
    assert "sensor skew" not in said


def test_a_zero_that_one_segment_does_not_tell_is_said_to_be_the_segments_own():
    """Of two segments: how far it moves from one to the next, the other does not tell."""
    one = found()
    drifting = replace(one, best=replace(one.best, terms=["zero_drift"]))
    assert "each from the other but for its own zero" in sentences(drifting)["Remains"]
    assert "each from the others)" in sentences(one)["Remains"]
    more = replace(one.proof.after, squares=np.ones(3))
    three = replace(drifting, proof=replace(one.proof, before=more, after=more))
    assert "each from the others)" in remains(three)


def test_a_cause_that_the_fit_has_and_nobody_claims_is_said_to_be_uncertain():
    """As a reflex beside a gyro's scale, in the place of which another does as well."""
    gyro: Any = GyroScale
    friction: Any = CoulombFriction
    terms = (gyro(jnp.asarray(0.004)), friction(jnp.asarray(0.1)))
    one = found()
    both = ["coulomb_friction + gyro_scale", "coulomb_friction + quadratic_drag"]
    fitted = replace(one, after=replace(one.fit, fitted_terms=terms), equivalent=both)
    (said,) = beside(fitted)
    assert said.startswith("Not certain: gyro scale.")
    assert beside(replace(fitted, equivalent=both[:1])) == beside(one) == []
    fades: Any = FadingTorque
    nameless = replace(one.fit, fitted_terms=(fades(jnp.asarray(0.3), jnp.asarray(0.4)), terms[1]))
    lone = replace(one, after=nameless, equivalent=["coulomb_friction + fading_torque"])
    assert beside(lone)[0].startswith("Not certain: fading torque.")
    assert "besides it perhaps fading torque" in others(lone)[0]


def test_where_nobody_can_tell_suspects_are_those_of_the_table_and_what_remains_is_with_one():
    each = [Suspect([name], []) for name in ("stretch_reflex", "quadratic_drag")]
    said = sentences(replace(doubtful(), suspected=each))
    assert said["Suspected"] == "stretch reflex, quadratic drag."
    assert " deg with coulomb friction, " in said["Remains"]
    assert "with" not in sentences(found())["Remains"]  # an answer that has a name has said so


INERTIA = Estimate("J", "inertia", "kg m^2", 0.45, 0.01, shares=Shares(1.0, 0.0, 0.0))
BY_PRIOR = Estimate("J", "inertia", "kg m^2", 0.45, 0.1, shares=Shares(0.01, 0.99, 0.0))
BY_BOTH = Estimate("J", "inertia", "kg m^2", 0.45, 0.1, shares=Shares(0.5, 0.5, 0.0))
BY_HAND = replace(BY_PRIOR, by_hand="fix")
UNTOLD = Estimate("J", "inertia", "kg m^2", None, None)


@pytest.mark.parametrize(
    ("known", "said"),
    [
        (UNTOLD, "0.26 rad/s^2 towards extension are missing at -10 to 5 deg, extending"),
        (UNTOLD, "(segment leg 0, 0.10-0.21 s) (torques over J, which nothing tells). Over"),
        (BY_PRIOR, " (for J = 0.38 kg m^2, which the prior sets: torques grow with it). Over"),
        (BY_BOTH, " (for J = 0.38 kg m^2, to which the prior adds: torques grow with it). Over"),
        (BY_HAND, " (for J = 0.38 kg m^2, which you fixed: torques grow with it). Over"),
        (INERTIA, "(segment leg 0, 0.10-0.21 s). Over"),
    ],
)
def test_where_torques_are_missing_says_whose_inertia_they_go_with(known, said):
    """It is that of the fit with what was found, as of all other torques."""
    one = found()
    after = replace(one.before, parameters={**one.before.parameters, "inertia": known})
    place = replace(one.location, inertia=0.38)
    region = replace(place.regions[0], end=0.21)
    told = replace(one, after=after, location=replace(place, regions=[region]))
    assert said in sentences(told)["Where"]


def test_what_leaves_more_than_noise_is_a_part_of_what_is_missing():
    one = found()
    unlike = replace(one, best=replace(one.best, mean_square=8.0))
    assert headline(unlike) == "Something is missing."  # what is left of it is next to nothing
    half = replace(one.proof, after=replace(one.proof.after, rmse=one.proof.before.rmse / 2))
    partly = "Something is missing, and a part of it has a name."
    assert headline(replace(unlike, proof=half)) == partly


def test_where_no_model_follows_it_is_said_that_the_leg_has_no_numbers():
    one = found()
    astray = replace(one.before, astray="it misses the angle")
    assert "not to be used" in sentences(replace(one, after=astray))["The leg"]
    assert "The leg" not in sentences(replace(one, after=one.before))
    rig = replace(one, after=astray, location=replace(one.location, rig=True))
    assert "not to be used" in sentences(rig)["The rig"]


def test_what_is_said_of_a_rig_is_said_of_no_leg():
    """A servo with a bar was told of its leg, its muscles and how to relax them."""
    one = found()
    said = replace(one.findings[0], explanation="A leg that was held resists.")
    one = replace(one, findings=[said], reasons=["the leg moves"], advice=["Hold the hanging leg."])
    assert in_own_words(one) is one
    own = in_own_words(replace(one, location=replace(one.location, rig=True)))
    words = " ".join(sentences(own).values())
    assert "A rig that was held resists." in words
    assert (own.reasons, own.advice) == (["the rig moves"], ["Hold the hanging rig."])
    assert "the hanging rig" in words


def test_what_was_missing_and_how_sure_what_it_changed_and_what_remains_come_first():
    one = found()
    said = sentences(one)
    assert list(said)[:4] == ["Missing", "How sure", "Changed", "Remains"]
    assert "explanations with it hold 99.2% of the weight; " in said["How sure"]
    assert "with segments drawn anew, 95% say the same" in said["How sure"]
    assert "or instead quadratic drag + gyro scale: this recording cannot tell;" in said["How sure"]
    # squares over the floor of 0.8 mrad: (1 - 0.64) of (400 - 0.64) mrad^2, over both segments
    assert "0% of the squares that were missing" in said["Remains"]
    assert "-> 0.0" in said["Remains"]


def test_what_may_act_besides_is_apart_from_what_it_may_be_instead():
    two = ["coulomb_friction + gyro_scale", "coulomb_friction + encoder_gain"]
    one = replace(found(), equivalent=[*two, "stribeck_friction"])
    said = sentences(one)["How sure"]
    assert (
        "besides it perhaps gyro scale, or encoder gain; or instead stribeck friction: this "
        "recording cannot tell;"
    ) in said


@pytest.mark.parametrize(
    ("named", "twin", "title"),
    [
        ("stiffness_rest_angle", "torque_bias", "constant torque"),
        ("gyro_scale", "clock_rate", "rate of the clock"),
    ],
)
def test_what_is_the_same_in_every_recording_is_no_doubt(named, twin, title):
    (cause,) = found().findings
    one = replace(found(), findings=[replace(cause, name=named)], equivalent=[named, twin])
    said = sentences(one)
    assert said["Missing"].endswith(f"; or {title}, which would look exactly alike")
    assert verdict(one).endswith(f", or {title}")
    assert "cannot tell" not in said["How sure"]


@pytest.mark.parametrize("named", ["stiffness_rest_angle", "torque_bias", "coulomb_friction"])
def test_a_constant_torque_beside_measured_ones_may_be_the_zero_of_their_sensor(named):
    """What acts is what is measured less what is shown of none, in every sample; of drops nothing
    is measured.
    """
    one, (cause,) = found(), found().findings
    driven = [replace(each, kind="measured") for each in one.before.segments]
    steady = replace(one, findings=[replace(cause, name=named)])
    moved = replace(steady, before=replace(one.before, segments=driven))
    mixed = replace(steady, before=replace(one.before, segments=[*driven, *one.before.segments]))
    zero = "or a torque sensor whose zero is off by as much"
    constant = named != "coulomb_friction"
    assert (f"; {zero}, which would look exactly alike" in sentences(moved)["Missing"]) == constant
    assert verdict(moved).endswith(f", {zero}") == constant
    for each in (steady, mixed):
        assert "torque sensor" not in sentences(each)["Missing"] + verdict(each)


def test_a_suspected_constant_torque_beside_measured_ones_may_be_the_zero_of_their_sensor():
    one = doubtful()
    driven = [replace(each, kind="measured") for each in one.before.segments]
    moved = replace(one, before=replace(one.before, segments=driven))
    zero = "A constant torque is here as a torque sensor whose zero is off: read it with nothing"
    for terms, told in ((["coulomb_friction"], False), (["gyro_scale", "torque_bias"], True)):
        suspected = [Suspect(terms, [])]
        said = sentences(replace(moved, suspected=suspected))["Suspected"]
        assert (zero in said) == told
        assert zero not in sentences(replace(one, suspected=suspected))["Suspected"]


def test_a_number_that_is_smaller_than_its_error_is_no_size():
    wide = Parameter("torque_bias.bias", -0.2, "N m", 1.3)
    assert parameter(wide) == "bias not determined (± 1.3 N m)"


def test_a_number_that_is_told_to_be_nothing_is_determined():
    """A step of 0.06 mrad, where a strap that slips moves an encoder by 10 mrad."""
    step = Parameter("zero_drift.step", 1.4e-5, "rad", 1.9e-5)
    assert parameter(step) == "step 0 within ± 0.0011 deg"


def test_an_exact_twin_is_told_with_its_size():
    (cause,) = found().findings
    sizes = [
        Parameter("stiffness_rest_angle.rest_angle", 0.52, "rad", 0.01),
        Parameter("torque_bias.bias", 1.56, "N m", 0.16),
        Parameter("torque_bias.bias_over_inertia", 3.84, "1/s^2", 0.05),
    ]
    alike = ["stiffness_rest_angle", "torque_bias"]
    named = replace(cause, name=alike[0])
    one = replace(found(), findings=[named], equivalent=alike, parameters=sizes[:1])
    said = sentences(replace(one, twins=sizes[1:]))["Missing"]
    twin = "constant torque, bias 1.56 ± 0.16 N m, bias / J 3.840 ± 0.050 1/s^2"
    assert said.endswith(f"; or {twin}, which would look exactly alike")


def test_a_reflex_is_later_than_its_delay():
    (cause,) = found().findings
    delay = Parameter("stretch_reflex.delay", 0.0134, "s", 0.0006)
    one = replace(found(), findings=[replace(cause, name="stretch_reflex")], parameters=[delay])
    said = sentences(one)["Missing"]
    assert "delay 0.01340 ± 0.00060 s" in said
    assert "after the delay and the rise time together" in said


def printed(one) -> str:
    console = Console(width=300, file=StringIO())
    print_diagnosis(one, console)
    return console.file.getvalue()


def test_where_nobody_can_tell_the_leg_has_numbers_with_errors():
    said = printed(doubtful())
    assert "The leg, by Eq. 9 alone" in said
    known = {name: one for name, one in doubtful().before.ratios.items() if one.value is not None}
    for one in known.values():
        row = next(line for line in said.splitlines() if f" {one.symbol} " in line)
        assert written(one) in row
    assert known
    lost = replace(doubtful(), before=replace(doubtful().before, astray="it misses the angle"))
    assert "The leg, by Eq. 9 alone" not in printed(lost)
    assert "the leg has no numbers with errors here" in printed(lost)


def test_suspects_are_told_with_their_sizes():
    sizes = [Parameter("torque_bias.bias", -1.75, "N m", 0.02)]
    one = Suspect(["torque_bias"], NUMBERS, sizes)
    assert "As large as: torque bias: bias -1.750 ± 0.020 N m" in printed(
        with_inertia(INERTIA, suspected=[one], verdict="cannot_tell")
    )
    assert "As large as" not in printed(
        replace(doubtful(), suspected=[replace(one, parameters=[])])
    )


def test_a_formula_of_half_a_torque_is_not_that_torque():
    one = novel()
    assert one.formula is not None
    whole, half = one, replace(one, formula=replace(one.formula, explained=0.54))
    assert sentences(half)["Missing"].endswith("which leaves only noise")  # where it runs free
    half = replace(half, best=replace(half.best, mean_square=3.0))
    assert sentences(whole)["Missing"].startswith("tau = 0.2 sin(8 x) N m")
    assert "no short formula" in sentences(half)["Missing"]
    assert sentences(half)["Missing"].endswith("explains only 54% of its variance")


def test_a_formula_says_from_when_its_time_counts_where_it_has_one():
    one = novel()
    assert one.formula is not None
    fading = replace(one.formula, words="tau = 1.9 exp(-t/0.7 s) N m")
    told = sentences(replace(one, formula=fading))["Missing"]
    assert "t in s from a segment's first fitted sample on" in told
    assert "t in s" not in sentences(one)["Missing"]


@pytest.mark.parametrize("verdict", ["none", "mismatch", "cannot_tell"])
def test_a_leg_that_hardly_any_body_has_is_told_with_every_verdict(verdict):
    one = replace(found(), verdict=verdict)
    assert "The leg" not in sentences(one)
    heavy = replace(INERTIA, value=0.9, expected=0.45, expected_deviation=0.05)
    before = replace(one.before, parameters={**one.before.parameters, "inertia": heavy})
    said = sentences(replace(one, before=before))["The leg"]
    assert "J = 0.9 kg m^2, 2 times what anatomy expects" in said


def with_inertia(known, **more):
    """A diagnosis of which the fits know that of J."""
    one = found()
    fit = replace(one.before, parameters={**one.before.parameters, "inertia": known})
    return replace(one, before=fit, **more)


RATIO = Booked("damping_over_inertia", 1.06, 1.05, "1/s")
NUMBERS = [
    Booked("gravity_over_inertia", 18.2, 27.6, "1/s^2"),
    RATIO,
    Booked("damping", 0.862, 0.39, "N m s/rad"),
]


@pytest.mark.parametrize("known", [BY_PRIOR, BY_BOTH, UNTOLD])
def test_what_changed_is_told_over_an_inertia_that_each_model_takes_from_tables(known):
    """Else damping fell by half because another J was expected."""
    one = with_inertia(known, booked=NUMBERS)
    assert sentences(one)["Changed"] == "m l g / J 18.2 -> 27.6 1/s^2."
    same = with_inertia(known, booked=[RATIO, *NUMBERS[2:]])
    assert sentences(same)["Changed"] == "nothing: d / J changed by less than 1 %."


@pytest.mark.parametrize("known", [INERTIA, BY_HAND])
def test_what_changed_is_told_of_the_leg_where_its_inertia_is_known(known):
    one = with_inertia(known, booked=NUMBERS)
    assert sentences(one)["Changed"] == "damping 0.862 -> 0.39 N m s/rad."
    old = with_inertia(BY_PRIOR, booked=NUMBERS[2:])  # of a file without ratios
    assert sentences(old)["Changed"] == "damping 0.862 -> 0.39 N m s/rad."


def test_no_number_of_a_guessed_inertia_is_in_any_word_or_table():
    suspect = Suspect(["x"], [Booked("inertia", 0.45, 0.46, "kg m^2"), *NUMBERS])
    one = with_inertia(UNTOLD, booked=NUMBERS, suspected=[suspect])
    assert suspects(one).rows == [
        ("gravity / J", "18.2", "27.6", "1/s^2"),
        ("damping / J", "1.06", "1.05", "1/s"),
    ]
    assert [row[0] for row in suspects(with_inertia(INERTIA, suspected=[suspect])).rows] == [
        "inertia",
        "gravity / J",
        "damping / J",
        "damping",
    ]
    assert "level / J 0.2222 ± 0.0044 1/s^2" in sentences(one)["Missing"]  # 0.1 N m / 0.45 kg m^2
    assert not any("N m" in line or "kg m^2" in line for line in sentences(one).values())


def test_a_formula_is_over_an_inertia_that_nobody_knows():
    torque = NovelTorque(
        "tau = 0.2 sin(8 x) N m", 0.97, 0.3, None, "tau / J = 0.4 sin(8 x) rad/s^2"
    )
    one = replace(novel(), formula=torque)
    guess = replace(one, before=with_inertia(UNTOLD).before)
    assert "tau / J = 0.4 sin(8 x) rad/s^2 (x in rad, v in rad/s)" in sentences(guess)["Missing"]
    assert "tau = 0.2 sin(8 x) N m (x in rad, v in rad/s; for J" in sentences(one)["Missing"]


def test_what_acts_once_in_each_segment_may_go_with_a_place_or_with_a_moment():
    """As a catch in spasticity: the leg comes to its angle a little later in the larger drops."""
    kick = NovelTorque("tau = 7.7 kick(t, 0.41 s, 0.053 s) N m", 0.96, 0.0, (0.31, 0.52))
    novel_one = replace(novel(), formula=kick)
    place = novel_one.location
    lone = replace(novel_one, location=replace(place, missing=place.missing[:1]))
    assert "once, from 0.31 to 0.52 s" in sentences(lone)["Missing"]
    several = replace(lone, location=replace(place, missing=place.missing[:1] * 3))
    said = sentences(several)["Missing"]
    assert "once in each segment, from 0.31 to 0.52 s" in said
    assert "when the leg first passes a place" in said


def test_a_notebook_shows_a_torque_over_an_inertia_that_nobody_knows():
    assert "coulomb_friction.level / J = 0.2222 ± 0.0044 1/s^2" in repr(with_inertia(UNTOLD))
    assert "coulomb_friction.level = 0.1 ± 0.002 N m" in repr(found())
    assert "1/s^2" in with_inertia(UNTOLD)._repr_html_()


def test_what_cannot_be_excluded_is_no_reason_why_nothing_is_missing():
    none = replace(nothing(), reasons=["± of d / J covers what this recording cannot exclude"])
    said = sentences(none)
    assert "Why" not in said
    assert said["Note"].endswith("cannot exclude.")


def test_a_diagnosis_does_not_ask_for_a_diagnosis():
    advice = "check units and signs" + ASK_DIAGNOSE
    lost = replace(found().before, astray="it misses the angle", notes=[f"{advice}."])
    assert "exoid diagnose" in astray(lost)
    assert astray(lost, diagnosed=True) == "Check units and signs."


def test_what_lacks_nothing_but_its_begins_blames_no_sensor_and_names_no_place():
    said = sentences(replace(doubtful(), best=doubtful().baseline, but_ends=True, sensors=[]))
    assert "Where" not in said
    ends = replace(doubtful(), but_ends=True)
    assert headline(ends).startswith("Nothing is missing but where")
    cut = [replace(each, left_out=0.5) for each in ends.before.segments]
    kept_back = replace(ends, before=replace(ends.before, segments=cut))
    assert headline(kept_back).startswith("Nothing is missing but in the first swing")
    assert headline(doubtful()) == "Cannot tell from this recording."


@pytest.mark.parametrize("listed", [True, False])
def test_the_best_candidate_is_listed_once_whichever_way_led_to_it(listed):
    best, other = found().singles
    again = [replace(best, evidence=4.9e3, chosen=False)] if listed else []
    each = ran_free(replace(found(), singles=[*again, other], pairs=[]))
    assert sorted(one.terms for one in each) == [best.terms, other.terms]


def test_friction_beside_a_constant_torque_may_be_friction_that_differs_by_direction():
    """Of 1.2 N m towards extension and 2.0 N m towards flexion, say."""
    one, (cause,) = found(), found().findings
    friction = Parameter("coulomb_friction.level", 1.6, "N m", 0.03)
    pull = Parameter("torque_bias.bias", 0.4, "N m", 0.04)
    both = [cause, replace(cause, name="torque_bias")]
    said = sentences(replace(one, findings=both, parameters=[friction, pull]))["Missing"]
    assert "differs by direction, 1.200 ± 0.050 N m towards extension and 2.000 ± 0.050 N m" in said
    stronger = replace(pull, value=-2.0)  # would push what moves
    for parameters in ([friction], [pull], [friction, stronger]):
        said = sentences(replace(one, findings=both, parameters=parameters))["Missing"]
        assert "differs by direction" not in said


def test_the_reason_of_a_gyros_scale_names_the_clock_that_looks_exactly_alike():
    gyro = Finding("gyro_scale", GyroScale.title, GyroScale.explanation, GyroScale.reference)
    one = replace(found(), findings=[gyro], equivalent=["gyro_scale", "clock_rate"])
    said = sentences(one)["Reason"]
    clock = f" Or ({ClockRate.title}): {ClockRate.explanation}"
    assert said == GyroScale.explanation + clock
    assert clock not in sentences(replace(one, equivalent=["gyro_scale"]))["Reason"]


def test_a_cause_that_is_in_all_explanations_heads_what_cannot_be_told():
    one = replace(doubtful(), in_all=["coulomb_friction"])
    title = CoulombFriction.title
    assert headline(one).startswith(f"{title[0].upper()}{title[1:]} is in all that explains it;")
    assert headline(doubtful()) == "Cannot tell from this recording."


def test_a_formula_that_is_a_simple_torque_has_its_name_and_its_reason():
    """`exoid effects fading_torque` printed the very formula that "the library does not know"."""
    torque = NovelTorque("tau = 2.9 exp(-t/2.5 s) N m", 1.0, 0.0, simple="fading_torque")
    one = replace(novel(), formula=torque)
    assert headline(one) == "Something is missing: a torque that fades after the release."
    assert sentences(one)["Missing"].startswith("a torque that fades after the release: tau = 2.9")
    assert (
        sentences(one)["Reason"]
        == "A muscle, or what held the leg, lets go only after the release."
    )
    assert headline(novel()) == "Something is missing that the library does not know."


def test_what_pushes_alike_is_one_suspect_with_both_names():
    """No recording tells a constant torque from a spring that is slack elsewhere."""
    bias, rest, cubic = "torque_bias", "stiffness_rest_angle", "slack_cubic_stiffness"
    named = "torque bias or, exactly alike, stiffness rest angle"
    assert by_push([[bias], [cubic]], [bias, cubic, rest]) == [named, "slack cubic stiffness"]
    assert by_push([[bias], [rest]], []) == [named]
    assert by_push([[bias], [cubic]], [bias]) == ["torque bias", "slack cubic stiffness"]


def test_without_a_gyro_no_sensors_differ():
    nowhere = replace(found().location, regions=[])
    both, alone = (
        replace(found(), location=nowhere, sensors=some) for some in (found().sensors, [])
    )
    assert "the sensors differ" in sentences(both)["Where"]
    assert "out of the noise: it is spread thinly, or acts for moments" in sentences(alone)["Where"]
