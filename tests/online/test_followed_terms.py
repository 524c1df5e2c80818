"""Terms of the library, and what is known only beside a known mass or torque."""

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.online import world

import exoid
from exoid import online
from exoid.online.belief import knowledge_of
from exoid.online.model.unknowns import refused
from exoid.physics.library import library
from exoid.physics.sensing.gyro_bias import GyroBias
from exoid.physics.term import PhysicsTerm, name_of
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.load_friction import LoadFriction
from exoid.physics.terms.muscle.torque_asymmetry import TorqueAsymmetry
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.hysteresis import Hysteresis
from exoid.physics.terms.tissue.slack_cubic_stiffness import SlackCubicStiffness
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.watching.estimate.load import Mass, expected_with

FOLLOWED = [each for each in library() if issubclass(each, PhysicsTerm) and not refused(each)]
# With a kink, of all motions, and of a constant: each term takes a program of its own.
QUICK = ("hard_stop", "quadratic_drag", "torque_bias")
EXPECTED = exoid.expected_leg(77.0, 1.80)
LOAD = 1.0, 0.4  # kg, m


def test_every_torque_without_a_memory_can_be_followed():
    names = {name_of(each) for each in FOLLOWED}
    assert {"coulomb_friction", "stribeck_friction", "quadratic_drag", "hard_stop"} <= names
    missing = {name_of(each) for each in library() if issubclass(each, PhysicsTerm)} - names
    others = [each for each in library() if name_of(each) in missing]
    others.remove(
        LoadFriction
    )  # at a turn it takes as large a share of the velocity as of the load
    others = [each for each in others if not each.by_whole_drops]
    assert all(each.memory_size or each.voluntary or each.same_torque for each in others)


@pytest.mark.parametrize(
    "term",
    [
        Hysteresis,
        TorqueAsymmetry,
        GyroBias,
        StiffnessRestAngle,
        LoadFriction,
        CubicStiffness,
        SlackCubicStiffness,
    ],
)
def test_what_cannot_be_followed_is_refused(term):
    with pytest.raises(ValueError, match="cannot be estimated live"):
        online.Unknowns((term,))


@pytest.mark.slow
@pytest.mark.parametrize(
    "term",
    [
        each if name_of(each) in QUICK else pytest.param(each, marks=pytest.mark.proof)
        for each in FOLLOWED
    ],
    ids=name_of,
)
def test_a_leg_without_it_is_still_understood(term, play):
    model = online.Model(online.Unknowns((term,)))
    samples, leg, _ = play(31, 1)
    belief, said = online.replay(online.init(EXPECTED, model), samples, model)
    assert np.isfinite(belief.numbers[np.isfinite(online.init(EXPECTED, model).numbers)]).all()
    assert said.drops[-1] == 1
    truth = np.array([leg.gravity, leg.stiffness, leg.damping])
    assert (np.abs(said.ratios[-1] - truth) < 5 * said.errors[-1]).all()


def test_dry_friction_is_found_and_its_error_holds_it(play):
    model = online.Model(online.Unknowns((CoulombFriction,)))
    samples, _, _ = play(32, legs=lambda leg: [replace(leg, friction=0.3)] * 2)
    belief, said = online.replay(online.init(EXPECTED, model), samples, model)
    level = online.estimates(belief, model)["coulomb_friction.level_over_inertia"]
    assert said.drops[-1] == 2
    assert level.set_by == "data"
    assert abs(level.value - 0.3) < 4 * level.error < 0.03
    assert online.estimates(belief, model)["coulomb_friction.level"].set_by != "data"


def test_a_known_mass_tells_the_inertia(start):
    rng = np.random.default_rng(33)
    leg, sensors = world.draw_leg(rng), world.draw_sensors(rng)
    leg = replace(leg, tilt=sensors.tilt, inertia=0.52)  # a fifth more than anatomy expects
    motion, free = world.session(rng, [leg, leg.loaded(2.0, 0.3), leg.loaded(2.0, 0.3)])
    time, angle, rate = world.measured(rng, motion, sensors)
    loaded = np.where(time > free[0][1] + 1.0, 1.0, 0.0)
    told = online.Sample(time, angle, rate, 0 * time, 2.0 * loaded, 0.3 * loaded)
    belief, said = online.replay(start, told)
    known = online.estimates(belief)
    assert said.drops[-1] == 3
    assert known["inertia"].set_by == "data"
    assert abs(known["inertia"].value - 0.52) < 4 * known["inertia"].error < 0.02
    untold, _ = online.replay(
        start, online.Sample(time[loaded == 0], angle[loaded == 0], rate[loaded == 0])
    )
    assert online.estimates(untold)["inertia"].set_by != "data"


def test_a_mass_that_was_put_on_unsaid_is_another_leg(start):
    rng = np.random.default_rng(34)
    leg, sensors = world.draw_leg(rng), world.draw_sensors(rng)
    leg = replace(leg, tilt=sensors.tilt)
    motion, _ = world.session(rng, [leg, leg, leg.loaded(2.0, 0.3)])
    _, said = online.replay(start, online.Sample(*world.measured(rng, motion, sensors)))
    assert (said.trust == online.Trust.CHANGED).any()


def test_a_known_torque_tells_the_inertia(start):
    from scipy.integrate import solve_ivp

    rng, inertia = np.random.default_rng(35), 0.5
    torque = lambda at: 1.5 * np.sin(3.0 * at)  # N m  # noqa: E731
    time = np.arange(0.0, 6.0, 0.01)

    def slope(at, state):
        angle, rate = state
        held = at < 1.0
        pull = torque(at) / inertia - 26.5 * np.cos(angle) - 6.0 * angle - 0.8 * rate
        return [0.0, 0.0] if held else [rate, pull]

    found = solve_ivp(slope, (0, 6), [-0.3, 0.0], t_eval=time, rtol=1e-9, atol=1e-10, max_step=0.01)
    angle = found.y[0] + 7.5e-4 * rng.standard_normal(time.size)
    rate = found.y[1] + 2.6e-3 * rng.standard_normal(time.size)
    belief, said = online.replay(start, online.Sample(time, angle, rate, torque(time)))
    now = knowledge_of(belief, online.Model())
    assert now.phase == online.Phase.MOVING
    assert said.unwhite[-1] < 7
    inertia_known = online.estimates(belief)["inertia"]
    assert abs(inertia_known.value - inertia) < 4 * inertia_known.error + 0.005  # held over a step
    assert inertia_known.set_by == "data"


@pytest.mark.parametrize(("seed", "friction"), [(51, 0.24), (70, 1.5)])
def test_friction_of_a_loaded_leg_that_turns_where_a_part_of_a_step_ends(seed, friction):
    """Friction takes all of its velocity there, but nothing of what nobody knows of that."""
    model = online.Model(online.Unknowns((CoulombFriction,)))
    rng = np.random.default_rng([11, seed])
    sensors = world.draw_sensors(rng)
    leg = replace(world.draw_leg(rng, friction), tilt=sensors.tilt).loaded(*LOAD)
    motion, _ = world.session(rng, [leg])
    samples = online.Sample(*world.measured(rng, motion, sensors))
    belief, said = online.replay(
        online.init(expected_with(EXPECTED, Mass(*LOAD)), model), samples, model
    )
    level = online.estimates(belief, model)["coulomb_friction.level_over_inertia"]
    assert said.drops[-1] == 1
    # Of 250 legs whose velocity is kept, none is three errors off in G or c, and two are in d or F.
    truth = np.array([leg.gravity, leg.stiffness, leg.damping])
    assert (np.abs(said.ratios[-1] - truth) < 3 * said.errors[-1]).all()
    assert abs(level.value - leg.friction) < 3 * level.error
