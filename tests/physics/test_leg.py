"""The equation of motion and the leg's parameters against mechanics."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exoid.physics.leg import GRAVITY, LegModel, LegParameters, angular_acceleration, energy
from exoid.physics.parameter import declarations
from exoid.physics.ratios import Ratios
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque

ROUNDING = 1e-12  # relative, of a dozen operations; sums of terms that may cancel to 1 in 1000

angles = st.floats(-np.pi, np.pi / 2)
velocities = st.floats(-15, 15)
torques = st.floats(-50, 50)
legs = st.builds(
    lambda **values: LegParameters(**{name: jnp.array(x) for name, x in values.items()}),
    **{name: st.floats(said.lower, said.upper) for name, said in declarations(LegParameters)},
)
loads = st.floats(0.01, 5.0)
distances = st.floats(0.05, 0.6)


def added(leg, mass, distance):
    return leg.with_added_mass(jnp.array(mass), jnp.array(distance))


def com_inertia(leg):
    """About the centre of mass (Steiner)."""
    return leg.inertia - leg.mass * leg.com_distance**2


def acceleration(leg, state, torque):
    """phi'' and the state's rate under it."""
    ratios = LegModel(leg, NoTorque()).ratios()
    change = angular_acceleration(ratios, state, torque / leg.inertia)
    return change, LegState(state.angular_velocity, change)


@given(legs, angles, velocities, torques)
def test_the_acceleration_is_that_of_eq_9(leg, angle, velocity, torque):
    found, _ = acceleration(leg, LegState(jnp.array(angle), jnp.array(velocity)), torque)
    parts = [
        torque,
        -leg.mass * GRAVITY * leg.com_distance * np.cos(angle),
        -leg.stiffness * angle,
        -leg.damping * velocity,
    ]
    scale = sum(abs(part) for part in parts) / leg.inertia
    assert abs(found - sum(parts) / leg.inertia) <= 1e-14 * scale


@given(legs, angles, velocities, torques)
def test_energy_changes_by_the_power_of_torque_and_damping_alone(leg, angle, velocity, torque):
    state = LegState(jnp.array(angle), jnp.array(velocity))
    _, rate = acceleration(leg, state, torque)
    model = LegModel(leg, NoTorque())
    _, power = jax.jvp(lambda at: energy(model, at), (state,), (rate,))
    parts = [torque * velocity, -leg.damping * velocity**2]
    scale = 100 * abs(velocity) + sum(abs(part) for part in parts)  # 100 N m: gravity and spring
    assert abs(power - sum(parts)) <= 1e-14 * scale


@given(legs)
def test_hanging_still_without_a_spring_is_the_lowest_energy(leg):
    model = LegModel(eqx.tree_at(lambda at: at.stiffness, leg, jnp.array(0.0)), NoTorque())
    angle = jnp.linspace(-np.pi, np.pi / 2, 601)
    everywhere = jax.vmap(lambda phi: energy(model, LegState(phi, jnp.array(0.0))))(angle)
    assert angle[jnp.argmin(everywhere)] == pytest.approx(-np.pi / 2, abs=1e-12)


@given(legs, loads, distances)
def test_an_added_mass_moves_the_centre_of_mass_by_its_share(leg, load, distance):
    loaded = added(leg, load, distance)
    assert loaded.mass == pytest.approx(float(leg.mass) + load, rel=ROUNDING)
    moment = float(leg.mass * leg.com_distance) + load * distance
    assert float(loaded.mass * loaded.com_distance) == pytest.approx(moment, rel=ROUNDING)


@given(legs, loads, distances)
def test_an_added_mass_adds_its_parallel_axis_inertia(leg, load, distance):
    loaded = added(leg, load, distance)
    assert float(loaded.inertia) == pytest.approx(
        float(leg.inertia) + load * distance**2, rel=ROUNDING
    )
    # about the common centre of mass: the reduced mass times the squared distance of the two
    reduced = leg.mass * load / (leg.mass + load)
    expected = com_inertia(leg) + reduced * (leg.com_distance - distance) ** 2
    assert float(com_inertia(loaded)) == pytest.approx(float(expected), abs=ROUNDING)


@given(legs, loads, loads, distances, distances)
def test_added_masses_may_be_added_in_any_order(leg, one, other, here, there):
    forth = added(added(leg, one, here), other, there)
    back = added(added(leg, other, there), one, here)
    assert eqx.tree_equal(forth, back, rtol=ROUNDING)


@given(legs, distances)
def test_a_mass_of_zero_adds_nothing(leg, distance):
    assert eqx.tree_equal(added(leg, 0.0, distance), leg, rtol=ROUNDING)


def test_a_ratio_is_a_coefficient_of_eq_9_per_inertia():
    leg = LegParameters(*(jnp.array(x) for x in (4.0, 0.5, 0.25, 0.3, 2.0)))
    expected = Ratios(*(jnp.array(x) for x in (2 * GRAVITY, 4.0, 0.6)))
    assert eqx.tree_equal(LegModel(leg, NoTorque()).ratios(), expected, rtol=1e-15)


def test_the_ranges_are_the_bounds_of_eq_13():
    assert {said.symbol: (said.lower, said.upper) for _, said in declarations(LegParameters)} == {
        "m": (2, 6),
        "J": (0.15, 1),
        "l": (0.15, 0.6),
        "d": (0, 60),
        "c": (0, 4),
    }
