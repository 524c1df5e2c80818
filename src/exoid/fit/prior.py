"""What is believed of a leg before it moves."""

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import LegParameters


class Prior(eqx.Module):
    """Expected parameters and their standard deviations; an infinite one says nothing."""

    expected: LegParameters
    standard_deviation: LegParameters
    weight: Float[Array, ""]  # lambda of Eq. 11


def prior_residual(prior: Prior, leg: LegParameters) -> Float[Array, " parameter"]:
    """sqrt(lambda) (P - P_exp) / sd, the second term of Eq. 11 in standardised units."""
    each = jax.tree.map(
        lambda value, expected, sd: (value - expected) / sd,
        leg,
        prior.expected,
        prior.standard_deviation,
    )
    return jnp.sqrt(prior.weight) * jnp.stack(jax.tree.leaves(each))
