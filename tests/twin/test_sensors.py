"""The virtual sensors against their data sheets and against mechanics."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.physics.leg import GRAVITY
from exoid.twin.sensors import (
    AS_BUILT,
    Accelerometer,
    Encoder,
    Gyroscope,
    SensorKit,
    ShownMotion,
    measure,
)

DEGREE = np.pi / 180
KEY = jax.random.key(1)
MANY = 20_000  # samples: a standard deviation is known to 0.5 %


@pytest.fixture
def swing():
    """phi = -1.2 + 0.8 sin(5 t), with exact derivatives."""
    time = jnp.arange(0, 4, 0.001)
    angle, velocity = -1.2 + 0.8 * jnp.sin(5 * time), 4.0 * jnp.cos(5 * time)
    return ShownMotion(angle, velocity, -20 * jnp.sin(5 * time))


def still(angle, samples=1000):
    nothing = jnp.zeros(samples)
    held = nothing + angle
    return ShownMotion(held, nothing, nothing)


@pytest.mark.parametrize("noise", [0.030 * DEGREE, 0.043 * DEGREE])
def test_the_encoder_adds_its_noise_and_that_of_its_counts(noise):
    angle = jnp.linspace(-2.0, 0.2, MANY)
    encoder = Encoder(noise=noise)
    error = encoder.measure(angle, KEY) - angle
    expected = np.sqrt(noise**2 + (2 * np.pi / 4096) ** 2 / 12)
    assert jnp.std(error) == pytest.approx(expected, rel=0.03)
    assert abs(jnp.mean(error)) < 4 * expected / np.sqrt(MANY)


def test_the_encoder_counts_12_bits_with_2048_at_zero():
    quiet = Encoder(noise=0.0)
    counts = quiet.count(jnp.array([0.0, np.pi / 2, -np.pi / 2, -np.pi, np.pi]), KEY)
    assert counts.tolist() == [2048, 3072, 1024, 0, 0]
    angle = jnp.linspace(-3.1, 3.1, 999)
    error = jnp.abs(quiet.measure(angle, KEY) - angle)
    assert error.max() <= quiet.step / 2 * (1 + 1e-9)


def test_the_angle_is_continuous_across_the_seam_of_the_turn():
    angle = jnp.linspace(0.0, 9.0, 500)
    assert jnp.abs(Encoder().measure(angle, KEY) - angle).max() < 6e-3


def test_the_faults_of_the_encoder_do_what_they_say():
    angle = jnp.linspace(-2.0, 0.2, MANY)
    plain = Encoder().measure(angle, KEY)
    shifted = Encoder(offset=0.05).measure(angle, KEY) - plain
    bent = Encoder(eccentricity=0.02).measure(angle, KEY) - plain
    lost = jnp.isnan(Encoder(missing=0.1).measure(angle, KEY))
    step = Encoder().step
    assert jnp.abs(shifted - 0.05).max() <= step
    assert jnp.abs(bent - 0.02 * jnp.sin(angle)).max() <= step
    assert jnp.mean(lost) == pytest.approx(0.1, abs=4 * 0.3 / np.sqrt(MANY))


def test_the_gyro_adds_its_noise_in_counts_of_70_mdps():
    rate = jnp.linspace(-5.0, 5.0, MANY)
    measured = Gyroscope().measure(rate, KEY)
    step = 0.070 * DEGREE
    expected = np.sqrt((0.007 * DEGREE * np.sqrt(208)) ** 2 + step**2 / 12)
    assert jnp.std(measured - rate) == pytest.approx(expected, rel=0.03)
    np.testing.assert_allclose(measured / step, jnp.round(measured / step), atol=1e-6)


def test_the_gyro_ends_at_its_full_scale():
    measured = Gyroscope().measure(jnp.array([50.0, -50.0]), KEY)
    np.testing.assert_allclose(measured / DEGREE, [32767 * 0.070, -32768 * 0.070])


def test_the_gyros_bias_and_scale_can_be_read_off_a_line():
    rate = jnp.linspace(-5.0, 5.0, MANY)
    faulty = Gyroscope(bias=0.03, scale=0.872).measure(rate, KEY)
    slope, offset = np.polyfit(np.asarray(rate), np.asarray(faulty), 1)
    assert slope == pytest.approx(0.872, abs=1e-4)
    assert offset == pytest.approx(0.03, abs=1e-4)


@pytest.mark.parametrize(("output_rate", "error"), [(416, 0.0194), (833, 0.0097)])
def test_a_sample_that_is_old_is_the_rate_of_its_own_time(output_rate, error):
    """Of 1 Hz and 0.5 rad: acceleration 13.96 rad/s^2 rms, age evenly spread over one period."""
    time = jnp.arange(MANY) * 0.01
    phase, turning = 2 * jnp.pi * time, 2 * jnp.pi
    motion = ShownMotion(
        0.5 * jnp.sin(phase),
        0.5 * turning * jnp.cos(phase),
        -0.5 * turning**2 * jnp.sin(phase),
    )
    gyro = Gyroscope(renewal=1 / output_rate)
    age = gyro.age(MANY, KEY)
    longest = 1.03 / output_rate  # by the chip's own oscillator
    assert 0 <= age.min() < 0.01 / output_rate
    assert 0.97 / output_rate < age.max() < longest
    old = gyro.sampled(motion, KEY)
    exact = 0.5 * turning * jnp.cos(turning * (time - age))
    assert jnp.abs(old - exact).max() < longest**2 / 2 * 0.5 * turning**3  # the bend of the rate
    rms = jnp.sqrt(jnp.mean((old - motion.angular_velocity) ** 2))
    assert rms == pytest.approx(error, rel=0.04)  # 3 % of the oscillator


def test_a_gyro_whose_samples_are_taken_at_the_ticks_has_none_that_is_old(swing):
    assert (Gyroscope().sampled(swing, KEY) == swing.angular_velocity).all()


def test_the_node_as_it_is_built_has_old_samples_and_a_bias(swing):
    read, good = measure(AS_BUILT, swing, KEY), measure(SensorKit(), swing, KEY)
    late = read.angular_velocity - good.angular_velocity - AS_BUILT.gyroscope.bias
    slope = jnp.sum(late * swing.angular_acceleration) / jnp.sum(swing.angular_acceleration**2)
    # Half a period on average; noise of 4 mrad/s over 14 rad/s^2 rms and 4000 samples is 5 us.
    assert -slope == pytest.approx(0.5 / 833, abs=5e-5)
    assert (read.angle == good.angle).all()


@pytest.mark.parametrize(("angle", "along", "across"), [(0.0, 0.0, 1.0), (-np.pi / 2, -1.0, 0.0)])
def test_at_rest_the_accelerometer_reads_the_reaction_to_gravity(angle, along, across):
    x, z = Accelerometer().measure(still(angle), KEY)
    sensor = Accelerometer()
    tolerance = 4 * sensor.noise / np.sqrt(1000) + sensor.step / 100
    assert jnp.mean(x) == pytest.approx(along * GRAVITY, abs=tolerance)
    assert jnp.mean(z) == pytest.approx(across * GRAVITY, abs=tolerance)
    assert jnp.std(x) == pytest.approx(np.hypot(sensor.noise, sensor.step / 12**0.5), rel=0.1)


def test_the_specific_force_is_the_second_derivative_of_the_position_plus_gravity(swing):
    sensor = Accelerometer(distance=0.3)
    position = sensor.distance * np.exp(1j * np.asarray(swing.angle))  # horizontal + i vertical
    step = 0.001
    second = (position[2:] - 2 * position[1:-1] + position[:-2]) / step**2
    turned = (second + 1j * GRAVITY) * np.exp(-1j * np.asarray(swing.angle[1:-1]))
    along, across = sensor.specific_force(swing)
    error = sensor.distance * step**2 / 12 * 30**4 / 4  # of the second difference, about 5 rad/s
    np.testing.assert_allclose(along[1:-1], turned.real, atol=error)
    np.testing.assert_allclose(across[1:-1], turned.imag, atol=error)


def test_a_key_decides_the_outcome_and_every_sensor_has_its_own_noise(swing):
    kit = SensorKit()
    one, again = measure(kit, swing, KEY), measure(kit, swing, KEY)
    assert eqx.tree_equal(one, again)
    force = kit.accelerometer.specific_force(swing)
    noise = [
        one.angle - swing.angle,
        one.angular_velocity - swing.angular_velocity,
        one.acceleration_x - force[0],
        one.acceleration_z - force[1],
    ]
    correlation = np.corrcoef(np.array(noise)) - np.eye(4)
    assert np.abs(correlation).max() < 4.5 / np.sqrt(swing.angle.size)
