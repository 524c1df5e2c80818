"""What the node's AS5600 encoder and LSM6DS3 inertial sensor report of a true motion.

Noise comes before quantisation, as in the parts. Every sensor is good by default; its faults are
fields that are zero, and `AS_BUILT` has those of every node. One key gives one outcome.
"""

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float, Int, PRNGKeyArray

from exoid.physics.leg import GRAVITY

DEGREE = jnp.pi / 180  # rad
STANDARD_GRAVITY = 9.80665  # m/s^2, in which the accelerometer's mg are counted
FULL_SCALE = 2**15  # counts of a signed 16-bit word
TICK = 0.01  # s, the firmware's sample time
OUTPUT_RATE = 833  # Hz, at which the firmware has the LSM6DS3 renew its samples
OFF_RATE = 0.03  # by which the chip's own oscillator may be off

Samples = Float[Array, " time"]
Counts = Int[Array, " time"]


class ShownMotion(eqx.Module):
    """A stretch of motion on a grid of equal steps, as encoder and gyro are shown it."""

    angle: Samples  # rad
    angular_velocity: Samples  # rad/s
    angular_acceleration: Samples  # rad/s^2


class Encoder(eqx.Module):
    """AS5600: 4096 counts per turn, count 2048 is 0 rad.

    Noise: 0.043 deg rms with the fast 2x filter, 0.030 deg with 4x (AS5600 data sheet).
    An off-centre magnet adds `eccentricity` sin(phi); real ones reach 1 deg.
    """

    noise: float = 0.043 * DEGREE  # rad, standard deviation before quantisation
    counts_per_turn: int = eqx.field(static=True, default=4096)
    offset: float = 0.0  # rad
    eccentricity: float = 0.0  # rad
    missing: float = 0.0  # share of the samples that are lost

    @property
    def step(self) -> float:
        """One count [rad]."""
        return 2 * jnp.pi / self.counts_per_turn

    def count(self, angle: Samples, key: PRNGKeyArray) -> Counts:
        """The counts that the part sends, 0 .. 4095."""
        seen = angle + self.offset + self.eccentricity * jnp.sin(angle)
        noisy = seen + self.noise * jax.random.normal(key, angle.shape, angle.dtype)
        counts = jnp.round(noisy / self.step).astype(int) + self.counts_per_turn // 2
        return counts % self.counts_per_turn

    def angle(self, counts: Counts) -> Float[Array, " time"]:
        """The angle [rad] that counts stand for, continuous across the seam of the turn."""
        centred = (counts - self.counts_per_turn // 2) * self.step
        return jnp.unwrap(centred)

    def measure(self, angle: Samples, key: PRNGKeyArray) -> Samples:
        """The angle [rad] as it is logged, NaN where a sample was lost."""
        noise_key, loss_key = jax.random.split(key)
        measured = self.angle(self.count(angle, noise_key))
        lost = jax.random.uniform(loss_key, angle.shape) < self.missing
        return jnp.where(lost, jnp.nan, measured)


class Gyroscope(eqx.Module):
    """LSM6DS3 at +-2000 deg/s: 7 mdps per root hertz, 70 mdps per count (data sheet).

    Stock Arduino code scaled by 61.035 mdps instead of 70, which is `scale` = 0.872.
    """

    noise_density: float = 7e-3 * DEGREE  # rad/s per root hertz
    bandwidth: float = 208.0  # Hz; the noise of an output data rate of twice that
    renewal: float = 0.0  # s between the chip's own samples, or 0 where each is taken at its tick
    step: float = 70e-3 * DEGREE  # rad/s, one count
    bias: float = 0.0  # rad/s; a new part may have 10 deg/s
    scale: float = 1.0

    @property
    def noise(self) -> float:
        """Standard deviation before quantisation [rad/s]."""
        return self.noise_density * self.bandwidth**0.5

    def age(self, samples: int, key: PRNGKeyArray) -> Samples:
        """How old the chip's newest sample is when the node reads it [s], 0 to `renewal`.

        The chip samples by an oscillator of its own, so that the age wanders from tick to tick.
        """
        off, phase = jax.random.uniform(key, (2,))
        period = self.renewal * (1 + OFF_RATE * (2 * off - 1))
        return (phase * period + TICK * jnp.arange(samples)) % period

    def sampled(self, motion: ShownMotion, key: PRNGKeyArray) -> Samples:
        """The rate [rad/s] with which the chip turned when it took what the node reads."""
        if self.renewal == 0:
            return motion.angular_velocity
        age = self.age(motion.angle.size, key)
        return motion.angular_velocity - age * motion.angular_acceleration

    def measure(self, angular_velocity: Samples, key: PRNGKeyArray) -> Samples:
        """The rate [rad/s] as it is logged."""
        true = self.scale * angular_velocity + self.bias
        return quantise(true, self.noise, self.step, key)


class Accelerometer(eqx.Module):
    """LSM6DS3 at +-4 g: 90 ug per root hertz, 0.122 mg per count (data sheet).

    It sits on the shank, `distance` from the knee, x towards the foot, z in the direction of
    extension, and feels specific force: at rest it reads the reaction to gravity.
    """

    distance: float = 0.20  # m
    noise_density: float = 90e-6 * STANDARD_GRAVITY  # m/s^2 per root hertz
    bandwidth: float = 208.0  # Hz
    step: float = 0.122e-3 * STANDARD_GRAVITY  # m/s^2, one count
    bias_x: float = 0.0  # m/s^2; a new part may have 0.4
    bias_z: float = 0.0  # m/s^2

    @property
    def noise(self) -> float:
        """Standard deviation before quantisation [m/s^2]."""
        return self.noise_density * self.bandwidth**0.5

    def specific_force(self, motion: ShownMotion) -> tuple[Samples, Samples]:
        """a_x = -r phi'^2 + g sin(phi), a_z = r phi'' + g cos(phi) [m/s^2]."""
        along = -self.distance * motion.angular_velocity**2 + GRAVITY * jnp.sin(motion.angle)
        across = self.distance * motion.angular_acceleration + GRAVITY * jnp.cos(motion.angle)
        return along, across

    def measure(self, motion: ShownMotion, key: PRNGKeyArray) -> tuple[Samples, Samples]:
        """a_x and a_z [m/s^2] as they are logged."""
        along, across = self.specific_force(motion)
        key_x, key_z = jax.random.split(key)
        return (
            quantise(along + self.bias_x, self.noise, self.step, key_x),
            quantise(across + self.bias_z, self.noise, self.step, key_z),
        )


class SensorKit(eqx.Module):
    """The sensors of one exoskeleton."""

    encoder: Encoder = Encoder()
    gyroscope: Gyroscope = Gyroscope()
    accelerometer: Accelerometer = Accelerometer()


# As the firmware sets the chips up: noise of 833 Hz, samples up to 1.2 ms old, a zero-rate level
# within the 10 deg/s of the data sheet.
AS_BUILT = SensorKit(
    gyroscope=Gyroscope(bandwidth=OUTPUT_RATE / 2, renewal=1 / OUTPUT_RATE, bias=0.05),
    accelerometer=Accelerometer(bandwidth=OUTPUT_RATE / 2),
)


class Readings(eqx.Module):
    """What the sensors report of a motion, sample by sample."""

    angle: Samples  # rad
    angular_velocity: Samples  # rad/s
    acceleration_x: Samples  # m/s^2, along the shank
    acceleration_z: Samples  # m/s^2, across it


def measure(kit: SensorKit, motion: ShownMotion, key: PRNGKeyArray) -> Readings:
    """The readings of every sensor; the noise of each is independent."""
    encoder_key, gyro_key, force_key = jax.random.split(key, 3)
    rate = kit.gyroscope.sampled(motion, jax.random.fold_in(gyro_key, 1))
    return Readings(
        kit.encoder.measure(motion.angle, encoder_key),
        kit.gyroscope.measure(rate, gyro_key),
        *kit.accelerometer.measure(motion, force_key),
    )


def quantise(true: Samples, noise: float, step: float, key: PRNGKeyArray) -> Samples:
    """White noise, then the nearest count of a signed 16-bit word, which ends at its full scale."""
    noisy = true + noise * jax.random.normal(key, true.shape, true.dtype)
    return step * jnp.clip(jnp.round(noisy / step), -FULL_SCALE, FULL_SCALE - 1)
