"""The time loop against an independent integrator, and against the laws that a motion obeys."""

from dataclasses import fields
from itertools import pairwise

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import simpson
from scipy.optimize import brentq
from scipy.special import ellipk

from exoid.physics.leg import GRAVITY, LegModel, LegParameters, energy
from exoid.physics.motion.simulate import simulate
from exoid.physics.parameter import declarations
from exoid.physics.state import LegState
from exoid.physics.torque import CycleTorque, MeasuredTorque, NoTorque

LEG = {"mass": 4.4, "inertia": 0.45, "com_distance": 0.27, "damping": 0.35, "stiffness": 2.9}
PERIOD = 1.8  # s
DURATION = 4.0  # s

run = eqx.filter_jit(simulate)


def leg(**changes):
    return LegParameters(**{name: jnp.array(x) for name, x in (LEG | changes).items()})


def state(degrees, velocity=0.0):
    return LegState(jnp.array(np.radians(degrees)), jnp.array(velocity))


def grid(rate, duration=DURATION):
    return jnp.arange(round(duration * rate) + 1) / rate


def cycle(cycles, onset=0.0, amplitude=-5.39):
    """Eq. 10 with f = cycles / T."""
    return CycleTorque(
        amplitude=jnp.array(amplitude),
        period=jnp.array(PERIOD),
        frequency=jnp.array(cycles / PERIOD),
        onset=jnp.array(onset),
    )


def measured(rate=40):
    """A torque with a kink at every sample."""
    torque = np.random.default_rng(0).normal(0, 3, round(DURATION * rate) + 1)
    return MeasuredTorque(grid(rate), jnp.array(torque))


# Each torque, and the times at which its slope jumps. A step across such a time loses the order
# four, so every grid that is compared has a sample there.
NO_KINK = ()
DRIVES = {
    "drop": (NoTorque(), NO_KINK),
    "f = 1/T": (cycle(1), (0.9,)),
    "f = 2/T": (cycle(2), (0.9,)),
    "late onset": (cycle(1, onset=0.7), (0.7, 1.6)),
    "measured": (measured(), tuple(np.arange(1, 160) / 40)),
}
drives = pytest.mark.parametrize("drive", DRIVES)


def reference(model, start, time, kinks):
    """Eq. 9 written out once more, by an adaptive method of order eight that stops at the kinks."""
    body = {entry.name: getattr(model.leg, entry.name) for entry in fields(LegParameters)}

    def rate(at, phase, _):
        phi, velocity = phase
        torque = (
            model.torque(at)
            - body["mass"] * body["com_distance"] * GRAVITY * jnp.cos(phi)
            - body["stiffness"] * phi
            - body["damping"] * velocity
        )
        return jnp.stack([velocity, torque / body["inertia"]])

    steps = diffrax.PIDController(rtol=1e-12, atol=1e-12)
    if kinks:
        steps = diffrax.ClipStepSizeController(steps, jump_ts=jnp.array(kinks))
    solution = diffrax.diffeqsolve(
        diffrax.ODETerm(rate),
        diffrax.Dopri8(),
        time[0],
        time[-1],
        1e-3,
        jnp.stack([start.angle, start.angular_velocity]),
        saveat=diffrax.SaveAt(ts=time),
        stepsize_controller=steps,
        max_steps=100_000,
    )
    return solution.ys.T


def uneven(rate, kinks):
    """Steps that differ five-fold, with a sample at every kink."""
    steps = np.random.default_rng(1).uniform(0.2, 1.0, round(2 * DURATION * rate))
    time = np.cumsum(steps) / rate
    return jnp.array(np.union1d([0.0, *kinks], time[time <= DURATION]))


@pytest.mark.parametrize(
    ("drive", "spacing"),
    [*((drive, "even") for drive in DRIVES), ("drop", "uneven"), ("measured", "uneven")],
)
def test_it_agrees_with_an_independent_method_of_order_eight(drive, spacing):
    torque, kinks = DRIVES[drive]
    time = grid(2000) if spacing == "even" else uneven(2000, kinks)
    model, start = LegModel(leg(), torque), state(-15, 0.5)
    found = run(model, start, time)
    angle, velocity = reference(model, start, time, kinks)
    np.testing.assert_allclose(found.angle, angle, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.angular_velocity, velocity, rtol=0, atol=1e-8)


@drives
def test_the_error_falls_with_the_fourth_power_of_the_step(drive):
    model = LegModel(leg(), DRIVES[drive][0])
    exact, coarse, fine = (
        run(model, state(-15, 0.5), grid(rate)).angle[:: rate // 80] for rate in (5120, 80, 160)
    )
    assert 3.8 < np.log2(np.abs(coarse - exact).max() / np.abs(fine - exact).max()) < 4.2


def test_at_100_hz_the_error_is_below_a_microradian():
    coarse, fine = (run(LegModel(leg(), NoTorque()), state(20), grid(r)).angle for r in (100, 3200))
    assert np.abs(coarse - fine[::32]).max() < 1e-6


def test_the_acceleration_is_the_derivative_of_the_velocity():
    found = run(LegModel(leg(), cycle(1)), state(-15), grid(1000, 0.9))
    slope = np.gradient(found.angular_velocity, found.time, edge_order=2)
    # h^2/6 times the third derivative of the velocity, about 5^4 rad/s^4
    assert np.abs(found.angular_acceleration - slope)[1:-1].max() < 1e-3**2 / 6 * 5**4 * 3


def imbalance(model, trajectory, ends):
    """Energy gained less the work of the torque and of the damping [J], by Simpson's rule."""
    work = 0.0
    velocity, torque = trajectory.angular_velocity, model.torque(trajectory.time)
    power = torque * velocity - model.leg.damping * velocity**2
    for begin, end in pairwise(ends):
        part = slice(begin, end + 1)
        work += simpson(power[part], x=trajectory.time[part])
    states = LegState(trajectory.angle, trajectory.angular_velocity)
    first, last = (energy(model, jax.tree.map(lambda x, i=i: x[i], states)) for i in (0, -1))
    return float(last - first - work)


@drives
def test_energy_changes_by_the_work_of_the_torque_and_the_damping(drive):
    torque, kinks = DRIVES[drive]
    model = LegModel(leg(), torque)
    found = {}
    for rate in (160, 320):
        time = grid(rate)
        ends = np.searchsorted(time, [0.0, *(k - 1e-9 for k in kinks), DURATION])
        found[rate] = abs(imbalance(model, run(model, state(-15, 0.5), time), ends))
    assert found[320] < 1e-6  # of about 10 J
    assert found[320] < found[160] / 10  # both the method and Simpson's rule are of order four


@given(st.floats(-100, 20), st.floats(0, 4.0))
def test_without_damping_and_torque_energy_is_conserved(degrees, stiffness):
    model = LegModel(leg(damping=0.0, stiffness=stiffness), NoTorque())
    found = run(model, state(degrees), grid(500))
    everywhere = jax.vmap(lambda at: energy(model, at))(
        LegState(found.angle, found.angular_velocity)
    )
    # 1e-8 of 12 J: Runge-Kutta loses (omega h)^6/144 of the energy in each of 2000 steps
    assert np.abs(everywhere - everywhere[0]).max() < 1e-7


@given(st.floats(-100, 20))
def test_without_damping_a_reversed_velocity_leads_back_to_the_start(degrees):
    model = LegModel(leg(damping=0.0), NoTorque())
    time = grid(500)
    out = run(model, state(degrees), time)
    turned = LegState(out.angle[-1], -out.angular_velocity[-1])
    back = run(model, turned, time)
    np.testing.assert_allclose(back.angle[::-1], out.angle, rtol=0, atol=1e-7)


@given(st.floats(5, 100))
def test_a_free_swing_has_the_period_of_the_elliptic_integral(degrees):
    model = LegModel(leg(damping=0.0, stiffness=0.0), NoTorque())
    found = run(model, state(degrees - 90), grid(1000))
    rest = np.sqrt(LEG["mass"] * LEG["com_distance"] * GRAVITY / LEG["inertia"])
    period = 4 * ellipk(np.sin(np.radians(degrees) / 2) ** 2) / rest
    turns = crossings(found.time, found.angular_velocity)
    np.testing.assert_allclose(turns, period / 2 * np.arange(1, len(turns) + 1), atol=1e-5)


def crossings(time, signal):
    """Where a signal changes its sign, by a straight line between samples; the start left out."""
    time, signal = np.asarray(time[1:]), np.asarray(signal[1:])
    at = np.flatnonzero(signal[:-1] * signal[1:] < 0)
    return time[at] - signal[at] * np.diff(time)[at] / np.diff(signal)[at]


def rest_angle(stiffness):
    """Where gravity and spring balance: m l g cos(phi) + c phi = 0."""
    weight = LEG["mass"] * LEG["com_distance"] * GRAVITY
    return brentq(lambda phi: weight * np.cos(phi) + stiffness * phi, -2, 0, xtol=1e-15)


@pytest.mark.parametrize("stiffness", [0.0, 2.9, 4.0])
@pytest.mark.parametrize("damping", [0.05, 0.35, 2.0])
def test_a_small_swing_has_the_period_and_the_damping_ratio_of_the_formula(stiffness, damping):
    rest, size = rest_angle(stiffness), 1e-5
    weight = LEG["mass"] * LEG["com_distance"] * GRAVITY
    natural = np.sqrt((stiffness - weight * np.sin(rest)) / LEG["inertia"])
    ratio = damping / (2 * LEG["inertia"] * natural)
    assert ratio < 1
    time = grid(1000)
    found = run(
        LegModel(leg(stiffness=stiffness, damping=damping), NoTorque()),
        LegState(jnp.array(rest + size), jnp.array(0.0)),
        time,
    )
    damped = natural * np.sqrt(1 - ratio**2)
    decay = np.exp(-ratio * natural * time)
    expected = decay * (np.cos(damped * time) + ratio * natural / damped * np.sin(damped * time))
    # what the formula neglects is of the order of size^2, 1e-5 of the swing
    np.testing.assert_allclose((found.angle - rest) / size, expected, rtol=0, atol=2e-5)


@given(st.floats(0.0, 4.0))
def test_a_leg_at_its_rest_angle_stays_there(stiffness):
    rest = rest_angle(stiffness)
    start = LegState(jnp.array(rest), jnp.array(0.0))
    found = run(LegModel(leg(stiffness=stiffness), NoTorque()), start, grid(100))
    assert np.abs(found.angle - rest).max() < 1e-14


@given(st.floats(-120, 30), st.floats(0.0, 4.0))
def test_every_damped_leg_comes_to_rest_there(degrees, stiffness):
    model = LegModel(leg(stiffness=stiffness, damping=3.0), NoTorque())
    found = run(model, state(degrees), grid(100, 12.0))
    assert found.angle[-1] == pytest.approx(rest_angle(stiffness), abs=1e-9)


@given(st.floats(-120, 30))
def test_the_torque_that_balances_an_angle_holds_the_leg_there(degrees):
    phi = np.radians(degrees)
    needed = LEG["mass"] * LEG["com_distance"] * GRAVITY * np.cos(phi) + LEG["stiffness"] * phi
    torque = MeasuredTorque(jnp.array([0.0, 1.0]), jnp.array([needed, needed]))
    found = run(LegModel(leg(damping=2.0), torque), state(degrees), grid(100, 2.0))
    # above the horizontal the balance may be unstable: rounding grows by exp(2 s * 4 / s)
    assert np.abs(found.angle - phi).max() < 1e-11


def scaled(model, factor):
    """(m, J, d, c, tau) times a factor, l as it is."""
    names = ("mass", "inertia", "damping", "stiffness")
    body = {entry.name: getattr(model.leg, entry.name) for entry in fields(LegParameters)}
    body |= {name: body[name] * factor for name in names}
    torque = eqx.tree_at(lambda at: at.amplitude, model.torque, model.torque.amplitude * factor)
    return LegModel(LegParameters(**body), torque)


@given(st.floats(0.1, 10))
def test_a_common_factor_of_all_but_the_length_leaves_the_motion_alone(factor):
    model = LegModel(leg(), cycle(1))
    one, other = (run(each, state(-5), grid(100)) for each in (model, scaled(model, factor)))
    assert eqx.tree_equal(one, other, rtol=1e-13, atol=1e-13)


@given(st.integers(-3, 3))
def test_a_power_of_two_leaves_it_alone_to_the_last_bit(power):
    model = LegModel(leg(), cycle(1))
    one, other = (run(each, state(-5), grid(100)) for each in (model, scaled(model, 2.0**power)))
    assert eqx.tree_equal(one, other)


@given(st.floats(0.3, 3))
def test_mass_and_its_distance_enter_as_their_product_only(factor):
    swapped = leg(mass=LEG["mass"] * factor, com_distance=LEG["com_distance"] / factor)
    one, other = (run(LegModel(each, cycle(1)), state(-5), grid(100)) for each in (leg(), swapped))
    assert eqx.tree_equal(one, other, rtol=1e-13, atol=1e-13)


def test_a_later_clock_changes_nothing_when_the_cycle_starts_later_too():
    time = grid(128)  # dyadic: adding 1024 s loses no bit
    one = run(LegModel(leg(), cycle(1)), state(-5), time)
    other = run(LegModel(leg(), cycle(1, onset=1024.0)), state(-5), time + 1024)
    assert eqx.tree_equal(one.angle, other.angle, rtol=1e-12, atol=1e-12)


def test_one_program_simulates_many_legs_as_it_does_one():
    degrees = np.array([-40.0, -10.0, 15.0])
    many = jax.jit(jax.vmap(lambda at: simulate(LegModel(leg(), cycle(1)), at, grid(100))))(
        LegState(jnp.radians(jnp.array(degrees)), jnp.zeros(3))
    )
    for number, each in enumerate(degrees):
        alone = run(LegModel(leg(), cycle(1)), state(each), grid(100))
        np.testing.assert_allclose(many.angle[number], alone.angle, rtol=0, atol=1e-13)


# Off the grid: the derivative of the steps as they are, not of the moment a kink crosses a sample.
GRADIENT_MODEL = LegModel(leg(), cycle(1, onset=0.1234))
GRADIENT_TIME = grid(100, 2.5)


def final_angle(inputs):
    return simulate(*inputs, GRADIENT_TIME).angle[-1]


def differences(function, inputs, relative=1e-5):
    """Central differences with respect to every leaf."""
    leaves, kind = jax.tree.flatten(inputs)

    def change(number):
        step = relative * max(abs(float(leaves[number])), 0.1)
        ends = [
            function(jax.tree.unflatten(kind, [*leaves[:number], x, *leaves[number + 1 :]]))
            for x in (leaves[number] + step, leaves[number] - step)
        ]
        return (ends[0] - ends[1]) / (2 * step)

    return jax.tree.unflatten(kind, [change(number) for number in range(len(leaves))])


@pytest.mark.parametrize("mode", [jax.jacfwd, jax.jacrev], ids=["forward", "reverse"])
def test_the_gradient_of_the_final_angle_is_that_of_central_differences(mode):
    inputs = (GRADIENT_MODEL, state(-15, 0.5))
    found = jax.jit(mode(final_angle))(inputs)
    expected = differences(jax.jit(final_angle), inputs)
    # differences: h^2/6 of the third derivative, 1e-10 relative, and rounding of 1e-15 / 1e-6
    assert eqx.tree_equal(found, expected, rtol=1e-6, atol=1e-8)


def test_every_parameter_moves_the_final_angle_except_the_period_apart_from_its_frequency():
    gradient = jax.jit(jax.jacfwd(final_angle))((GRADIENT_MODEL, state(-15, 0.5)))
    model, start = gradient
    assert model.torque.period == 0  # the kink's torque is zero, so moving it does no work
    for part in (model.leg, start):
        assert all(abs(leaf) > 1e-3 for leaf in jax.tree.leaves(part))
    assert all(abs(getattr(model.torque, x)) > 1e-3 for x in ("amplitude", "frequency", "onset"))


def test_the_gradient_reaches_every_sample_of_a_measured_torque():
    knots = grid(10, 2.0)

    def final(torque):
        model = LegModel(leg(), MeasuredTorque(knots, torque))
        return simulate(model, state(-15), grid(100, 2.0)).angle[-1]

    torque = jnp.array(np.random.default_rng(2).normal(0, 3, len(knots)))
    steps = 1e-5 * jnp.eye(len(knots))
    many = jax.jit(jax.vmap(final))
    expected = (many(torque + steps) - many(torque - steps)) / 2e-5
    np.testing.assert_allclose(jax.jit(jax.grad(final))(torque), expected, rtol=1e-6, atol=1e-9)


def test_every_declared_parameter_is_a_leaf_of_the_model():
    names = [name for name, _ in declarations(LegParameters)]
    assert len(jax.tree.leaves(GRADIENT_MODEL.leg)) == len(names) == 5
