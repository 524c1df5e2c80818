"""What is believed of a leg before it moves."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float, Inexact

from exoid.fit.coordinates import Mounting
from exoid.physics.leg import LegParameters


class Prior(eqx.Module):
    """Expected parameters and their standard deviations; an infinite one says nothing."""

    expected: LegParameters
    standard_deviation: LegParameters
    weight: Float[Any, ""]  # lambda of Eq. 11
    mounting: Mounting | None = None  # standard deviations of what recordings own


def prior_residual(prior: Prior, leg: LegParameters, xp=jnp) -> Inexact[Any, " parameter *column"]:
    """sqrt(lambda) (P - P_exp) / sd, the second term of Eq. 11 in standardised units."""
    each = jax.tree.map(
        lambda value, expected, sd: (value - expected) / sd,
        leg,
        prior.expected,
        prior.standard_deviation,
    )
    return xp.sqrt(prior.weight) * xp.stack(jax.tree.leaves(each))


def log_jacobian(prior: Prior, leg: LegParameters, xp=jnp) -> Inexact[Any, "*column"]:
    """log |d (m, J, l, d, c) / d (log m, log J, m l g / J, d / J, c / J)|, up to a constant.

    A prior is a density in m, J, l, d and c, draws are made in the fit's coordinates. The parts are
    m, J, J / (m g), J and J. Where the prior says nothing, the coordinates are as good.
    """
    says = xp.isfinite(xp.stack(jax.tree.leaves(prior.standard_deviation))).all() & (
        prior.weight > 0
    )
    return xp.where(says, 4 * xp.log(leg.inertia), 0.0)


def draw(prior: Prior, rng: np.random.Generator) -> LegParameters:
    """A leg as the prior has it, whatever the limits say."""
    return jax.tree.map(
        lambda expected, sd: np.asarray(rng.normal(expected, sd / np.sqrt(prior.weight))),
        prior.expected,
        prior.standard_deviation,
    )


def mounting_residual(
    prior: Prior, mounting: Mounting, xp=jnp
) -> Inexact[Any, " mounting *column"]:
    """value / sd of what recordings own: they are expected to be as declared."""
    if prior.mounting is None:
        return xp.zeros((0, *mounting.zero.shape[1:]))
    each = jax.tree.map(lambda value, sd: (value.T / sd).T, mounting, prior.mounting)
    return xp.concatenate(jax.tree.leaves(each))
