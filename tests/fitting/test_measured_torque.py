"""A leg led by a stiff motor, made by SciPy: the noise of its torque is no noise of the sensors."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.result.estimates.moved import hidden, variance_left
from exoid.fitting.result.remarks.residual_remarks import EXPLAINED
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.trust.identify import identify
from exoid.trust.not_found import not_found
from fit_cases import DROP, recorded

INERTIA, GRAVITY_MOMENT, DAMPING, STIFFNESS = 0.42, 10.33, 0.6, 3.0  # kg m^2, N m, SI
ADULT = Subject(kind="leg", body_mass=75.0, height=1.78)


def led(torque_noise: float) -> Recording:
    """Slow cosines by a stiff controller, whose torque is recorded with so much noise [N m]."""
    generator, time = np.random.default_rng(5), np.arange(201) / 100
    middle, reach, rate = np.radians(-55.0), np.radians(30.0), np.pi

    def torque(t, angle, velocity):
        wanted = middle - reach * np.cos(rate * t)
        error = reach * rate * np.sin(rate * t) - velocity
        return 300 * (wanted - angle) + 20 * error + GRAVITY_MOMENT * np.cos(wanted)

    def rates(t, state):
        angle, velocity = state
        pull = GRAVITY_MOMENT * np.cos(angle) + STIFFNESS * angle + DAMPING * velocity
        return [velocity, (torque(t, angle, velocity) - pull) / INERTIA]

    begin = [middle - reach, 0.0]
    angle, velocity = solve_ivp(rates, (0, time[-1]), begin, t_eval=time, rtol=1e-9, atol=1e-11).y
    driven = torque(time, angle, velocity)
    segment = Segment(
        time=time,
        raw_angle=angle + generator.normal(0, np.radians(0.05), time.size),
        raw_angular_velocity=velocity + generator.normal(0, np.radians(0.1), time.size),
        applied_torque=driven + generator.normal(0, torque_noise, time.size),
    )
    return Recording((segment,), ADULT, Protocol(kind="measured"))


@pytest.mark.parametrize(("noise", "doubted"), [(0.05, True), (0.0, False)])
def test_a_torque_that_may_be_noisy_is_said_to_make_the_leg_too_heavy(noise, doubted):
    """Noise of 0.05 N m makes J a tenth too large here, on the average."""
    result = fit(led(noise), multistart=4)
    assert any("noise of the measured torque" in each for each in result.notes) == doubted
    assert (result.parameters["inertia"].value > INERTIA * 1.03) == doubted


def test_what_a_torque_drove_is_not_asked_whether_it_was_passive():
    told = identify(fit(led(0.0), multistart=4))
    assert told.reversals == []
    assert "really passive" not in " ".join(told.sentences)


def moved(
    zero: float,
    gain: float = 1.0,
    sensors: Sensors | None = None,
    stiffness: float = STIFFNESS,
    friction: float = 0.0,
) -> Recording:
    """A leg that a motor moves by slow and quick sines, its torque read off by a zero [N m] and a
    gain; it may have dry friction [N m].
    """
    generator, time = np.random.default_rng(8), np.arange(1500) / 100
    rates = 2 * np.pi * np.array([0.13, 0.31, 0.83, 1.9])
    sizes = np.radians([14.0, 8.0, 4.0, 2.0])
    phases = np.multiply.outer(time, rates) + np.array([0.4, 2.1, 3.3, 5.0])
    angle = np.radians(-55.0) + np.sin(phases) @ sizes
    velocity, acceleration = np.cos(phases) @ (rates * sizes), -np.sin(phases) @ (rates**2 * sizes)
    torque = INERTIA * acceleration + DAMPING * velocity
    torque += GRAVITY_MOMENT * np.cos(angle) + stiffness * angle + friction * np.sign(velocity)
    segment = Segment(
        time=time,
        raw_angle=angle + generator.normal(0, np.radians(0.03), time.size),
        applied_torque=gain * torque + zero + generator.normal(0, 0.01, time.size),
    )
    return Recording((segment,), ADULT, Protocol(kind="measured"), sensors or Sensors())


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_the_noise_of_a_torque_sensor_is_no_torque_that_a_model_misses(friction):
    """0.01 N m, white, moves the simulation by more than an encoder errs."""
    notes = " ".join(fit(moved(0.0, friction=friction), multistart=4).notes)
    assert ("misses something" in notes) == (friction > 0)
    assert (EXPLAINED in notes) == (friction == 0)


@pytest.mark.slow
@pytest.mark.parametrize("zero", [0.0, 1.0])
def test_errors_hold_where_a_torque_sensor_reads_off(zero):
    """A steady torque of a tenth of m l g passes for a softer spring and a heavier leg."""
    result = fit(moved(zero), multistart=4)
    for name, truth in (("stiffness", STIFFNESS), ("gravity", GRAVITY_MOMENT)):
        ratio = result.ratios[f"{name}_over_inertia"]
        assert abs(ratio.value - truth / INERTIA) < 2.5 * ratio.standard_error
        assert ratio.standard_error < 0.4 * truth / INERTIA
    assert (result.ratios["stiffness_over_inertia"].limited_by or {})["torque_zero"] > 0.3
    assert any("the torque sensor's zero limits" in each for each in result.notes)
    assert any("torque_zero_uncertainty_nm" in each for each in result.notes)


def test_the_zero_of_an_encoder_is_as_unsure_as_that_of_the_torque_makes_it():
    """A rig that hangs by 2.8 deg elsewhere for half a newton metre, as far as anybody can tell."""
    rig = replace(moved(0.5, stiffness=0.0), subject=Subject(kind="rig", spring="none"))
    found = fit(rig, multistart=2).mountings[0].zero
    assert found is not None
    assert abs(found.value) > np.radians(1.0)  # the truth is 0
    assert abs(found.value) < 2.5 * found.standard_error


EXACT_GAIN = Sensors(torque_gain_uncertainty=0.0)


def fallen(seed: int) -> Segment:
    """A drop of the same leg."""
    generator, time = np.random.default_rng(seed), np.arange(400) / 100

    def rates(t, state):
        angle, velocity = state
        pull = GRAVITY_MOMENT * np.cos(angle) + STIFFNESS * angle + DAMPING * velocity
        return [velocity, -pull / INERTIA]

    begin = [np.radians(-20.0), 0.0]
    angle = solve_ivp(rates, (0, time[-1]), begin, t_eval=time, rtol=1e-9, atol=1e-11).y[0]
    return Segment(time=time, raw_angle=angle + generator.normal(0, np.radians(0.03), time.size))


@pytest.mark.parametrize("zero", [0.6, -0.6])
def test_drops_beside_it_tell_the_zero_of_a_torque_sensor(zero):
    """As a constant torque of drops and motor alike it makes J 2 % wrong, 20 of its errors."""
    led = moved(zero, sensors=EXACT_GAIN)
    both = replace(
        led,
        segments=(fallen(1), fallen(2), *led.segments),
        protocol=Protocol(kind=("passive", "passive", "measured")),
    )
    result = fit(both, multistart=4)
    inertia, found = result.parameters["inertia"], result.mountings[0].torque_zero
    assert abs(inertia.value - INERTIA) < 3 * inertia.standard_error < 0.01 * INERTIA
    assert abs(found.value - zero) < 3 * found.standard_error < 0.1 * abs(zero)


@pytest.mark.parametrize("gain", [0.97, 1.02])
def test_all_that_is_in_newton_metres_is_as_sure_as_the_gain_of_the_torque_sensor(gain):
    """No motion tells it: J goes with it, and the ratios to J do not."""
    result = fit(moved(0.0, gain), multistart=4)
    inertia, moment = result.parameters["inertia"], result.gravity_moment
    assert inertia.value == pytest.approx(gain * INERTIA, rel=0.01)
    for each, truth in ((inertia, INERTIA), (moment, GRAVITY_MOMENT)):
        assert abs(each.value - truth) < 2.5 * each.standard_error
    assert 0.013 < inertia.standard_error / inertia.value < 0.02
    assert (inertia.limited_by or {})["torque_gain"] > 0.9
    assert any("the torque sensor's gain to 1.5 %" in each for each in result.notes)


def test_a_gain_that_is_declared_is_believed():
    sure = fit(moved(0.0, sensors=EXACT_GAIN), multistart=4)
    inertia = sure.parameters["inertia"]
    assert inertia.standard_error < 0.005 * inertia.value
    assert not any("gain" in each for each in sure.notes)


def test_a_drop_has_no_torque_sensor():
    result = fit(recorded(DROP), multistart=2)
    assert "torque_zero" not in (result.ratios["gravity_over_inertia"].limited_by or {})
    assert not any("torque sensor" in each for each in result.notes)


@pytest.mark.parametrize("seed", range(20))
def test_a_zero_that_a_fit_takes_for_something_else_keeps_its_variance_whatever_rounding_leaves(
    seed,
):
    """What is left of 1e18 times the variance is rounding, and may be less than nothing."""
    rng = np.random.default_rng(seed)
    columns = 1e7 * rng.normal(size=(400, 6))
    response = columns @ rng.normal(size=6)
    crossed = (response @ columns)[None]
    moved = np.linalg.solve(columns.T @ columns, crossed.T)
    told = variance_left(crossed, moved, np.array([response @ response]))
    assert 0 < told[0] <= 1


def test_a_zero_that_nothing_else_looks_like_is_told_as_well_as_its_samples_do():
    told = variance_left(np.zeros((1, 6)), np.zeros((6, 1)), np.array([99.0]))
    assert told[0] == pytest.approx(0.01)


def test_a_zero_hides_in_what_is_missed_but_for_what_would_leave_more():
    """A deviation of it, which leaves 400 in squares or 0.25, where 100 are missed."""
    told = 1 / (1 + np.array([400.0, 0.25]))
    assert hidden(told, np.full(2, 100.0)) == pytest.approx([0.5, 1.0])


def rubbing(seconds: float = 6.0) -> Recording:
    """A motor on a vertical axis: J 0.018, d 0.012, friction 0.11 N m, to and fro, whose torque is
    as exact as 5 mN m; the friction acts within a few mrad/s otherwise than a term has it.
    """
    time, step = np.arange(round(seconds * 200)) / 200, 5e-4
    angle, rate, seen = 0.0, 0.0, []
    for number in range(time.size * 10):
        if number % 10 == 0:
            seen.append(angle)
        torque = pushing(number * step)
        rate += step * (torque - 0.012 * rate - 0.11 * np.tanh(rate / 0.02)) / 0.018
        angle += step * rate
    counts = 2 * np.pi / 65536
    segment = Segment(
        time, raw_angle=counts * np.round(np.array(seen) / counts), applied_torque=pushing(time)
    )
    rig = Subject(kind="rig", gravity="none", spring="none")
    sensors = Sensors(
        encoder_counts=65536.0, torque_zero_uncertainty=0.005, torque_gain_uncertainty=0.01
    )
    return Recording((segment,), rig, Protocol(kind="measured"), sensors)


def pushing(time):
    return 0.35 * np.sin(np.pi * time) + 0.3 * np.sin(3.4 * np.pi * time + 1)


def test_the_zero_of_a_torque_does_not_hide_the_friction_of_what_it_moves_to_and_fro():
    """A zero of its ± alone would leave far more than is missed."""
    found = fit(rubbing(), terms=(CoulombFriction(jnp.asarray(0.1)),), multistart=2)
    size = found.terms["coulomb_friction"]["level_over_inertia"]
    damping = found.ratios["damping_over_inertia"]
    assert abs(size.value - 0.11 / 0.018) < 3 * size.standard_error
    assert size.standard_error < 0.1 * size.value
    assert abs(damping.value - 0.012 / 0.018) < 3 * damping.standard_error
    assert not_found(found) == []
