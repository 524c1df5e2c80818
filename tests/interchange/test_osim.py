"""OpenSim's expressions, evaluated by hand and, where it is installed, by OpenSim."""

import math
import re
import xml.etree.ElementTree as Tree
from functools import partial

import numpy as np
import pytest
from joints import FLOOR, SEGMENT, TERMS, THIGH, case, of_term, usual
from scipy.integrate import solve_ivp

from exoid.interchange.formats.osim import OFF, osim, rubbing
from exoid.interchange.formula.expression import evaluate

CLOSE = 0.1 * FLOOR
EXACTLY = {"method": "DOP853", "rtol": 1e-9, "atol": 1e-10, "max_step": 5e-3}
REMEMBERING = [
    name for name, term in TERMS.items() if "memory" in of_term(name).joint.parts[0].hangs_on
]
RUBBING = ("coulomb_friction", "load_friction", "stribeck_friction")
HELD = [name for name in TERMS if name not in (*REMEMBERING, *RUBBING, "clock_rate")]
WORDS = {
    **{name: getattr(math, name) for name in ("cos", "sin", "exp", "tanh", "sqrt", "log")},
    "abs": abs,
    "max": max,
    "min": min,
    "step": lambda x: float(x >= 0),
}


def spring(stiffness, rest, viscosity, time, angle, rate):
    return -stiffness * (angle - rest) - viscosity * rate


def formula_force(code, time, angle, rate):
    return eval(code, WORDS | {"q": angle, "qdot": rate})


def drive(times, torques, time, angle, rate):
    return np.interp(time, times, torques)


def torques(text: str):
    """Of all generalized forces of a model, by time, angle and rate [N m]."""
    model = Tree.fromstring(text.encode())
    found = []
    for one in model.iter("SpringGeneralizedForce"):
        said = [float(one.findtext(name, "")) for name in ("stiffness", "rest_length", "viscosity")]
        found.append(partial(spring, *said))
    for one in model.iter("ExpressionBasedCoordinateForce"):
        formula = one.findtext("expression", "")
        assert not set(formula) & set(" \n\t")  # OpenSim's parser stops there
        code = compile(formula, "expression", "eval")
        found.append(partial(formula_force, code))
    for one in model.iter("PiecewiseLinearFunction"):
        x, y = (np.array(one.findtext(name, "").split(), float) for name in "xy")
        found.append(partial(drive, x, y))
    return lambda t, q, w: sum(each(t, q, w) for each in found)


def swung(text: str, times: np.ndarray) -> np.ndarray:
    """The angle at `times`, by the numbers of the file alone."""
    model = Tree.fromstring(text.encode())

    def numbers(name: str) -> list[float]:
        return [float(each) for each in (next(model.iter(name)).text or "").split()]

    (mass,), distance, inertia = numbers("mass"), numbers("mass_center")[0], numbers("inertia")[2]
    gravity, tilt, pushed = numbers("gravity")[1], numbers("orientation")[2], torques(text)
    about_knee = inertia + mass * distance**2

    def rate(t, state):
        q, w = state
        weight = mass * distance * gravity * math.cos(q + tilt)
        return [w, (weight + pushed(t, q, w)) / about_knee]

    begin = [*numbers("default_value"), *numbers("default_speed_value")]
    found = solve_ivp(
        rate,
        times[[0, -1]],
        begin,
        t_eval=times,
        method="DOP853",
        rtol=1e-9,
        atol=1e-10,
        max_step=5e-3,
    )
    return found.y[0]


@pytest.mark.parametrize("name", HELD)
def test_its_formulas_move_the_leg_as_the_model_does(name):
    made = of_term(name)
    found = swung(osim(made.joint).text, made.joint.times)
    assert np.abs(found - made.motion(16 if name == "hard_stop" else 1).angle).max() < CLOSE


@pytest.mark.parametrize("name", RUBBING)
def test_dry_friction_is_smoothed_and_said_to_be(name):
    """It lets go later and creeps: less than a floor and a half in two seconds."""
    made = of_term(name)
    found = osim(made.joint)
    (kept,) = (each for each in found.kept if each.what == name)
    assert kept.how == "approximate"
    off = np.abs(swung(found.text, made.joint.times) - made.motion(16).angle).max()
    assert off < 1.5 * FLOOR


def test_the_error_of_smoothed_friction_is_told():
    """What it says of rest is the rate at which it holds with half of its level."""
    joint = of_term("coulomb_friction").joint
    (part,) = joint.parts
    (kept,) = (each for each in osim(joint).kept if "mrad" in each.where)
    assert f"within {1e3 * OFF:g} mrad while it swings" in kept.where
    creep = float(re.search(r"by (\S+) mrad/s", kept.where).group(1)) / 1e3
    held = evaluate(rubbing(part, part.values), {"rate": creep})
    assert held == pytest.approx(-0.5 * part.values["coulomb_friction_level"], rel=0.01)
    assert OFF > 1.5 * FLOOR  # as close as the motions above are


@pytest.mark.parametrize("name", REMEMBERING)
def test_a_term_that_remembers_is_refused_by_name(name):
    with pytest.raises(ValueError, match=f"nothing of {name} .*it remembers. Export it for Python"):
        osim(of_term(name).joint)


def test_opensim_itself_reads_the_file_and_moves_alike(tmp_path):
    opensim = pytest.importorskip("opensim", reason="the package opensim is absent")
    made = case(usual(TERMS["cubic_stiffness"]), driven=True)
    path = tmp_path / "leg.osim"
    path.write_text(osim(made.joint).text, encoding="utf-8")
    model = opensim.Model(str(path))
    state = model.initSystem()
    knee, manager = model.getCoordinateSet().get(0), opensim.Manager(model)
    manager.setIntegratorAccuracy(1e-9)
    manager.initialize(state)
    found = [knee.getValue(state)]
    found += [knee.getValue(manager.integrate(float(t))) for t in made.joint.times[1:]]
    assert np.abs(np.array(found) - made.motion().angle).max() < CLOSE


def test_the_thigh_turns_the_pin_and_the_segment_counts():
    made = of_term("fatigue")
    text = osim(made.joint).text
    assert f"<orientation>0 0 {THIGH}</orientation>" in text
    drift = 0.03 * SEGMENT * made.joint.value["damping"]
    assert torques(text)(5.0, 0.0, 1.0) - torques(text)(5.0, 0.0, 0.0) == pytest.approx(
        -made.joint.value["damping"] - drift, rel=1e-9
    )
