"""The firmware's Kalman filter (Eq. 1-2) as a pure function.

The order of operations is the firmware's: predict, then the angle, then the rate, each a scalar
update on the six distinct elements of P. Sums run from left to right as written, nothing is
refactored, and the same text in C++ `float` gives the same bits as NumPy `float32`.
"""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.recordings.filter.constants import MEASUREMENT_NOISE, PROCESS_NOISE, START_VARIANCE

Samples = Float[Array | np.ndarray, " time"]
Steps = Float[Array | np.ndarray, " steps"]  # s, from each sample to the next
State = tuple[Float[Array, "*time"], ...]  # angle rad, velocity rad/s, acceleration rad/s^2
Covariance = tuple[Float[Array, "*time"], ...]  # p00 p01 p02 p11 p12 p22


class Filtered(eqx.Module):
    """What the filter believes after each sample, and how far each measurement surprised it.

    The rate's innovation is taken after the angle's update, so the two columns are independent.
    NaN where nothing was measured, and at the first sample, from which the filter starts.
    """

    state: Float[Array, "time 3"]  # rad, rad/s, rad/s^2
    covariance: Float[Array, "time 3 3"]
    innovation: Float[Array, "time 2"]  # rad, rad/s
    innovation_variance: Float[Array, "time 2"]  # rad^2, (rad/s)^2


@eqx.filter_jit
def filter(
    time_step: Steps,
    angle: Samples,
    angular_velocity: Samples,
    process_noise=PROCESS_NOISE,
    measurement_noise=MEASUREMENT_NOISE,
) -> Filtered:
    """The states of Eq. 2 from encoder [rad] and gyro [rad/s], in the precision of `angle`.

    A NaN skips its own update only. Q is added once per step whatever the step's length, as the
    firmware does. The first sample is taken as it is: its state is the measurement, acceleration 0.
    """
    angle = jnp.asarray(angle)
    given = (angular_velocity, time_step, process_noise, measurement_noise)
    rate, steps, q, r = (jnp.asarray(each, angle.dtype) for each in given)

    def step(belief, given):
        length, *measured = given
        state, covariance = belief
        state, covariance = predict(state, covariance, length, q)
        state, covariance, first = correct(state, covariance, 0, measured[0], r[0])
        state, covariance, second = correct(state, covariance, 1, measured[1], r[1])
        surprise = [jnp.stack(pair) for pair in zip(first, second, strict=True)]
        return (state, covariance), (state, covariance, surprise)

    start = begin(angle[0], rate[0], r)
    _, (states, covariances, surprise) = jax.lax.scan(step, start, (steps, angle[1:], rate[1:]))
    state, covariance = jax.tree.map(
        lambda first, rest: jnp.concatenate([first[None], rest]), start, (states, covariances)
    )
    unknown = jnp.full((1, 2), jnp.nan, angle.dtype)
    innovation, variance = (jnp.concatenate([unknown, rest]) for rest in surprise)
    return Filtered(jnp.stack(state, axis=-1), symmetric(covariance), innovation, variance)


def begin(angle, rate, noise) -> tuple[State, Covariance]:
    """The belief after the first sample alone: what was measured, or 0 with `START_VARIANCE`."""
    zero = jnp.zeros_like(angle)
    state = (jnp.where(jnp.isnan(angle), 0, angle), jnp.where(jnp.isnan(rate), 0, rate), zero)
    p00 = jnp.where(jnp.isnan(angle), START_VARIANCE[0], noise[0])
    p11 = jnp.where(jnp.isnan(rate), START_VARIANCE[1], noise[1])
    return state, (p00, zero, zero, p11, zero, zero + START_VARIANCE[2])


def predict(state: State, covariance: Covariance, step, noise) -> tuple[State, Covariance]:
    """x = A x and P = A P A' + Q with A of Eq. 1; b is A P."""
    x0, x1, x2 = state
    p00, p01, p02, p11, p12, p22 = covariance
    half = 0.5 * step * step
    b00 = p00 + step * p01 + half * p02
    b01 = p01 + step * p11 + half * p12
    b02 = p02 + step * p12 + half * p22
    b11 = p11 + step * p12
    b12 = p12 + step * p22
    state = (x0 + step * x1 + half * x2, x1 + step * x2, x2)
    return state, (
        b00 + step * b01 + half * b02 + noise[0],
        b01 + step * b02,
        b02,
        b11 + step * b12 + noise[1],
        b12,
        p22 + noise[2],
    )


def correct(state: State, covariance: Covariance, row: int, measured, noise):
    """One scalar measurement of `state[row]`: the new belief, the innovation and its variance."""
    x0, x1, x2 = state
    p00, p01, p02, p11, p12, p22 = covariance
    c0, c1, c2 = (p00, p01, p02) if row == 0 else (p01, p11, p12)
    variance = (c0 if row == 0 else c1) + noise
    inverse = 1.0 / variance
    g0, g1, g2 = c0 * inverse, c1 * inverse, c2 * inverse
    missing = jnp.isnan(measured)
    innovation = jnp.where(missing, 0.0, measured) - state[row]
    new_state = (x0 + g0 * innovation, x1 + g1 * innovation, x2 + g2 * innovation)
    new_covariance = (
        p00 - g0 * c0,
        p01 - g0 * c1,
        p02 - g0 * c2,
        p11 - g1 * c1,
        p12 - g1 * c2,
        p22 - g2 * c2,
    )
    old, new = (state, covariance), (new_state, new_covariance)
    state, covariance = jax.tree.map(lambda o, n: jnp.where(missing, o, n), old, new)
    return state, covariance, [jnp.where(missing, jnp.nan, s) for s in (innovation, variance)]


def symmetric(covariance: Covariance) -> Float[Array, "time 3 3"]:
    """P as a matrix from its six elements."""
    p00, p01, p02, p11, p12, p22 = covariance
    rows = [[p00, p01, p02], [p01, p11, p12], [p02, p12, p22]]
    return jnp.stack([jnp.stack(row, axis=-1) for row in rows], axis=-2)
