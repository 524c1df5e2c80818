"""Fits of the bundled example, of blind cases and of measured motions, replayed by MuJoCo."""

from importlib.resources import files

import numpy as np
import pytest
from engine import play
from joints import TERMS, run, usual
from test_mjcf import ABRUPT, FINER, HELD

import exoid
from exoid.interchange.model.gather import gather
from exoid.physics.term import PhysicsTerm
from exoid.twin.motion import Movement
from fit_cases import DROP, recorded

PART = 0.1  # of a noise floor: no recording shows it
LEAST = 1e-6  # rad, or m: what two integrators agree in where a recording has next to no noise
SAME = 1e-9  # rad: the order of additions
DRAWN = 0.01  # of a floor: a measured torque of few samples is a curve to a fit, a line to a script
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
    term, wide = usual(TERMS[name]), Movement(np.radians(-40), 2.3)
    result = exoid.fit(recorded(DROP, wide), terms=(term,), multistart=1)
    for number, segment in enumerate(result.segments):
        joint = gather(result, number)
        found = play(exoid.export(result, "mjcf", segment=number).text, joint.times)
        script = run(exoid.export(result, "python", segment=number).text)
        script["PIECES"] *= 4 * FINER if name in ABRUPT else 1
        motion = script["simulate"](joint.times)
        assert np.abs(found[:, 2] - motion[:, 1]).max() < PART * segment.angle_noise
