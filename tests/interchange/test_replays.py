"""Fits of the bundled example, of blind cases and of measured motions, replayed by MuJoCo."""

from importlib.resources import files

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from engine import play
from joints import TERMS, run, usual
from test_mjcf import ABRUPT, FINER, HELD

import exoid
from exoid.interchange.model.gather import gather
from exoid.physics.leg import LegModel
from exoid.physics.term import PhysicsTerm
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, CYCLE, DROP, leg

PART = 0.1  # of a noise floor: no recording shows it
STRUCK = 0.5  # of one: when a stop's damper sets in is known to a step of either integrator
LEAST = 1e-6  # rad, or m: what two integrators agree in where a recording has next to no noise
SAME = 1e-9  # rad: the order of additions
DRAWN = 0.01  # of a floor: a measured torque of few samples is a curve to a fit, a line to a script
STOP = HardStop(*map(jnp.asarray, (0.03, 1.2, -1.6, 0.3)))  # that the wide drop runs against
QUICK = ("concealed/p0582c.csv", "real/knee-drop.csv")


def check_replays(result: exoid.FitResult) -> None:
    """Every segment, by MuJoCo and by the script."""
    for number, segment in enumerate(result.segments):
        joint, close = gather(result, number), max(PART * segment.angle_noise, LEAST)
        shown = segment.simulated_angle - joint.sensing.zero
        engine = play(exoid.export(result, "mjcf", segment=number).text, joint.times)
        assert np.abs(engine[:, 2] - shown).max() < close, segment.name
        script = run(exoid.export(result, "python", segment=number).text)
        motion = script["simulate"](joint.times)
        same = DRAWN * segment.angle_noise if segment.kind == "measured" else SAME
        assert np.abs(motion[:, 3] - segment.simulated_angle).max() < same, segment.name


def test_the_bundled_example_is_replayed_drops_and_cycles():
    example = files("exoid.example") / "session.blf"
    check_replays(exoid.fit(str(example), multistart=2))


@pytest.mark.parametrize("name", QUICK)
def test_a_blind_case_and_a_measured_knee_are_replayed(shared, name):
    if not (shared / name).is_file():
        pytest.skip(f"{shared / name} is absent")
    check_replays(exoid.fit(shared / name, multistart=2))


@pytest.mark.proof
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("folder", ["concealed", "real"])
def test_every_blind_case_and_measured_motion_is_replayed(shared, folder):
    paths = sorted((shared / folder).glob("*.csv"))
    if not paths:
        pytest.skip(f"{shared / folder} holds no recording")
    for path in paths:
        check_replays(exoid.fit(path, multistart=2))


@pytest.mark.proof
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", [each for each in HELD if issubclass(TERMS[each], PhysicsTerm)])
def test_a_fit_with_every_term_that_mujoco_holds_is_replayed(name):
    term = STOP if name == "hard_stop" else usual(TERMS[name])
    wide = Movement(np.radians(-40), 2.3)
    model = LegModel(leg(), NoTorque(), terms=(term,))
    movements = (DROP, wide, CYCLE) if term.voluntary or name == "fatigue" else (DROP, wide)
    recording = record(model, movements, jax.random.key(0), subject=BODY)
    result = exoid.fit(recording, terms=(term,), multistart=1)
    for number, segment in enumerate(result.segments):
        joint = gather(result, number)
        found = play(exoid.export(result, "mjcf", segment=number).text, joint.times)
        script = run(exoid.export(result, "python", segment=number).text)
        script["PIECES"] *= 4 * FINER if name in ABRUPT else 1
        motion = script["simulate"](joint.times)
        part = STRUCK if name == "hard_stop" else PART
        assert np.abs(found[:, 2] - motion[:, 1]).max() < part * segment.angle_noise
