"""Recordings that move faster than a leg are simulated in parts of a sample's step."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.data.observe import is_smooth, observe
from exoid.fitting.data.pace import parts_of, unhurried
from exoid.fitting.data.segment import movement
from exoid.fitting.misfit.residual import predict
from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, Shared, of_segments
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.multistart.beginning.starts import usual_mounting
from exoid.fitting.solve.pose import pose
from exoid.physics.leg import LegModel
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import exact, leg, one, state

RIG = Subject(kind="rig", gravity="none")
RATE, OWN, DRIVEN = 610.0, 2 * np.pi * 68.0, 2 * np.pi * 50.0  # Hz, rad/s: nine samples a period
DAMPING = 20.0  # 1/s
TIME = np.arange(1000) / RATE


def steady(time):
    """What a unit torque per inertia, cos(w t), makes of x'' + d x' + k x in the long run."""
    answer = 1 / (OWN**2 - DRIVEN**2 + 1j * DAMPING * DRIVEN)
    turning = answer * np.exp(1j * DRIVEN * time)
    return turning.real, (1j * DRIVEN * turning).real


def oscillator():
    """In the long run from the first sample on, driven by 1000 rad/s^2 at an inertia of one."""
    angle, velocity = (1e3 * each for each in steady(TIME))
    torque = 1e3 * np.cos(DRIVEN * TIME)
    recording = Recording(
        (Segment(TIME, raw_angle=angle, applied_torque=torque),),
        RIG,
        Protocol(kind="measured"),
        Sensors(angle_noise=1e-6),
    )
    return recording, float(velocity[0])


def simulated(recording, first_velocity):
    movements = [movement(recording, 0, "0")]
    problem = pose(movements, believe(RIG), "1/T", Raw(), owned=())
    own = SegmentUnknowns(
        np.zeros(1), np.array([movements[0].angle[0]]), np.array([first_velocity])
    )
    shared = Shared(np.zeros(()), np.zeros(()), np.array(OWN**2), np.array(DAMPING))
    point = Coordinates(shared, np.zeros(()), usual_mounting(movements, owned=()), own)
    free = jax.tree.map(jnp.asarray, problem.free)
    each = of_segments(point, problem.observation.owner)
    seen = jax.vmap(lambda own, seen: predict(own, seen, free, problem.chain))(
        each, jax.tree.map(jnp.asarray, problem.observation)
    )
    return np.asarray(seen.angle)[0, : TIME.size], problem


def test_nine_samples_a_period_are_simulated_to_a_ten_thousandth():
    """(0.2^4 / 120) a radian over the 40 radians in which the damping forgets would be 5e-4 of a
    free motion; what is driven below its own frequency errs less. One step a sample errs by 40 %.
    """
    recording, velocity = oscillator()
    shown, problem = simulated(recording, velocity)
    size = np.abs(problem.movements[0].angle).max()
    assert problem.observation.parts > 1
    assert np.abs(shown - problem.movements[0].angle).max() < 2e-4 * size


def test_a_leg_keeps_one_step_a_sample():
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), np.arange(120) * 0.01)
    each = movement(one(segment), 0, "drop")
    assert parts_of([each]) == 1
    assert observe([each], "1/T").parts == 1
    assert unhurried(each, 0.06) == 0.06


def test_a_torque_is_smooth_where_neighbours_tell_it_and_not_where_it_is_held_or_noise():
    random = np.random.default_rng(0)
    assert is_smooth(np.cos(DRIVEN * TIME))
    assert not is_smooth(random.normal(size=500))
    assert not is_smooth(np.repeat(random.normal(size=100), 5))  # held for five samples


def test_a_smooth_torque_is_met_between_its_samples():
    """By the spline to 1e-4: (w h / 2 pi)^6 at 12 samples a period; a line is off by 3 %."""
    recording, _ = oscillator()
    seen = observe([movement(recording, 0, "0")], "1/T")
    middle = (TIME[10:-11] + TIME[11:-10]) / 2
    found = seen.torque.middle[0, 10 : 10 + middle.size]
    assert np.abs(found - 1e3 * np.cos(DRIVEN * middle)).max() < 1e3 * 1e-4


@pytest.mark.parametrize("word", ["gravity", "spring"])
def test_a_leg_has_gravity_and_a_spring(word):
    segment = Segment(TIME[:20], raw_angle=-0.5 + TIME[:20])
    with pytest.raises(ValueError, match=r'is of a rig: a leg has both\. Say kind = "rig"'):
        Recording((segment,), replace(Subject(kind="leg"), **{word: "none"}))
