"""What is handed on is the fit: its motion, added mass and clock, and what it is not sure of."""

import re
import xml.etree.ElementTree as Tree
from dataclasses import replace

import jax.numpy as jnp
import mujoco
import numpy as np
import pytest
from engine import play
from joints import SIMULATED, played, run

import exoid
from exoid.interchange.model.gather import gather
from exoid.physics.leg import LegModel
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque

SAME = 1e-9  # rad: two programs add the same numbers in another order
SEGMENTS = (0, 1, 2)  # a drop, one with a known mass, a cycle


@pytest.mark.parametrize("number", SEGMENTS)
def test_the_script_replays_every_segment_as_it_was_fitted(fitted, number):
    segment = fitted.segments[number]
    script = run(exoid.export(fitted, "python", segment=number).text)
    motion = script["simulate"](gather(fitted, number).times)
    assert np.abs(motion[:, 3] - segment.simulated_angle).max() < SAME
    assert np.abs(motion[:, 4] - segment.simulated_velocity).max() < SAME
    assert script["simulate"]().shape == motion.shape


@pytest.mark.parametrize("number", SEGMENTS)
def test_mujoco_replays_every_segment_within_a_tenth_of_its_noise(fitted, number):
    segment, joint = fitted.segments[number], gather(fitted, number)
    found = play(exoid.export(fitted, "mjcf", segment=number).text, joint.times)
    shown = found[:, 0] + joint.sensing.zero
    assert np.abs(shown - segment.simulated_angle).max() < 0.1 * segment.angle_noise


def test_a_bare_leg_is_exported_unless_a_segment_is_asked_for(fitted):
    bare, loaded = (
        mujoco.MjModel.from_xml_string(exoid.export(fitted, "mjcf", segment=number).text)
        for number in (None, 1)
    )
    added = fitted.segments[1].conditions
    assert added.added_mass == pytest.approx(1.0, rel=0.05)
    mass = bare.body("shank").mass[0]
    assert mass == pytest.approx(float(fitted.leg.mass), rel=1e-9)
    assert loaded.body("shank").mass[0] == pytest.approx(mass + added.added_mass, rel=1e-9)
    data = [mujoco.MjData(each) for each in (bare, loaded)]
    inertias = []
    for model, each in zip((bare, loaded), data, strict=True):
        mujoco.mj_forward(model, each)
        inertias.append(float(each.qM[0]) if hasattr(each, "qM") else float(each.M[0]))
    wanted = float(fitted.leg.inertia)
    assert inertias == pytest.approx([wanted, wanted + added.added_inertia], rel=1e-9)
    said = exoid.export(fitted, "mjcf", segment=1).text
    assert "with the added mass of" in said


def test_a_cycle_is_driven_only_as_its_own_segment(fitted):
    assert mujoco.MjModel.from_xml_string(exoid.export(fitted, "mjcf").text).nnumeric == 0
    driven = mujoco.MjModel.from_xml_string(exoid.export(fitted, "mjcf", segment=2).text)
    time, torque = (driven.numeric(f"drive_{each}").data for each in ("time", "torque"))
    amplitude = abs(fitted.segments[2].torque_amplitude.value)
    assert np.abs(torque).max() == pytest.approx(amplitude, rel=2e-3)  # between its samples
    assert time[-1] == pytest.approx(fitted.segments[2].time[-1], rel=1e-4)


def test_a_drive_that_nothing_determines_is_said_to_be_none(fitted):
    """As of a cycle that the simulation does not follow."""
    drop, loaded, cycle = fitted.segments
    lost = replace(cycle.torque_amplitude, value=None, reason="it is not followed")
    told = replace(fitted, segments=[drop, loaded, replace(cycle, torque_amplitude=lost)])
    said = "Its drive is not determined: it is not followed."
    assert said in gather(told, 2).title
    assert said not in (*gather(told, 1).title, *gather(fitted, 2).title)


@pytest.mark.parametrize("form", ["mjcf", "urdf", "osim", "c", "python"])
def test_a_saved_fit_gives_the_very_same_file(fitted, form, tmp_path):
    exoid.save_result(fitted, tmp_path / "fit.nc")
    loaded = exoid.load_result(tmp_path / "fit.nc").result
    assert exoid.export(loaded, form, segment=1) == exoid.export(fitted, form, segment=1)


@pytest.mark.parametrize("form", ["mjcf", "urdf", "osim", "c", "python"])
def test_every_file_says_error_unit_and_who_told_each_number(fitted, form):
    text = exoid.export(fitted, form).text
    for each in (*fitted.parameters.values(), *fitted.terms["quadratic_drag"].values()):
        if each.symbol.endswith("/ J") or each.standard_error is None:
            continue
        assert f"± {each.standard_error:.2g} {each.unit}, {each.set_by}" in text, each.symbol


def test_the_clock_of_the_recording_is_no_clock_of_the_leg(fitted):
    """By a recorded second that is 1.02 s long the leg swings as the term of that clock has it."""
    rate, first = 0.02, fitted.segments[0]
    begun = replace(first.conditions, clock=rate)
    changed = replace(
        fitted, segments=[replace(first, conditions=begun)], fitted_terms=(), terms={}
    )
    joint = gather(changed, 0)
    assert joint.times[-1] == pytest.approx(1.02 * first.time[-1])
    term = ClockRate(jnp.asarray(rate))
    model = LegModel(fitted.leg, NoTorque(), jnp.asarray(begun.thigh_angle), (term,))
    start = LegState(jnp.asarray(begun.angle), jnp.asarray(begun.angular_velocity))
    motion = SIMULATED(model, start, jnp.asarray(first.time))
    assert np.abs(played(joint)[:, 1] - motion.angle).max() < SAME
    right = replace(first, conditions=replace(begun, clock=0.0))
    as_term = replace(changed, segments=[right], fitted_terms=(term,))
    assert np.abs(played(gather(as_term, 0))[:, 1] - motion.angle).max() < SAME


def test_what_cannot_be_handed_on_is_said_in_a_sentence(fitted):
    with pytest.raises(ValueError, match="no segment 3: the fit has the segments 0 to 2"):
        exoid.export(fitted, "mjcf", segment=3)
    with pytest.raises(ValueError, match="fitted alone there: it holds no one model"):
        exoid.export(replace(fitted, leg=None), "mjcf")
    older = [replace(each, conditions=None) for each in fitted.segments]
    with pytest.raises(ValueError, match="older exoid, which did not keep how its segments"):
        exoid.export(replace(fitted, segments=older), "mjcf")


def test_what_no_number_rests_on_is_warned_of(fitted):
    inertia = replace(fitted.parameters["inertia"], value=None, standard_error=None)
    unknown = replace(fitted, parameters={**fitted.parameters, "inertia": inertia})
    (scale,) = exoid.export(unknown, "mjcf").warnings
    assert scale.startswith("nothing told m, J and l: the file holds a leg that moves alike")
    assert "told by nothing" in exoid.export(unknown, "mjcf").text
    with pytest.raises(ValueError, match="every torque of a C header would be off by one unknown"):
        exoid.export(unknown, "c")
    with pytest.raises(ValueError, match=r"\(it misses\): none of its numbers is to be used"):
        exoid.export(replace(fitted, astray="it misses"), "mjcf")
    assert exoid.export(fitted, "mjcf").warnings == ()


NASTY = 'a"""b\\--->c*/ "-\x1b[2J\n--x'


def test_no_name_of_a_file_breaks_out_of_a_comment(fitted, tmp_path):
    first = replace(fitted.segments[0], name=NASTY)
    named = replace(fitted, segments=[first, *fitted.segments[1:]])
    for form in ("mjcf", "urdf", "osim"):
        Tree.fromstring(exoid.export(named, form).text.encode())
    assert run(exoid.export(named, "python").text)["MASS"] == float(fitted.leg.mass)
    code = re.sub(r"/\*.*?\*/", "", exoid.export(named, "c").text, flags=re.DOTALL)
    assert code.lstrip().startswith("#ifndef EXOID_LEG_H")
    for form in ("mjcf", "urdf", "osim", "python", "c"):
        assert "\x1b" not in exoid.export(named, form).text


def diagnosed(verdict, before, after) -> exoid.Diagnosis:
    """A diagnosis of which nothing else is read."""
    made = object.__new__(exoid.Diagnosis)
    for name, value in (("verdict", verdict), ("before", before), ("after", after)):
        object.__setattr__(made, name, value)
    return made


def test_a_diagnosis_that_cannot_tell_gives_the_fit_without_terms_and_says_so(fitted):
    (said,) = exoid.export(diagnosed("cannot_tell", fitted, None), "python").warnings
    assert said.startswith("the diagnosis cannot tell what is missing: this is the fit of Eq. 9")
    sure = diagnosed("mismatch", replace(fitted, leg=None), fitted)
    assert exoid.export(sure, "python") == exoid.export(fitted, "python")


def ratios_in(text: str) -> dict[str, float]:
    """Every line like `..., c / J = 6.19 ...` of a comment."""
    found = re.findall(r", (\S.*? / J) = (\S+)", text)
    return {name: float(value) for name, value in found}


@pytest.mark.parametrize("form", ["mjcf", "urdf", "osim", "c"])
@pytest.mark.parametrize("number", [None, *SEGMENTS])
def test_the_ratios_in_a_comment_are_those_of_its_own_numbers(fitted, form, number):
    leg = gather(fitted, number).constants
    found = ratios_in(exoid.export(fitted, form, segment=number).text)
    named = {"m l g / J": "gravity", "c / J": "stiffness", "d / J": "damping"}
    wanted = {symbol: leg[name] / leg["inertia"] for symbol, name in named.items()}
    assert found == pytest.approx(wanted, rel=1e-5)  # and no mean over several cycles


def test_a_term_is_told_over_inertia_too_where_that_is_known_better(fitted):
    own = fitted.terms["quadratic_drag"]
    name = "coefficient_over_inertia"
    told = {**own, name: replace(own[name], value=0.05, standard_error=0.001)}
    found = replace(fitted, terms={"quadratic_drag": told})
    assert "b / J = 0.05 ± 0.001 1/rad" in exoid.export(found, "c").text
    added = fitted.segments[1].conditions.added_inertia
    share = fitted.leg.inertia / (fitted.leg.inertia + added)
    loaded = f"b / J = {0.05 * float(share):.6g} 1/rad, with the added mass"
    assert loaded in exoid.export(found, "c", segment=1).text


def test_the_torque_of_gravity_has_an_error_of_its_own(fitted):
    """m and l are anatomy's, to percents; their product goes with J, which the known mass tells."""
    text = exoid.export(fitted, "c").text
    value, error = re.search(
        r"#define EXOID_LEG_GRAVITY (\S+)f /\* m l g: ± (\S+) N m, ", text
    ).groups()
    inertia, ratio = fitted.parameters["inertia"], fitted.ratios["gravity_over_inertia"]
    share = np.hypot(inertia.standard_error / inertia.value, ratio.standard_error / ratio.value)
    assert float(error) == pytest.approx(share * float(value), rel=0.06)  # two digits of it
    mass = fitted.parameters["mass"]
    assert share < 0.3 * mass.standard_error / mass.value
    assert "all that is in N m, go with J and share its error" in text


@pytest.mark.parametrize("form", ["mjcf", "urdf", "osim", "c", "python"])
def test_what_a_slack_spring_leaves_open_stands_beside_the_error_of_its_number(fitted, form):
    named = {"inertia": 0.0971, "stiffness": 1.23}
    parameters = fitted.parameters | {
        name: replace(fitted.parameters[name], if_slack=more) for name, more in named.items()
    }
    moment = replace(fitted.gravity_moment, if_slack=0.456)
    leaning = replace(fitted, parameters=parameters, gravity_moment=moment)
    text, plain = exoid.export(leaning, form).text, exoid.export(fitted, form).text
    for more, unit in (("0.097", "kg m^2"), ("1.2", "N m/rad"), ("0.46", "N m")):
        assert f" (± {more} if slack) {unit}, " in text
    assert "'if slack' is an error more, for a knee's spring that is slack elsewhere" in text
    assert "if slack" not in plain


def test_what_a_slack_spring_leaves_open_is_of_the_same_share_with_a_mass_on_the_leg(fitted):
    leaning = replace(
        fitted,
        parameters=fitted.parameters
        | {"inertia": replace(fitted.parameters["inertia"], if_slack=0.1)},
        gravity_moment=replace(fitted.gravity_moment, if_slack=1.0),
    )
    for number in SEGMENTS:
        bare, loaded = gather(leaning, None), gather(leaning, number)
        for name in ("inertia", "gravity"):
            first, second = (
                next(one for one in (*each.numbers, each.gravity) if one.name == name)
                for each in (bare, loaded)
            )
            assert second.if_slack / second.value == pytest.approx(first.if_slack / first.value)
            assert second.error / second.value == pytest.approx(first.error / first.value)


def test_the_seat_of_the_recording_is_told_and_can_be_another(fitted):
    tilted = replace(fitted.segments[0].conditions, thigh_angle=np.radians(15.0))
    seated = replace(
        fitted, segments=[replace(fitted.segments[0], conditions=tilted), *fitted.segments[1:]]
    )
    assert exoid.export(fitted, "c").warnings == ()
    for form in ("mjcf", "urdf", "osim", "c", "python"):
        (said,) = [each for each in exoid.export(seated, form).warnings if "seat" in each]
        assert said.startswith("it sits as in the recording, the knee 15.0 deg above the hip")
    assert "#ifndef EXOID_LEG_THIGH_ANGLE\n#define EXOID_LEG_THIGH_ANGLE 0.2617" in (
        exoid.export(seated, "c").text
    )


def test_what_is_no_format_is_refused_and_what_was_loaded_is_taken(fitted, tmp_path):
    with pytest.raises(ValueError, match=r"'sdf' is no format .* mjcf, urdf, osim, c, python"):
        exoid.export(fitted, "sdf")
    exoid.save_result(fitted, tmp_path / "fit.nc")
    loaded = exoid.load_result(tmp_path / "fit.nc")
    assert exoid.export(loaded, "mjcf") == exoid.export(fitted, "mjcf")
