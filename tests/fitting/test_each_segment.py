"""Segments fitted alone: the mean of the ratios, its error, and their names."""

from dataclasses import replace

import jax
import numpy as np
import pytest

from exoid.fitting.apart.alone import only
from exoid.fitting.apart.averaged import averaged
from exoid.fitting.apart.fit_each import fit_each
from exoid.fitting.apart.means import mean_ratio
from exoid.fitting.apart.said import of_every_kind
from exoid.fitting.apart.settled import settled_parameters
from exoid.fitting.estimate import fit
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.physics.leg import GRAVITY, LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, CYCLE, DROP, LOADED, leg, recorded

FEW = {"multistart": 4}
OTHER_DROP = Movement(float(np.radians(-30)), DROP.duration)
RATIOS = {
    "gravity_over_inertia": 4.5 * 0.26 * GRAVITY / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
}


@pytest.fixture(scope="module")
def drops():
    return recorded(DROP, OTHER_DROP)


@pytest.fixture(scope="module")
def alone(drops):
    """Each of the two drops by itself."""
    return [fit([("leg", only(drops, number))], **FEW) for number in (0, 1)]


def test_ratios_are_the_mean_of_segments_and_errors_hold_their_scatter(drops, alone):
    found = fit_each([("leg", drops)], **FEW)
    for name in RATIOS:
        values = [each.ratios[name].value for each in alone]
        assert found.ratios[name].value == pytest.approx(np.mean(values), rel=1e-12)
        scatter = abs(values[0] - values[1]) / 2  # s / sqrt(n) of two values
        common = (
            sum(found.ratios[name].limited_by.values()) * found.ratios[name].standard_error ** 2
        )
        assert found.ratios[name].standard_error == pytest.approx(np.hypot(scatter, common**0.5))
    assert [each.name for each in found.segments] == ["0", "1"]
    assert {each.recording for each in found.mountings} == {"0", "1"}
    assert found.loss == pytest.approx(sum(each.loss for each in alone), rel=1e-12)


def test_of_notes_that_differ_in_numbers_alone_the_first_is_kept():
    said = ["noise of 0.12 deg", "noise of 1.5e-3 deg", "segment 0 was cut", "segment 1 was cut"]
    assert of_every_kind(said) == [said[0], *said[2:]]


def test_parameters_keep_the_ratios_that_they_came_from(drops):
    found = fit_each([("leg", drops)], **FEW)
    value = {name: each.value for name, each in found.parameters.items()}
    moment = value["mass"] * value["com_distance"] * GRAVITY
    for name, part in (
        ("gravity_over_inertia", moment),
        ("stiffness_over_inertia", value["stiffness"]),
        ("damping_over_inertia", value["damping"]),
    ):
        assert part / value["inertia"] == pytest.approx(found.ratios[name].value, rel=1e-9)
    assert found.parameters["inertia"].determined_by == "prior"  # each drop knows ratios alone


def test_one_segment_is_fitted_as_ever(alone, drops):
    found = fit_each([("leg", only(drops, 0))], **FEW)
    assert found.ratios == alone[0].ratios
    assert found.parameters == alone[0].parameters


def test_segments_of_two_recordings_are_told_apart(drops):
    names = [("a.csv", only(drops, 0)), ("b.csv", only(drops, 1))]
    assert [each.name for each in fit_each(names, **FEW).segments] == ["a.csv 0", "b.csv 0"]


def test_a_segment_in_which_nothing_moves_is_left_out_by_name(drops):
    still = replace(drops.segments[1], raw_angle=np.full_like(drops.segments[1].time, -0.2))
    still = replace(still, raw_angular_velocity=np.zeros_like(still.time))
    still = replace(still, angle=None, angular_velocity=None, angular_acceleration=None)
    bad = replace(drops, segments=(drops.segments[0], still))
    assert fit_each([("leg", bad)], **FEW).notes[0].startswith("segment 1 was left out")


def test_the_reading_of_the_cycles_is_told_although_the_first_segment_is_a_drop():
    found = fit_each([("leg", recorded(DROP, CYCLE))], **FEW)
    assert found.torque_frequency == "1/T"
    assert "torque_over_inertia" in found.ratios


def test_one_segment_keeps_what_the_sidecar_says_of_it():
    whole = recorded(DROP, LOADED, CYCLE)
    parts = [only(whole, number) for number in range(3)]
    assert [each.added_mass(0) for each in parts] == [0.0, 1.0, 0.0]
    assert [each.kind(0) for each in parts] == ["passive", "passive", "active"]
    assert [each.cycle_period(0) for each in parts] == [None, None, 1.19]
    assert parts[1].added_mass_distance(0) == 0.4


def test_the_mean_of_a_single_value_has_no_error():
    one = Estimate("c / J", "stiffness over inertia", "1/s^2", 6.0, 0.1)
    assert averaged([one], [0]).standard_error is None
    both = averaged([one, replace(one, value=8.0)], [0, 0])
    assert (both.value, both.standard_error) == (7.0, 1.0)


def test_where_one_spring_is_slack_is_not_averaged_away():
    one = Estimate("c / J", "stiffness over inertia", "1/s^2", 5.0, 0.2, if_slack=2.0)
    mean = averaged([one, replace(one, value=5.4, if_slack=3.0)], [0, 0])
    assert mean.if_slack == pytest.approx(2.5)
    assert averaged([replace(one, if_slack=None)] * 2, [0, 0]).if_slack is None


def test_what_segments_have_in_common_is_not_averaged_away_but_between_recordings():
    one = Estimate("c / J", "stiffness over inertia", "1/s^2", 6.0, 0.5, limited_by={"zero": 0.64})
    same = averaged([one, one, one, one], [0, 0, 0, 0])
    assert same.standard_error == pytest.approx(0.4)
    assert same.limited_by == {"zero": pytest.approx(1.0)}
    assert averaged([one, one, one, one], [0, 1, 2, 3]).standard_error == pytest.approx(0.2)
    both = replace(one, limited_by={"clock": 1.0, "gyro_scale": 1.0})
    assert averaged([both, both], [0, 0]).standard_error == pytest.approx(0.5)


def test_a_ratio_that_a_segment_does_not_tell_is_no_part_of_the_mean():
    told = Estimate("d/J", "damping / J", "1/s", 2.0, 0.1)
    untold = replace(told, value=None, standard_error=None)
    assert mean_ratio([told, untold, replace(told, value=4.0)], [0, 0, 0]).value == 3.0
    assert mean_ratio([untold, untold], [0, 0]).value is None


def test_what_no_segment_tells_has_no_say_in_the_parameters(alone):
    ratios = {name: alone[0].ratios[name] for name in RATIOS}
    belief = alone[0].basis.problem.belief
    whole = settled_parameters(belief, ratios, alone[0].leg)
    name = "stiffness_over_inertia"
    lost = ratios | {name: replace(ratios[name], value=None, standard_error=None)}
    part = settled_parameters(belief, lost, alone[0].leg)
    assert part["stiffness"].value is None or part["stiffness"].determined_by == "prior"
    assert part["inertia"].value == pytest.approx(whole["inertia"].value, rel=0.05)


def test_the_leg_of_the_cases_has_these_ratios():
    assert float(leg().stiffness / leg().inertia) == pytest.approx(RATIOS["stiffness_over_inertia"])


@pytest.mark.proof
def test_a_term_is_the_mean_of_the_segments_and_may_be_fixed():
    rubbing = LegModel(leg(), NoTorque(), terms=(CoulombFriction(np.asarray(0.2)),))
    drops = record(rubbing, (DROP, OTHER_DROP), jax.random.key(0), subject=BODY)
    friction = {"terms": (CoulombFriction,), **FEW}
    each = [fit([("leg", only(drops, number))], **friction) for number in (0, 1)]
    found = fit_each([("leg", drops)], **friction)
    name = "level_over_inertia"
    mean = np.mean([one.terms["coulomb_friction"][name].value for one in each])
    own = found.terms["coulomb_friction"]
    assert own[name].value == pytest.approx(mean, rel=1e-12)
    assert own[name].value == pytest.approx(0.2 / 0.42, rel=0.05)
    inertia = found.parameters["inertia"].value
    assert own["level"].value == pytest.approx(own[name].value * inertia, rel=1e-12)
    assert found.model is None
    held = fit_each([("leg", drops)], **friction, fix={"coulomb_friction.level": 0.1})
    level = held.terms["coulomb_friction"]["level"]
    assert (level.value, level.set_by) == (0.1, "fixed by you")
