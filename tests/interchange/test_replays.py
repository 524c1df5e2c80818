"""Fits of the bundled example, of blind cases and of measured motions, replayed by MuJoCo."""

from dataclasses import dataclass
from importlib.resources import files

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from engine import play
from joints import FLOOR, TERMS, run, usual
from scipy.integrate import solve_ivp
from test_mjcf import ABRUPT, FINER, HELD

import exoid
from exoid.interchange.model.gather import gather
from exoid.physics.leg import LegModel
from exoid.physics.term import PhysicsTerm
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, CYCLE, DROP, leg

PART = 0.1  # of a noise floor: no recording shows it
MISSED = 0.01  # of what a fit misses: where it does not follow, noise is no measure of it
STRUCK = 0.5  # of one: when a stop's damper sets in is known to a step of either integrator
LEAST = 1e-6  # rad, or m: what two integrators agree in where a recording has next to no noise
SAME = 1e-8  # rad: the order of additions, and twelve digits of a measured torque
STOP = HardStop(*map(jnp.asarray, (0.03, 1.2, -1.6, 0.3)))  # that the wide drop runs against
QUICK = {"concealed/p2b108.csv": (), "real/knee-drop.csv": ("stiffness_rest_angle",)}


def check_replays(result: exoid.FitResult) -> None:
    """Every segment, by MuJoCo and by the script."""
    for number, segment in enumerate(result.segments):
        joint, missed = gather(result, number), MISSED * segment.angle_rmse
        close = max(PART * segment.angle_noise, missed, LEAST)
        shown = segment.simulated_angle - joint.sensing.zero
        engine = play(exoid.export(result, "mjcf", segment=number).text, joint.times)
        assert np.abs(engine[:, 2] - shown).max() < close, segment.name
        script = run(exoid.export(result, "python", segment=number).text)
        motion = script["simulate"](joint.times)
        assert np.abs(motion[:, 3] - segment.simulated_angle).max() < SAME, segment.name


@dataclass(frozen=True)
class Driven:
    """A pendulum on a spring and a motor of known torque, moved by SciPy."""

    time: np.ndarray  # s
    inertia: float = 0.2  # kg m^2
    spring: float = 0.5  # N m/rad
    quick: float = 2.0  # Hz, the faster of the torque's two tones

    def torque(self, time):
        slow, quick = 2 * np.pi * 0.5, 2 * np.pi * self.quick
        return np.sin(slow * time) + 0.6 * np.sin(quick * time + 1)

    def slope(self, time, state):
        angle, rate = state
        held = 2.0 * np.cos(angle) + self.spring * angle + 0.2 * rate
        return rate, (self.torque(time) - held) / self.inertia

    def recorded(self) -> Recording:
        span = (0.0, self.time[-1])
        moved = solve_ivp(self.slope, span, (-1.4, 0.0), t_eval=self.time, rtol=1e-9, atol=1e-11)
        seen = moved.y[0] + FLOOR * np.random.default_rng(0).standard_normal(self.time.size)
        segment = Segment(self.time, raw_angle=seen, applied_torque=self.torque(self.time))
        sensors = Sensors(angle_noise=FLOOR)
        return Recording((segment,), Subject(kind="rig"), Protocol(kind="measured"), sensors)


EVEN = np.arange(0.0, 8.0, 0.02)
RIGS = {  # of about as many steps, for one program
    "seven samples of a torque's period": Driven(np.arange(0.0, 8.0, 1 / 15)),
    "a gap of 0.3 s": Driven(EVEN[(EVEN < 4) | (EVEN > 4.3)]),
    "ten samples of an oscillation": Driven(np.arange(0.0, 5.0, 0.01), 0.02, 70.0, 9.0),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", RIGS)
def test_a_measured_torque_drives_an_exported_rig_as_it_drove_the_fit(name):
    check_replays(exoid.fit(RIGS[name].recorded(), multistart=2))


def test_the_bundled_example_is_replayed_drops_and_cycles():
    example = files("exoid.example") / "session.blf"
    check_replays(exoid.fit(str(example), multistart=2))


@pytest.mark.parametrize("name", QUICK)
def test_a_blind_case_and_a_measured_knee_are_replayed(shared, name):
    if not (shared / name).is_file():
        pytest.skip(f"{shared / name} is absent")
    check_replays(exoid.fit(shared / name, multistart=2, terms=QUICK[name]))


@pytest.mark.proof
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("folder", ["concealed", "real"])
def test_every_blind_case_and_measured_motion_is_replayed(shared, folder):
    paths = sorted((shared / folder).glob("*.csv"))
    if not paths:
        pytest.skip(f"{shared / folder} holds no recording")
    found = [exoid.fit(path, multistart=2) for path in paths]
    followed = [each for each in found if each.follows]  # of others nothing is exported
    assert followed
    for each in followed:
        check_replays(each)


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
