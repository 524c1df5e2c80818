"""The simulated side of the misfit against the plain simulation, and the chains beside it."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.data.conditioning_chain import MovingAverage, Raw, SteadyKalman
from exoid.fitting.data.observe import observe
from exoid.fitting.data.segment import movement
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.residual import predict, residual
from exoid.fitting.model.coordinates import Unknowns
from exoid.physics.leg import LegModel
from exoid.physics.state import LegState
from exoid.physics.torque import MeasuredTorque, NoTorque
from exoid.recordings.declared.subject import Subject
from exoid.recordings.filter import kalman
from exoid.recordings.filter.constants import UNBIASED
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import moving_average
from fit_cases import UNMOVED, coordinates_of, cycle_torque, exact, leg, one, simulated, state

ROUNDING = 1e-11  # rad and rad/s: the same steps, but per inertia or in N m
TIME = np.arange(120) * 0.01
UNEVEN = TIME + 0.003 * np.sin(17 * TIME)  # s, still increasing
TORQUE = 1.5 * np.sin(9 * TIME)  # N m
FREE = 0.0
LOAD = Subject(
    kind="leg", added_mass=1.2, added_mass_distance=0.35, added_mass_gyration=0.0
)  # a point: what says nothing of its extent has 5 cm


def seen_by_the_fit(recording: Recording, reading="1/T"):
    """The movement and its observation, without the axis `segment`."""
    each = movement(recording, 0, "case")
    return each, jax.tree.map(lambda leaf: jnp.asarray(leaf[0]), observe([each], reading))


predicting = eqx.filter_jit(predict)


def predicted(point, seen, each, *, tether=FREE, chain=None) -> LegState:
    """The samples that the fit compares, of the segment alone."""
    stage = Stage(jnp.asarray(tether), jnp.asarray(seen.time.size - 1))
    own = jax.tree.map(lambda leaf: jnp.asarray(leaf[0]), point.own)
    shared = jax.tree.map(jnp.asarray, point.shared)
    shown = predicting(Unknowns(shared, UNMOVED, own), seen, stage, chain or Raw())
    return jax.tree.map(lambda samples: np.asarray(samples)[: each.segment.time.size], shown)


def plain(parameters, torque, start, each):
    loaded = parameters.with_added_mass(
        jnp.asarray(each.added_mass), jnp.asarray(each.added_mass_distance)
    )
    return simulated(LegModel(loaded, torque), start, jnp.asarray(each.segment.time))


def cases():
    """A recording, the reading of Eq. 4, and the torque on the clipped segment's clock."""
    free = LegModel(leg(), NoTorque())
    drop = exact(free, state(-0.2, -0.5), UNEVEN)
    yield "a drop, unevenly sampled", one(drop), "1/T", lambda each: NoTorque()
    yield "a loaded drop", one(drop, subject=LOAD), "1/T", lambda each: NoTorque()
    for reading, cycles in (("1/T", 1.0), ("2/T", 2.0)):
        yield (
            f"a cycle with {reading}",
            one(drop, kind="active", cycle_period=1.19),
            reading,
            lambda each, cycles=cycles: cycle_torque(-3.0, 1.19, each.onset, cycles),
        )
    driven = exact(free, state(-0.2, -0.5), TIME, applied_torque=TORQUE)
    yield (
        "a measured torque on a loaded leg",
        one(driven, kind="measured", subject=LOAD),
        "1/T",
        lambda each: MeasuredTorque(jnp.asarray(TIME), jnp.asarray(TORQUE)),
    )


@pytest.mark.parametrize(
    ("recording", "reading", "torque"), [c[1:] for c in cases()], ids=[c[0] for c in cases()]
)
def test_a_free_prediction_is_the_plain_simulation(recording, reading, torque):
    each, seen = seen_by_the_fit(recording, reading)
    parameters, start = leg(mass=5.0, inertia=0.5), state(-0.25, 0.3)
    point = coordinates_of(parameters, [(-3.0 if each.voluntary else 0.0, -0.25, 0.3)])
    shown, motion = predicted(point, seen, each), plain(parameters, torque(each), start, each)
    assert np.abs(shown.angle - motion.angle).max() < ROUNDING
    assert np.abs(shown.angular_velocity - motion.angular_velocity).max() < ROUNDING


def test_the_misfit_is_the_difference_over_the_noise():
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    each, seen = seen_by_the_fit(one(segment))
    there = LegState(jnp.array(-0.3), jnp.array(-1.0))
    found = residual(there, jnp.zeros(3), jnp.array(7), seen)
    expected = [
        (-0.3 - each.angle[7]) / each.angle_noise,
        (-1.0 - each.angular_velocity[7]) / each.velocity_noise,
    ]
    assert np.allclose(found, expected, rtol=1e-14)


def test_the_tether_pulls_a_wrong_leg_to_the_guide_with_its_square():
    """e'' + 2 w e' + w^2 e = F leaves e near F / w^2 where F changes slowly against 1 / w."""
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    each, seen = seen_by_the_fit(one(segment))
    wrong = coordinates_of(leg(inertia=0.2, stiffness=0.0), [(0.0, -0.2, -0.5)])
    size = each.segment.time.size
    away = [
        np.abs(predicted(wrong, seen, each, tether=w).angle - seen.guide_angle[:size])[20:].max()
        for w in (FREE, 20.0, 40.0)
    ]
    assert away[0] > 10 * away[1]
    assert 3 < away[1] / away[2] < 5  # 4, but for the torque's own change


def test_a_right_leg_feels_no_tether():
    """The guide's slope is that of 30 ms later at its beginning: off by 30 ms phi'' = 0.8 rad/s for
    some 30 ms, 20 mrad at most. A wrong leg strays by ten times as much.
    """
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    each, seen = seen_by_the_fit(one(segment))
    start = (0.0, float(each.angle[0]), float(each.angular_velocity[0]))
    right = coordinates_of(leg(), [start])
    tied, free = (predicted(right, seen, each, tether=w).angle for w in (20.0, FREE))
    assert np.abs(tied - free).max() < 2e-2


def test_the_moving_average_of_the_simulation_is_that_of_the_recording():
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    each, seen = seen_by_the_fit(one(segment))
    point = coordinates_of(leg(), [(0.0, -0.3, -1.0)])
    raw, shown = (predicted(point, seen, each, chain=chain) for chain in (Raw(), MovingAverage(9)))
    for name in ("angle", "angular_velocity"):
        expected = moving_average(getattr(raw, name), 9)
        assert np.abs(getattr(shown, name)[8:] - expected).max() < 1e-14 * 100


def test_the_settled_filter_is_the_firmwares_once_its_covariance_stands_still():
    """What differs at first, P and the acceleration, fades by 11 % a sample."""
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    each, seen = seen_by_the_fit(one(segment))
    point = coordinates_of(leg(), [(0.0, -0.3, -1.0)])
    raw = predicted(point, seen, each)
    steps = np.full(raw.angle.size - 1, 0.01)
    filtered = kalman.filter(steps, raw.angle, raw.angular_velocity, UNBIASED)
    shown = predicted(point, seen, each, chain=SteadyKalman(0.01, "3 states"))
    difference = np.stack([shown.angle, shown.angular_velocity], axis=1) - filtered.state[:, :2]
    assert np.abs(difference[2:20]).max() > 1e-6
    assert np.abs(difference[90:]).max() < 1e-6


def test_a_chain_changes_nothing_in_a_leg_that_rests():
    hanging = LegModel(leg(stiffness=0.0), NoTorque())
    rest = -np.pi / 2
    point = coordinates_of(leg(stiffness=0.0), [(0.0, rest, 0.0)])
    template, seen = seen_by_the_fit(one(exact(hanging, state(-0.2, -0.5), TIME)))
    shown = predicted(point, seen, template, chain=MovingAverage(9))
    assert np.abs(shown.angle - rest).max() < 1e-14
