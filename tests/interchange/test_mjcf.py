"""MuJoCo, which has an integrator and contacts of its own, replays what was fitted."""

import re

import jax.numpy as jnp
import mujoco
import numpy as np
import pytest
from engine import play
from joints import FLOOR, TERMS, TIMES, case, of_term, usual, with_sensing

from exoid.interchange.formats.c import c
from exoid.interchange.formats.mjcf import mjcf
from exoid.interchange.formats.osim import osim
from exoid.interchange.formats.python import python
from exoid.interchange.formats.urdf import urdf
from exoid.interchange.model.joint import Sensing
from exoid.physics.term import PhysicsTerm
from exoid.physics.torque import CycleTorque

CLOSE = 0.1 * FLOOR  # rad: a tenth of the noise shows in no recording
FINER = 16  # parts of a step: at a turn or a stop the fit's own are off by 0.3 floors
REFUSED = {
    "backlash": "it remembers",
    "hysteresis": "it remembers",
    "load_friction": "it changes with the angle",
    "maxwell_element": "it remembers",
    "moving_base": "it remembers",
    "polycentric_axis": "it hangs on the acceleration",
    "power_drag": "it changes with the speed",
    "shaped_hysteresis": "it remembers",
    "stretch_reflex": "it remembers",
    "stribeck_friction": "it changes with the speed",
}
HELD = [name for name in TERMS if name not in (*REFUSED, "clock_rate")]
IN_WORDS = [name for name in HELD if not issubclass(TERMS[name], PhysicsTerm)]
ABRUPT = ("coulomb_friction", "hard_stop")


@pytest.mark.parametrize("name", HELD)
def test_it_moves_as_the_model_does(name):
    made = of_term(name)
    found = play(mjcf(made.joint).text, made.joint.times)
    motion = made.motion(FINER if name in ABRUPT else 1)
    assert np.abs(found[:, 2] - motion.angle).max() < CLOSE


@pytest.mark.parametrize("name", ["cuff_compliance", "wobbling_mass"])
def test_bodies_that_move_on_the_leg_move_so_in_mujoco(name):
    """Both are rigid bodies with springs: only the integrators differ."""
    made = of_term(name)
    found, motion = play(mjcf(made.joint).text, made.joint.times), made.motion()
    assert np.abs(found[:, 0] - motion.shown_angle).max() < 0.01 * FLOOR
    assert np.abs(found[:, 1] - motion.shown_velocity).max() < 1e-4


@pytest.mark.parametrize("name", REFUSED)
def test_what_mujoco_has_nothing_for_is_refused_by_name_with_advice(name):
    with pytest.raises(ValueError, match=f"nothing for {name} .*{REFUSED[name]}. Export it for Py"):
        mjcf(of_term(name).joint)


@pytest.mark.parametrize("name", IN_WORDS)
def test_what_only_sensors_show_stands_in_the_comment_and_is_told(name):
    made = mjcf(of_term(name).joint)
    (kept,) = (each for each in made.kept if each.what == name)
    assert kept.how == "in words"
    comment = made.text.partition("<compiler")[0]
    assert f"{name}: {TERMS[name].title}" in comment


@pytest.mark.parametrize("width", [0.04, 0.1, 0.4])
def test_an_end_that_the_motion_never_reached_spoils_nothing_where_it_was(width):
    """There it has any steepness: thousands of N m, which springs have beside the leg's own."""
    made = case(TERMS["end_range_stiffening"](*map(jnp.asarray, (13.0, 0.5, 7.0, width))))
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - made.motion(16).angle).max() < CLOSE


def test_a_push_is_in_time_though_the_clock_has_run_for_weeks(monkeypatch):
    began = 2e6  # s
    later = CycleTorque(*map(jnp.asarray, (-9.5, 1.8, 1 / 1.8, began)))
    monkeypatch.setattr("joints.TIMES", TIMES + began)
    monkeypatch.setattr("joints.PUSH", later)
    made = case(driven=True)
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - made.motion().angle).max() < CLOSE
    ((x, _),) = re.findall("<x>(.*?)</x> (.)", osim(made.joint).text)
    assert (np.diff([float(each) for each in x.split()]) > 0).all()  # else it is not loaded


def test_tissue_without_a_weight_has_no_body():
    made = case(TERMS["wobbling_mass"](*map(jnp.asarray, (0.0, 0.2, 3.0, 0.2))))
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - made.motion().angle).max() < CLOSE


def test_several_terms_add_up():
    names = ("cubic_stiffness", "quadratic_drag", "torque_bias", "stiffness_rest_angle")
    made = case(*(usual(TERMS[name]) for name in (*names, "end_range_stiffening")))
    found, motion = play(mjcf(made.joint).text, made.joint.times), made.motion()
    assert np.abs(found[:, 2] - motion.angle).max() < CLOSE


def test_masses_and_inertia_are_the_legs():
    made = case()
    model = mujoco.MjModel.from_xml_string(mjcf(made.joint).text)
    shank, leg = model.body("shank"), made.joint.value
    distance, central = shank.ipos[0], shank.inertia[1]
    assert shank.mass[0] == pytest.approx(leg["mass"], rel=1e-9)
    assert distance == pytest.approx(leg["com_distance"], rel=1e-9)
    about_knee = central + shank.mass[0] * distance**2
    assert about_knee == pytest.approx(leg["inertia"], rel=1e-9)


def test_the_noise_of_the_recording_is_the_sensors():
    made = with_sensing(case(), Sensing(zero=0.02, angle_noise=1e-3, rate_noise=4e-3))
    model = mujoco.MjModel.from_xml_string(mjcf(made.joint).text)
    assert model.sensor("encoder").noise[0] == pytest.approx(1e-3)
    assert model.sensor("gyro").noise[0] == pytest.approx(4e-3)
    assert "encoder of the recording: angle + 0.02 rad" in mjcf(made.joint).text


def test_an_approximation_states_its_error_and_keeps_it():
    made = of_term("end_range_stiffening")
    (kept,) = (each for each in mjcf(made.joint).kept if each.what == "end_range_stiffening")
    assert kept.how == "approximate"
    stated = float(kept.where.partition("within ")[2].partition(" N m")[0])
    model = mujoco.MjModel.from_xml_string(mjcf(made.joint).text)
    data, (term,) = mujoco.MjData(model), made.model.terms
    off = []
    for angle in np.linspace(-2.7, 0.3, 301):
        data.qpos[0], data.qvel[0] = angle, 0.0
        mujoco.mj_forward(model, data)
        spring = -made.joint.value["stiffness"] * angle
        found = data.qfrc_passive[0] + data.qfrc_actuator[0] - spring
        wanted = -term.extension * np.exp(angle / term.extension_width)
        wanted = wanted + term.flexion * np.exp(-(angle + 2.1) / term.flexion_width)
        off.append(abs(float(found - wanted)))
    assert max(off) <= 1.5 * stated  # which has one digit


@pytest.mark.parametrize("form", [mjcf, osim, urdf, c, python])
@pytest.mark.parametrize("name", ["fatigue", "torque_asymmetry", "torque_harmonic"])
def test_what_changes_a_push_leaves_a_leg_alone_that_nobody_pushes(name, form):
    made = case(usual(TERMS[name]))
    text = form(made.joint).text
    if form is mjcf:
        assert mujoco.MjModel.from_xml_string(text).nnumeric == 0
        found = play(text, made.joint.times)
        assert np.abs(found[:, 2] - made.motion().angle).max() < CLOSE
    assert name in text.lower()
