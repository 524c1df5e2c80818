"""R, Q'r and the rest against finite differences of a residual written down independently."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.data.observe import observe
from exoid.fitting.data.segment import movement
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condense import condense, linear_model
from exoid.fitting.model.coordinates import TYPICAL, SegmentUnknowns, Shared, Unknowns, scaled
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.subject import Subject
from fit_cases import UNMOVED, coordinates_of, cycle_torque, exact, leg, one, state

TIME = np.arange(120) * 0.01
LOAD = Subject(kind="leg", added_mass=1.2, added_mass_distance=0.35, added_mass_gyration=0.0)
STEP = 1e-4  # of a central difference in typical steps: its error is about STEP^2
CLOSE = 1e-6  # relative to the largest entry: that, times the third derivative's size


def posed(subject, kind):
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), TIME)
    protocol = {"cycle_period": 1.19} if kind == "active" else {}
    each = movement(one(segment, kind, subject, **protocol), 0, "case")
    seen = jax.tree.map(lambda leaf: jnp.asarray(leaf[0]), observe([each], "1/T"))
    point = coordinates_of(leg(mass=5.0), [(-3.0 if kind == "active" else 0.0, -0.22, -0.4)])
    known = np.array([subject.added_mass is None, 0, 0, 0, kind != "active", 0, 0], dtype=float)
    return each, seen, point, known


def plain_residual(each, z):
    """Simulated minus measured over the noise, for a leg of one kilogram at one metre and so on.

    `z` holds log J, m l g / J, c / J, d / J, tau / J and the state, in units of `TYPICAL`.
    """
    unit = np.array([*jax.tree.leaves(TYPICAL.shared), *jax.tree.leaves(TYPICAL.own)])
    log_inertia, gravity, stiffness, damping, torque, angle, velocity = z * unit
    inertia = jnp.exp(log_inertia)
    parameters = LegParameters(
        mass=jnp.asarray(1.0),
        inertia=inertia,
        com_distance=gravity * inertia / 9.81,
        damping=damping * inertia,
        stiffness=stiffness * inertia,
    ).with_added_mass(jnp.asarray(each.added_mass), jnp.asarray(each.added_mass_distance))
    drive = eqx.tree_at(
        lambda t: t.amplitude, cycle_torque(0.0, 1.19, each.onset), torque * inertia
    )
    motion = simulate(
        LegModel(parameters, drive), LegState(angle, velocity), jnp.asarray(each.segment.time)
    )
    return jnp.stack(
        [
            (motion.angle - each.angle) / each.angle_noise,
            (motion.angular_velocity - each.angular_velocity) / each.velocity_noise,
        ]
    )


condensed = eqx.filter_jit(condense)


def condensed_at(point, seen, known, steps=None):
    own = jax.tree.map(lambda leaf: jnp.asarray(leaf[0]), point.own)
    shared = jax.tree.map(jnp.asarray, point.shared)
    count = seen.time.size - 1 if steps is None else steps
    stage = Stage(jnp.asarray(0.0), jnp.asarray(count))
    each = [jnp.asarray(value) for value in known]
    parts = Shared(*each[:4]), UNMOVED, SegmentUnknowns(*each[4:])
    return condensed(Unknowns(shared, UNMOVED, own), seen, Unknowns(*parts), stage, Raw())


def differences(each, point):
    """The residual as one column, and its Jacobian by central differences."""
    leaves = [*jax.tree.leaves(point.shared), *(leaf[0] for leaf in jax.tree.leaves(point.own))]
    unit = [*jax.tree.leaves(TYPICAL.shared), *jax.tree.leaves(TYPICAL.own)]
    at = np.array(leaves) / np.array(unit)
    value = jax.jit(lambda z: plain_residual(each, z))
    columns = [(value(at + STEP * e) - value(at - STEP * e)) / (2 * STEP) for e in np.eye(at.size)]
    return np.asarray(value(at)), np.stack(columns, axis=-1)


CASES = [
    (LOAD, "active"),
    (LOAD, "passive"),
    (Subject(kind="leg"), "active"),
    (Subject(kind="leg"), "passive"),
]


@pytest.mark.parametrize(("subject", "kind"), CASES)
def test_normal_matrix_gradient_and_loss_are_those_of_finite_differences(subject, kind):
    each, seen, point, known = posed(subject, kind)
    found = condensed_at(point, seen, known)
    value, columns = differences(each, point)
    residual, jacobian = value.ravel(), columns.reshape(-1, 7) * (1 - known)
    normal = jacobian.T @ jacobian
    gradient = jacobian.T @ residual
    close = lambda a, b: np.abs(a - b).max() <= CLOSE * np.abs(b).max()  # noqa: E731
    assert close(found.factor.T @ found.factor, normal)
    assert close(found.factor.T @ found.projection, gradient)
    total = found.projection @ found.projection + found.remainder**2
    assert total == pytest.approx(residual @ residual, rel=1e-10)


@pytest.mark.parametrize(("subject", "kind"), CASES)
def test_a_known_unknown_has_neither_row_nor_column(subject, kind):
    _, seen, point, known = posed(subject, kind)
    found = condensed_at(point, seen, known)
    fixed = known > 0
    assert np.all(found.factor[fixed] == 0)
    assert np.all(found.factor[:, fixed] == 0)
    assert np.all(found.projection[fixed] == 0)
    assert np.all(np.diag(found.factor)[~fixed] > 0)


def test_the_linear_model_has_the_exact_value_at_its_own_point_and_the_right_slope():
    each, seen, point, known = posed(LOAD, "active")
    every = jax.tree.map(lambda leaf: leaf[None], condensed_at(point, seen, known))
    value, columns = differences(each, point)
    unit = scaled(jax.tree.map(jnp.asarray, point))
    owner = jax.tree.map(lambda leaf: leaf[None], seen.owner)
    here = linear_model(every, unit, unit, owner)
    assert here @ here == pytest.approx((value**2).sum(), rel=1e-10)
    step = np.linspace(-0.5, 0.5, 7) * 1e-2
    shared = jax.tree.unflatten(jax.tree.structure(unit.shared), list(step[:4]))
    own = jax.tree.unflatten(jax.tree.structure(unit.own), list(step[4:, None]))
    there = eqx.tree_at(
        lambda at: (at.shared, at.own),
        unit,
        (jax.tree.map(jnp.add, unit.shared, shared), jax.tree.map(jnp.add, unit.own, own)),
    )
    moved = linear_model(every, unit, there, owner)
    expected = value.ravel() + columns.reshape(-1, 7) @ step
    assert moved @ moved == pytest.approx(expected @ expected, rel=1e-6)  # of the differences


def test_a_horizon_sees_the_samples_up_to_its_last_step():
    _, seen, point, known = posed(LOAD, "active")
    steps = 60
    later = np.arange(seen.time.size) > steps
    blind = eqx.tree_at(
        lambda at: (at.angle_weight, at.velocity_weight),
        seen,
        tuple(jnp.where(later, 0.0, w) for w in (seen.angle_weight, seen.velocity_weight)),
    )
    short, masked = condensed_at(point, seen, known, steps), condensed_at(point, blind, known)
    assert eqx.tree_equal(short, masked, rtol=1e-9, atol=1e-9)
    assert float(short.remainder) < float(condensed_at(point, seen, known).remainder)


def test_a_sample_that_is_missing_does_not_count():
    """Its value is arbitrary where its weight is 0."""
    _, seen, point, known = posed(LOAD, "active")
    gone = eqx.tree_at(lambda at: at.angle_weight, seen, seen.angle_weight.at[30].set(0.0))
    other = eqx.tree_at(lambda at: at.angle, gone, gone.angle.at[30].set(9.0))
    assert eqx.tree_equal(condensed_at(point, gone, known), condensed_at(point, other, known))
