"""What URDF holds is read by the parsers of others; what it does not is told."""

import mujoco
import numpy as np
import pytest
from joints import TERMS as TERMS_OF
from joints import THIGH, case, of_term, usual

from exoid.interchange.formats.urdf import urdf


def test_mujoco_reads_mass_inertia_damping_and_friction():
    made = case(usual(TERMS_OF["coulomb_friction"]))
    model = mujoco.MjModel.from_xml_string(urdf(made.joint).text)
    leg, (term,) = made.joint.value, made.model.terms
    distance = model.body_ipos[-1][0]
    central = model.body_inertia[-1][np.argmax(np.abs(model.body_inertia[-1]))]
    assert model.body_mass[-1] == pytest.approx(leg["mass"], rel=1e-9)
    assert central + leg["mass"] * distance**2 == pytest.approx(leg["inertia"], rel=1e-9)
    assert model.dof_damping[0] == pytest.approx(leg["damping"], rel=1e-9)
    assert model.dof_frictionloss[0] == pytest.approx(float(term.level), rel=1e-9)


def test_mujoco_feels_the_legs_weight_on_its_thigh():
    made = case()
    model = mujoco.MjModel.from_xml_string(urdf(made.joint).text)
    data, leg = mujoco.MjData(model), made.joint.value
    for angle in (-1.3, -0.4, 0.1):
        data.qpos[0] = angle
        mujoco.mj_forward(model, data)
        wanted = leg["gravity"] * np.cos(angle + THIGH)
        assert data.qfrc_bias[0] == pytest.approx(wanted, abs=1e-9)


def test_pinocchio_has_the_same_leg():
    pinocchio = pytest.importorskip(
        "pinocchio", reason="the package pinocchio (pip install pin) is absent"
    )
    made = case(usual(TERMS_OF["coulomb_friction"]))
    model = pinocchio.buildModelFromXML(urdf(made.joint).text)
    data, leg = model.createData(), made.joint.value
    angle, rate, pull = -0.7, 1.1, 3.0
    point = np.array([np.cos(angle), np.sin(angle)]) if model.nq == 2 else np.array([angle])
    torque = pinocchio.rnea(model, data, point, np.array([rate]), np.array([pull]))
    wanted = leg["inertia"] * pull + leg["gravity"] * np.cos(angle + THIGH)
    assert torque[0] == pytest.approx(wanted, rel=1e-6)


def test_stops_become_limits_and_everything_else_is_told():
    made = urdf(of_term("hard_stop").joint)
    assert 'type="revolute"' in made.text
    (kept,) = (each for each in made.kept if each.what == "hard_stop")
    assert kept.how == "approximate"


@pytest.mark.parametrize("name", ["hysteresis", "cubic_stiffness", "load_friction"])
def test_a_term_that_urdf_has_no_place_for_is_in_its_comment_and_warned_of(name):
    made = urdf(of_term(name).joint)
    (warning,) = made.warnings
    assert warning.startswith("Not in this file, but in its comment: stiffness, ")
    assert name in warning
    comment = made.text[: made.text.index("-->")]
    assert f"{name}: {TERMS_OF[name].title}" in comment
