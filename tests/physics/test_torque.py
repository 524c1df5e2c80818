"""The torques on the knee against their definitions and against the two readings of Eq. 10."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from exoid.physics.torque import CycleTorque, MeasuredTorque, NoTorque, cycle_shape

periods = st.floats(0.5, 8.0)
amplitudes = st.floats(-250, 250)
shares = st.floats(0, 1)  # of the period
ROUNDING = 2e-14  # of a sine whose argument, up to 4 pi, was rounded a few times


def cycle(amplitude, period, frequency, onset=0.0):
    return CycleTorque(
        amplitude=jnp.array(amplitude),
        period=jnp.array(period),
        frequency=jnp.array(frequency),
        onset=jnp.array(onset),
    )


def shape(time, period, cycles):
    return float(cycle_shape(jnp.array(time), jnp.array(period), jnp.array(cycles / period)))


def mean_shape(period, cycles):
    """Over one period, integrated on either side of the kink."""
    halves = [(0, period / 2), (np.nextafter(period / 2, period), period)]
    parts = [quad(shape, *half, args=(period, cycles), epsabs=1e-12)[0] for half in halves]
    return sum(parts) / period


@given(periods, shares)
def test_eq_10_with_one_sine_per_period_has_one_sign(period, share):
    expected = -abs(np.sin(2 * np.pi * share))
    assert shape(share * period, period, 1) == pytest.approx(expected, abs=ROUNDING)


@pytest.mark.parametrize(("cycles", "mean"), [(1, -2 / np.pi), (2, 0.0), (0.5, 0.0)])
def test_the_mean_of_eq_10_tells_its_readings_apart(cycles, mean):
    assert mean_shape(1.8, cycles) == pytest.approx(mean, abs=1e-12)


@given(periods, shares, st.sampled_from([1, 2, 3]))
def test_eq_10_is_time_symmetric_with_whole_sines_per_period(period, share, cycles):
    time = share * period
    assert shape(period - time, period, cycles) == pytest.approx(
        shape(time, period, cycles), abs=ROUNDING
    )


@given(periods, st.floats(0, 0.499))
def test_eq_10_is_antisymmetric_with_half_a_sine_per_period(period, share):
    time = share * period
    assert shape(period - time, period, 0.5) == pytest.approx(
        -shape(time, period, 0.5), abs=ROUNDING
    )


@pytest.mark.parametrize(("cycles", "jump"), [(1, 0.0), (2, 0.0), (0.5, 2.0)])
def test_eq_10_jumps_at_half_the_period_only_with_half_a_sine(cycles, jump):
    before, after = (shape(0.9 + side * 1e-12, 1.8, cycles) for side in (-1, 1))
    assert after - before == pytest.approx(jump, abs=1e-10)  # the slope is at most 7 per second


@given(periods, shares, amplitudes, st.floats(-3, 3))
def test_a_cycle_is_its_shape_times_its_amplitude_from_its_onset_on(
    period, share, amplitude, onset
):
    time = share * period
    torque = cycle(amplitude, period, 1 / period, onset)(jnp.array(onset + time))
    assert float(torque) == pytest.approx(
        amplitude * shape(time, period, 1), abs=250 * 50 * ROUNDING
    )  # adding and subtracting the onset costs up to 5 s * 1.1e-16, times a slope of 13 per second


def test_a_cycle_has_no_torque_before_its_onset():
    torque = cycle(-5.39, 1.8, 1 / 1.8, onset=2.0)
    assert (torque(jnp.linspace(-4, 2, 601)) == 0).all()
    assert (torque(jnp.linspace(2.01, 2.89, 89)) > 0).all()


def test_a_measured_torque_goes_through_its_samples_and_straight_between_them():
    time = np.array([0.0, 0.1, 0.15, 0.4])
    torque = np.array([1.0, -2.0, 4.0, 0.5])
    measured = MeasuredTorque(jnp.array(time), jnp.array(torque))
    np.testing.assert_array_equal(measured(jnp.array(time)), torque)
    middle = (time[:-1] + time[1:]) / 2
    np.testing.assert_allclose(
        measured(jnp.array(middle)), (torque[:-1] + torque[1:]) / 2, rtol=1e-14
    )


def test_a_measured_torque_is_held_beyond_its_samples():
    measured = MeasuredTorque(jnp.array([0.0, 1.0]), jnp.array([3.0, -1.0]))
    assert measured(jnp.array([-5.0, 0.0, 1.0, 9.0])).tolist() == [3.0, 3.0, -1.0, -1.0]


def test_a_measured_torque_depends_linearly_on_its_samples():
    knots, time = jnp.linspace(0, 1, 6), jnp.linspace(0, 1, 41)
    slope = jax.jacobian(lambda torque: MeasuredTorque(knots, torque)(time))(jnp.ones(6))
    np.testing.assert_allclose(slope.sum(1), 1.0, rtol=1e-14)  # the weights of the two neighbours
    assert (jnp.count_nonzero(slope, axis=1) <= 2).all()


def test_no_torque_is_zero():
    time = jnp.linspace(0, 1, 5)
    assert not NoTorque()(time).any()
