"""The misfit of a segment and its derivatives, condensed to as many numbers as it has unknowns.

With J = QR the residual r may be replaced by (R dz + Q'r, |r - QQ'r|): the same misfit, gradient
and Gauss-Newton matrix in 8 numbers instead of two per sample. A joint fit of many segments
becomes a small dense problem, and R and Q'r are what the standard errors need.
"""

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float

from exoid.fit.chain import Chain
from exoid.fit.coordinates import TYPICAL, Coordinates, Own, Shared
from exoid.fit.observation import Observation
from exoid.fit.residual import misfit

UNKNOWNS = 7  # of one segment: four that the leg owns, three of its own
ROUNDING = 1e-13  # relative, keeps the Cholesky factor real where two columns are nearly parallel


class Condensed(eqx.Module):
    """R, Q'r and the rest of one segment's residual, in units of noise and of `TYPICAL`."""

    factor: Float[Array, "*batch unknown unknown"]
    projection: Float[Array, "*batch unknown"]
    remainder: Float[Array, "*batch"]


def condense(
    shared: Shared,
    own: Own,
    observation: Observation,
    known: Float[Array, " unknown"],
    tether: Float[Array, ""],
    chain: Chain,
) -> Condensed:
    """Simulate one segment with its sensitivities. `known` is 1 for unknowns that play no part."""
    point, unravel = ravel_pytree((shared, own))
    unit, _ = ravel_pytree((TYPICAL.shared, TYPICAL.own))

    def residual(scaled):
        at_shared, at_own = unravel(scaled * unit)
        return misfit(at_shared, at_own, observation, tether, chain)

    value, push = jax.linearize(residual, point / unit)
    columns = jax.vmap(push)(jnp.diag(1 - known))
    normal = columns @ columns.T
    # A known one stands apart from the rest: 1 on the diagonal to factorise, 0 afterwards.
    normal = normal + jnp.diag(ROUNDING * jnp.diag(normal) + known)
    lower = jnp.linalg.cholesky(normal)
    projection = jax.scipy.linalg.solve_triangular(lower, columns @ value, lower=True)
    remainder = jnp.sqrt(jnp.maximum(value @ value - projection @ projection, 0.0))
    return Condensed(lower.T * (1 - known), projection, remainder)


def linear_model(
    condensed: Condensed, at: Coordinates, to: Coordinates
) -> Float[Array, " residual"]:
    """The condensed residual at `to`, by its linear model around `at` (all scaled)."""
    change = jax.tree.map(jnp.subtract, to, at)
    shared = jnp.stack(jax.tree.leaves(change.shared))
    own = jnp.stack(jax.tree.leaves(change.own), axis=-1)
    each = jnp.concatenate([jnp.broadcast_to(shared, (own.shape[0], shared.size)), own], axis=1)
    predicted = condensed.projection + jnp.einsum("kij,kj->ki", condensed.factor, each)
    return jnp.concatenate([predicted.ravel(), condensed.remainder])
