"""The firmware's Kalman filter (Eq. 1-2, and the gyro's bias) as a pure function.

The order of operations is the firmware's: predict, then the angle, then the rate, each a scalar
update on the ten distinct elements of P. Sums run from left to right as written, nothing is
refactored, and the same text in C++ `float` gives the same bits as NumPy `float32`.
"""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.recordings.filter.constants import OF_NODE, Design

Samples = Float[Array | np.ndarray, " time"]
Steps = Float[Array | np.ndarray, " steps"]  # s, from each sample to the next
# angle rad, velocity rad/s, acceleration rad/s^2, bias of the gyro rad/s
State = tuple[Float[Array, "*time"], ...]
Covariance = tuple[Float[Array, "*time"], ...]  # p00 p01 p02 p03 p11 p12 p13 p22 p23 p33


class Filtered(eqx.Module):
    """What the filter believes after each sample, and how far each measurement surprised it.

    The rate's innovation is taken after the angle's update, so the two columns are independent.
    NaN where nothing was measured, and at the first sample, from which the filter starts.
    """

    state: Float[Array, "time 3"]  # rad, rad/s, rad/s^2
    bias: Float[Array, " time"]  # rad/s
    covariance: Float[Array, "time 4 4"]
    innovation: Float[Array, "time 2"]  # rad, rad/s
    innovation_variance: Float[Array, "time 2"]  # rad^2, (rad/s)^2


@eqx.filter_jit
def filter(
    time_step: Steps, angle: Samples, angular_velocity: Samples, design: Design = OF_NODE
) -> Filtered:
    """The states of Eq. 2 from encoder [rad] and gyro [rad/s], in the precision of `angle`.

    A NaN skips its own update only. Q is added once per step whatever the step's length, as the
    firmware does. The first sample is taken as it is: its state is the measurement, acceleration
    and bias 0.
    """
    angle = jnp.asarray(angle)
    rate, steps = (jnp.asarray(each, angle.dtype) for each in (angular_velocity, time_step))
    noise = (design.process_noise, design.measurement_noise, design.start_variance)
    q, r, unknown = (jnp.asarray(each, angle.dtype) for each in noise)

    def step(belief, given):
        length, *measured = given
        state, covariance = belief
        state, covariance = predict(state, covariance, length, q)
        state, covariance, first = correct(state, covariance, 0, measured[0], r[0])
        state, covariance, second = correct(state, covariance, 1, measured[1], r[1])
        surprise = [jnp.stack(pair) for pair in zip(first, second, strict=True)]
        return (state, covariance), (state, covariance, surprise)

    start = begin(angle[0], rate[0], r, unknown)
    _, (states, covariances, surprise) = jax.lax.scan(step, start, (steps, angle[1:], rate[1:]))
    state, covariance = jax.tree.map(
        lambda first, rest: jnp.concatenate([first[None], rest]), start, (states, covariances)
    )
    first = jnp.full((1, 2), jnp.nan, angle.dtype)
    innovation, variance = (jnp.concatenate([first, rest]) for rest in surprise)
    *motion, bias = state
    return Filtered(jnp.stack(motion, -1), bias, symmetric(covariance), innovation, variance)


def begin(angle, rate, noise, unknown) -> tuple[State, Covariance]:
    """The belief after the first sample alone: what was measured, or 0 with the start's variance.

    A measured rate is off by the bias, so the two are believed to be opposite.
    """
    zero = jnp.zeros_like(angle)
    blind, still = jnp.isnan(angle), jnp.isnan(rate)
    state = (jnp.where(blind, 0, angle), jnp.where(still, 0, rate), zero, zero)
    p00 = jnp.where(blind, unknown[0], noise[0])
    p11 = jnp.where(still, unknown[1], noise[1] + unknown[3])
    p13 = jnp.where(still, 0, -unknown[3])
    p22, p33 = zero + unknown[2], zero + unknown[3]
    return state, (p00, zero, zero, zero, p11, zero, p13, p22, zero, p33)


def predict(state: State, covariance: Covariance, step, noise) -> tuple[State, Covariance]:
    """x = A x and P = A P A' + Q with A of Eq. 1, where the bias stays; b is A P."""
    x0, x1, x2, x3 = state
    p00, p01, p02, p03, p11, p12, p13, p22, p23, p33 = covariance
    half = 0.5 * step * step
    b00 = p00 + step * p01 + half * p02
    b01 = p01 + step * p11 + half * p12
    b02 = p02 + step * p12 + half * p22
    b03 = p03 + step * p13 + half * p23
    b11 = p11 + step * p12
    b12 = p12 + step * p22
    b13 = p13 + step * p23
    state = (x0 + step * x1 + half * x2, x1 + step * x2, x2, x3)
    return state, (
        b00 + step * b01 + half * b02 + noise[0],
        b01 + step * b02,
        b02,
        b03,
        b11 + step * b12 + noise[1],
        b12,
        b13,
        p22 + noise[2],
        p23,
        p33 + noise[3],
    )


def correct(state: State, covariance: Covariance, row: int, measured, noise):
    """One scalar measurement, of the angle (row 0) or of velocity and bias together (row 1): the
    new belief, the innovation and its variance.
    """
    x0, x1, x2, x3 = state
    p00, p01, p02, p03, p11, p12, p13, p22, p23, p33 = covariance
    if row == 0:
        c0, c1, c2, c3 = p00, p01, p02, p03
        expected, variance = x0, c0 + noise
    else:
        c0, c1, c2, c3 = p01 + p03, p11 + p13, p12 + p23, p13 + p33
        expected, variance = x1 + x3, c1 + c3 + noise
    inverse = 1.0 / variance
    g0, g1, g2, g3 = c0 * inverse, c1 * inverse, c2 * inverse, c3 * inverse
    missing = jnp.isnan(measured)
    e = jnp.where(missing, 0.0, measured) - expected
    new_state = (x0 + g0 * e, x1 + g1 * e, x2 + g2 * e, x3 + g3 * e)
    first = (p00 - g0 * c0, p01 - g0 * c1, p02 - g0 * c2, p03 - g0 * c3)
    second = (p11 - g1 * c1, p12 - g1 * c2, p13 - g1 * c3)
    new_covariance = (*first, *second, p22 - g2 * c2, p23 - g2 * c3, p33 - g3 * c3)
    old, new = (state, covariance), (new_state, new_covariance)
    state, covariance = jax.tree.map(lambda o, n: jnp.where(missing, o, n), old, new)
    return state, covariance, [jnp.where(missing, jnp.nan, s) for s in (e, variance)]


def symmetric(covariance: Covariance) -> Float[Array, "time 4 4"]:
    """P as a matrix from its ten elements."""
    p00, p01, p02, p03, p11, p12, p13, p22, p23, p33 = covariance
    rows = [[p00, p01, p02, p03], [p01, p11, p12, p13], [p02, p12, p22, p23], [p03, p13, p23, p33]]
    return jnp.stack([jnp.stack(row, axis=-1) for row in rows], axis=-2)
