"""The voluntary torque of Eq. 10 for unit amplitude."""

import jax.numpy as jnp


def cycle_shape(time, period, frequency, xp=jnp):
    """Eq. 10 for unit amplitude, 0 before the cycle's clock starts; `xp` is jax.numpy or numpy."""
    sine = xp.sin(2 * xp.pi * frequency * time)
    return xp.where(time < 0, 0.0, xp.where(time <= period / 2, -sine, sine))
