"""Chains that move through a density of about unit scale, all by the same adapted step."""

from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float, PRNGKeyArray

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.errors.posterior_density import Target, log_density
from exoid.fitting.solve.ask import BATCH

ACCEPTANCE = 0.8  # of NUTS, towards which its step is adapted
FIRST_STEP = 0.5  # in standard deviations


class Draws(NamedTuple):
    """What the chains went through, draw by draw."""

    place: Float[Array, "draw chain direction"]
    diverging: Bool[Array, "draw chain"]
    acceptance: Float[Array, "draw chain"]


@partial(jax.jit, static_argnames=("chain", "warmup", "draws"))
def move_chains(
    target: Target,
    begin: Float[Any, "chain direction"],
    key: PRNGKeyArray,
    *,
    chain: Chain,
    warmup: int,
    draws: int,
) -> Draws:
    """NUTS in coordinates of unit scale; during the warm-up all chains adapt one step."""
    from blackjax.adaptation.step_size import dual_averaging_adaptation
    from blackjax.mcmc import nuts

    density = partial(log_density, target, chain)
    kernel: Any = nuts.build_kernel()  # its annotations know no arrays
    unit = jnp.ones(begin.shape[1])
    first, adapt, final = dual_averaging_adaptation(ACCEPTANCE)

    lanes = max(1, BATCH // target.observation.time.shape[0])
    together = partial(jax.lax.map, batch_size=min(lanes, begin.shape[0]))

    def move(carry, number):
        states, adapted = carry
        warm = number < warmup
        step = jnp.where(warm, jnp.exp(adapted.log_step_size), final(adapted))
        keys = jax.random.split(jax.random.fold_in(key, number), begin.shape[0])
        states, seen = together(lambda one: kernel(*one, density, step, unit), (keys, states))
        after = adapt(adapted, seen.acceptance_rate.mean())
        adapted = jax.tree.map(partial(jnp.where, warm), after, adapted)
        ends = (seen.trajectory_leftmost_state, seen.trajectory_rightmost_state)
        beyond = jnp.isneginf(jnp.minimum(*(end.logdensity for end in ends)))
        drawn = Draws(states.position, seen.is_divergent & ~beyond, seen.acceptance_rate)
        return (states, adapted), drawn

    states = together(partial(nuts.init, logdensity_fn=density), begin)
    _, drawn = jax.lax.scan(move, (states, first(FIRST_STEP)), jnp.arange(warmup + draws))
    return jax.tree.map(lambda leaf: leaf[warmup:], drawn)
