"""What a fit says of legs whose spring is slack elsewhere than at full extension; by SciPy."""

from dataclasses import replace
from functools import partial

import jax
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.result.mountings import numbers_at
from exoid.fitting.result.remarks.zero.leaning import BENT, LEANING
from exoid.fitting.result.remarks.zero.slack_angle import leaning, likely
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from legs import ADULT, BODY, drop, recording

QUIET, LOUD = (8e-4, 0.0), (0.015, 0.0)  # rad; no gyro


def fitted(slack=0.0, noise=QUIET, leg=ADULT, subject=BODY, **how):
    sensors = Sensors(angle_noise=noise[0])
    made = drop(leg, slack=slack, noise=noise, gyro=False)
    return fit(recording(made, sensors=sensors, subject=subject), multistart=2, **how)


def leans(result, ended=None):
    basis = result.basis
    assert basis is not None
    problem, free = basis.problem, basis.information.open
    return leaning(problem, ended or basis.ended, free, partial(numbers_at, problem))


def noted(result):
    return [each for each in result.notes if "slack at phi_r = -30 deg" in each]


@pytest.fixture(scope="module")
def bent():
    """It looks like Eq. 9 to its sensors, and its ratios are those of another leg."""
    return fitted(-BENT, LOUD)


def test_how_far_off_the_ratios_are_is_told_to_a_tenth(bent):
    found = leans(bent)
    assert found is not None
    for name, true in zip(LEANING, ADULT, strict=False):
        each = bent.ratios[name]
        off = true - each.value
        assert abs(off) > 4 * each.standard_error
        assert found.off[name] == pytest.approx(off, abs=0.1 * abs(off) + each.standard_error)


def test_what_goes_with_the_ratios_is_as_far_off_as_a_fit_that_knows_where_it_is_slack(bent):
    """Anatomy believes of J / (m l): where m l g / J is less, J is more, and d and c with it."""
    angle = {"stiffness_rest_angle.rest_angle": -float(BENT)}
    knowing = fitted(-BENT, LOUD, terms=(StiffnessRestAngle,), fix=angle)
    found = leans(bent)
    assert found is not None
    for name, each in bent.of_leg.items():
        off = knowing.of_leg[name].value - each.value
        assert found.off[name] == pytest.approx(off, rel=0.25, abs=0.3 * each.standard_error)
    for name in ("inertia", "damping", "stiffness"):
        assert found.off[name] > 0
        assert bent.parameters[name].if_slack == pytest.approx(found.spread[name])


def test_what_is_fixed_by_hand_is_not_open():
    found = fitted(-BENT, LOUD, fix={"inertia": 0.4})
    assert found.parameters["inertia"].if_slack is None
    assert found.parameters["stiffness"].if_slack is not None


def test_a_fit_that_cannot_see_it_says_what_it_would_change(bent):
    (said,) = noted(bent)
    found = leans(bent)
    assert found is not None
    gravity, stiffness = found.of_ratios
    assert f"m l g / J is {-gravity:.2g} 1/s^2 lower" in said
    assert f"c / J {stiffness:.2g} 1/s^2 higher" in said
    for name in LEANING:
        assert bent.ratios[name].if_slack == pytest.approx(found.spread[name])
    assert bent.ratios["damping_over_inertia"].if_slack is None


def two_drops(slack, noise, gyro):
    made = [drop(start=at, slack=slack, noise=noise, gyro=gyro) for at in (-0.2, -0.9)]
    sensors = Sensors(angle_noise=noise[0], velocity_noise=noise[1] if gyro else None)
    return fit(recording(*made, sensors=sensors), multistart=2)


def test_a_fit_that_sees_where_it_is_slack_says_how_far_off_the_ratios_may_be():
    """At 10 deg of flexion they are many errors off, which leave that out."""
    found = two_drops(np.radians(-10), (2.6e-3, 0.0), gyro=False)
    where = leans(found)
    assert where is not None
    assert where.told < np.radians(5)
    (said,) = [each for each in found.notes if "it is slack at" in each]
    assert f"m l g / J open by ± {where.spread['gravity_over_inertia']:.2g} 1/s^2" in said
    for name, true in (("gravity_over_inertia", ADULT[0]), ("stiffness_over_inertia", ADULT[1])):
        each = found.ratios[name]
        assert abs(each.value - true) > 5 * each.standard_error
        assert abs(each.value - true) < 2 * np.hypot(each.standard_error, where.spread[name])


@pytest.fixture(scope="module")
def bent_drops():
    return two_drops(np.radians(-35), (8e-4, 3e-3), gyro=True)


def test_the_zero_of_an_encoder_is_open_for_where_the_spring_is_slack(bent_drops):
    """It is 0: the fit makes up for the spring by the encoder's zero and the seat's tilt."""
    (owned,) = bent_drops.mountings
    zero = owned.zero
    assert abs(zero.value) > 3 * zero.standard_error
    assert abs(zero.value) < 2 * np.hypot(zero.standard_error, zero.if_slack)
    found = leans(bent_drops)
    assert zero.if_slack == pytest.approx(found.spread["recording.zero"])


def test_what_is_held_to_what_is_declared_leans_as_little(bent_drops):
    """The seat stays within what is believed of it: the zero cannot have followed a spring farther.

    By white noise alone both would lean by several times as much.
    """
    (owned,) = bent_drops.mountings
    assert owned.zero.if_slack < 4 * abs(owned.zero.value)


def test_a_fit_that_leaves_little_open_says_nothing():
    found = two_drops(0.0, (8e-4, 3e-3), gyro=True)
    assert not [each for each in found.notes if "slack at" in each]
    (owned,) = found.mountings
    told = found.of_leg | found.ratios | owned.known
    assert {each.if_slack for each in told.values()} == {None}


def test_a_fit_whose_residual_shows_it_says_what_it_would_change():
    shown = fitted(-BENT)
    assert shown.disturbance.cause == "torque"
    assert noted(shown)


@pytest.mark.parametrize("tone", [-4.0, -3.0])
def test_a_constant_torque_that_no_slack_spring_of_the_fit_makes_is_in_if_slack(tone):
    """It softens the fit's spring, and so what such a spring would make of the ratios: by that the
    fit said nothing, 5 of its errors off. [1/s^2], over J: 15 % of m l g, as of a muscle; the two
    drops are those of a spring that is slack where its torque is as large.
    """
    leg = (26.8, 2.6, 0.88)
    made = [drop(leg, start=at, slack=tone / leg[1]) for at in (-0.35, -0.8)]
    found = fit(recording(*made), multistart=2)
    for name, true in zip(LEANING, leg, strict=False):
        each = found.ratios[name]
        assert abs(each.value - true) > 3 * each.standard_error
        assert abs(each.value - true) < 2.5 * np.hypot(each.standard_error, each.if_slack or 0.0)
    (said,) = [each for each in found.notes if "no constant torque acts" in each]
    assert "% of m l g towards flexion" in said


def test_a_rig_and_a_leg_without_a_spring_lean_on_none():
    rig = fitted(noise=LOUD, subject=Subject(kind="rig"))
    assert leans(rig) is None
    assert not noted(fitted(noise=LOUD, leg=(27.5, 0.0, 0.8)))


@pytest.mark.parametrize("degrees", [-30.0, -11.5, 0.0, 11.5, 30.0])
def test_where_the_spring_is_slack_is_told_by_the_stiffness_that_it_has_then(degrees):
    """Over the fit's own, which takes its torque for a spring, it would be 15 deg off at 30 deg."""
    found = leans(fitted(np.radians(degrees)))
    assert found is not None
    angle, error = np.degrees(found.rest_angle)
    assert angle == pytest.approx(degrees, abs=max(2 * error, 1.0))


def test_what_it_sees_hangs_not_on_how_exactly_a_fit_has_ended():
    """Where a leg rubs, no fit ends to the last digit."""
    found = two_drops(0.0, (8e-4, 0.0), gyro=False)
    assert found.basis is not None
    ended = found.basis.ended
    point = ended.point
    nearly = replace(
        point.shared, gravity=point.shared.gravity + 1e-3
    )  # 1/s^2, a tenth of an error
    rows = jax.tree.map(lambda leaf: np.asarray(leaf)[None], replace(point, shared=nearly))
    begun = replace(ended, best=replace(ended.best, coordinates=rows))
    exact, rough = leans(found), leans(found, begun)
    assert exact is not None
    assert rough is not None
    assert rough.seen == pytest.approx(exact.seen, abs=0.1 * exact.told)


def test_what_is_told_counts_as_told_and_what_is_not_as_it_usually_is():
    """Of a spring that another torque leaves as stiff as it is."""
    assert likely(4.0, 0.0, shown=-3.0, error=0.01) == pytest.approx(3.0, rel=1e-3)
    assert likely(4.0, 0.0, shown=0.0, error=1e3) == pytest.approx(4.0 * BENT, rel=1e-2)


def test_a_soft_spring_may_hide_a_stiff_one():
    """c / J of 0.9 beside a stiffening end was 3.6 1/s^2, slack at 60 deg: T = -3.8 rad/s^2."""
    soft = likely(0.93, 0.68, shown=-3.4, error=1.34)
    assert soft > 2 * likely(0.93, 0.0, shown=-3.4, error=1.34)
    assert soft > 3.8 / 2


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [-60.0, -30.0, 15.0])
def test_beside_a_stiffening_end_all_sizes_hold_a_spring_that_is_slack_elsewhere(degrees):
    """Both bend the same way: m l g / J, c / J and the width were many errors off."""
    leg, end = (26.5, 3.6, 0.7), (7.2, 0.25)
    how = {"slack": np.radians(degrees), "end": end}
    made = [drop(leg, start, seed=at, **how) for at, start in enumerate((-0.26, -0.7, -1.05))]
    found = fit(recording(*made), multistart=4, terms=[EndRangeStiffening])
    where, each = leans(found), found.ratios | found.of_terms
    assert where is not None
    true = dict(zip(LEANING, leg[:2], strict=True))
    width = "end_range_stiffening.extension_width"
    for name, value in (true | {width: end[1]}).items():
        off = abs(each[name].value - value)
        assert off < 2.5 * np.hypot(each[name].standard_error, where.spread[name])
