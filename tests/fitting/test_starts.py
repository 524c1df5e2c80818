"""Where a multi-start begins."""

import jax
import numpy as np
import pytest

import legs
from exoid.fitting.data.segment import movement
from exoid.fitting.estimate import fit
from exoid.fitting.model.constraint import violations
from exoid.fitting.model.coordinates import leg_parameters, torque_amplitudes
from exoid.fitting.model.limits import constraint_names, limits_by_hand
from exoid.fitting.model.prior_and_limits import leg_limits
from exoid.fitting.model.user_values import ByHand
from exoid.fitting.multistart.beginning.starts import check_draw, coordinates, draw, first_state
from exoid.fitting.multistart.beginning.tethers import within_reach
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.subject import Subject
from fit_cases import cycle_torque, exact, leg, one, state

TIME = np.arange(120) * 0.01


def drop():
    return movement(one(exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)), 0, "drop")


def cycle():
    segment = exact(LegModel(leg(), cycle_torque()), state(-0.1, -0.5), TIME)
    return movement(one(segment, "active", cycle_period=1.19), 0, "cycle")


PEOPLE = {
    "adult": Subject(kind="leg", body_mass=77.0, height=1.80),
    "infant": Subject(kind="leg", body_mass=4.0, height=0.55),
    "heavy": Subject(kind="leg", body_mass=200.0, height=1.70),
    "anybody": Subject(kind="leg"),
}


@pytest.mark.parametrize("person", PEOPLE)
@pytest.mark.parametrize("bounds", ["body", "paper"])
def test_every_start_is_a_leg_within_the_limits_in_force(person, bounds):
    limits = leg_limits(PEOPLE[person], bounds)
    starts = draw(500, 1, limits)
    leg = LegParameters(*starts[:, :5].T)
    found = violations(limits, leg, starts[None, :, 5], np)
    rules = constraint_names(1)
    if bounds == "paper":  # Eq. 12 has no room in some corners of Eq. 13
        found = found[[n for n, name in enumerate(rules) if name != "m l^2 <= J"]]
    assert found.max() < 1e-9


def test_starts_fill_every_decade_alike():
    limits = leg_limits(PEOPLE["adult"])
    mass = np.log(draw(2000, 1, limits)[:, 0])
    low, high = (np.log(float(each.mass)) for each in (limits.lower, limits.upper))
    share = (mass - low) / (high - low)
    assert abs(share.mean() - 0.5) < 0.026  # 4 sigma of 2000 uniform draws
    assert abs(share.std() - 12**-0.5) < 0.015  # likewise


def test_a_fixed_parameter_starts_where_it_is_fixed():
    hand = ByHand(fix={"c": 0.0, "J": 0.4})
    limits = limits_by_hand(leg_limits(PEOPLE["adult"]), hand)
    starts = draw(50, 1, limits)
    assert np.all(starts[:, 4] == 0.0)
    assert starts[:, 1] == pytest.approx(0.4)


def test_a_seed_gives_one_draw_whose_beginning_does_not_depend_on_its_length():
    assert np.array_equal(draw(64, 3), draw(64, 3))
    assert np.array_equal(draw(64, 3)[:16], draw(16, 3))
    assert not np.array_equal(draw(64, 3), draw(64, 4))


def test_a_start_means_the_parameters_that_it_was_given():
    starts = draw(50, seed=0)
    there = coordinates(starts, [cycle(), drop()])
    back = leg_parameters(there, np)
    for number, leaf in enumerate(jax.tree.leaves(back)):
        assert np.allclose(leaf, starts[:, number], rtol=1e-13)
    torque = torque_amplitudes(jax.tree.map(lambda leaf: leaf[0], there), np)
    assert torque == pytest.approx([starts[0, 5], 0.0], rel=1e-13)  # a drop has none


def test_a_start_is_no_stronger_than_its_tie():
    begin = coordinates(draw(50, 0, leg_limits(PEOPLE["anybody"], "body")), [drop()])
    tied = within_reach(begin, tether=30.0, step=0.02)
    weak = begin.shared.stiffness < 15.0**2
    assert tied.shared.damping.max() == 2 / 0.02 - 2 * 30.0
    assert tied.shared.stiffness.max() == 15.0**2
    assert np.array_equal(tied.shared.stiffness[weak], begin.shared.stiffness[weak])


def test_every_start_comes_to_the_drops_of_a_slow_camera():
    """At 50 Hz a tie is weak, and of somebody who is not known a spring may be 900 N m/rad."""
    drops = (legs.drop(legs.ADULT, start, gyro=False, step=0.02) for start in (-0.5, -0.3, -0.1))
    found = fit(legs.recording(*drops, subject=PEOPLE["anybody"]), multistart=64).multistart
    assert found.failures == {}
    assert found.at_best == 64


@pytest.mark.parametrize("gyro", [True, False])
def test_a_start_begins_where_the_leg_began(gyro):
    """A line over 80 ms lags by at most half of it: 40 ms of 25 rad/s^2 is 1 rad/s."""
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    if not gyro:
        object.__setattr__(segment, "raw_angular_velocity", None)
    each = movement(one(segment), 0, "drop")
    angle, velocity = first_state(each)
    assert angle == pytest.approx(each.angle[0], abs=0.02)
    first = np.searchsorted(TIME, 0.0)
    assert velocity == pytest.approx(-0.5 - 25 * TIME[first], abs=1.0)


@pytest.mark.parametrize(
    ("count", "seed", "said"),
    [
        (0, 0, "multistart is 0: give a whole number, 1 or more"),
        (2.5, 0, "multistart is 2.5"),
        (1, -1, "seed is -1: give a whole number, 0 or more"),
    ],
)
def test_starts_and_seeds_that_are_no_counts_are_refused(count, seed, said):
    with pytest.raises(ValueError, match=said):
        check_draw(count, seed)
