"""What is believed of a leg before it moves."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Float, Inexact

from exoid.physics.leg import LegParameters


class Prior(eqx.Module):
    """Expected parameters and their standard deviations; an infinite one says nothing."""

    expected: LegParameters
    standard_deviation: LegParameters
    weight: Float[Any, ""]  # lambda of Eq. 11


def prior_residual(prior: Prior, leg: LegParameters, xp=jnp) -> Inexact[Any, " parameter *column"]:
    """sqrt(lambda) (P - P_exp) / sd, the second term of Eq. 11 in standardised units."""
    each = jax.tree.map(
        lambda value, expected, sd: (value - expected) / sd,
        leg,
        prior.expected,
        prior.standard_deviation,
    )
    return xp.sqrt(prior.weight) * xp.stack(jax.tree.leaves(each))
