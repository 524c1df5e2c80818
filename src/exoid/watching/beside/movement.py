"""Movements that a person could make next, and the samples that the node would then send."""

from dataclasses import dataclass
from functools import cache
from math import degrees

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.watching.estimate.load import BARE, Mass
from exoid.watching.estimate.online import Belief

STEP = 0.01  # s, by which a movement is made
HELD, FREE = 0.6, 6.0  # s: a rest that is seen as one, and a drop
LATER = 1.0  # s after what was seen: a gap, after which nothing is taken to go on
SEED = 1  # of the noise: what is advised depends on the belief alone


@dataclass(frozen=True)
class Movement:
    """A drop from an angle [rad] at which the leg is held, with a mass on it."""

    hold: float
    mass: Mass = BARE

    @property
    def words(self) -> str:
        mass = self.mass
        loaded = f" with {mass.weight:g} kg at {mass.distance:g} m" if mass.weight else ""
        return f"let it drop from {degrees(self.hold):.0f} deg{loaded}"


def samples_of(movement: Movement, belief: Belief, model: Model, after: float) -> Sample:
    """What the sensors would send of it after the time `after` [s], as the leg with that mass is
    believed to be: as often as they do, and no rate where there is no gyro.
    """
    from exoid.online.belief import knowledge_of

    held, free = (round(each / STEP) for each in (HELD, FREE))
    known = knowledge_of(belief, model).filters.mean[0]
    time = after + LATER + STEP * np.arange(held + free)
    start = np.concatenate([known[:-2], [movement.hold, 0.0]])
    with jax.enable_x64(True):
        fallen = np.asarray(falling(model)(start, free))
    still = np.full((held, 2), [movement.hold, known[bias_in(model)]])
    noise = np.random.default_rng(SEED).normal(size=(held + free, 2))
    node = model.node
    shown = np.concatenate([still, fallen]) + noise * [node.angle_noise, node.velocity_noise]
    rate = shown[:, 1] if node.gyro else np.full(len(shown), np.nan)
    sent = slice(None, None, max(1, round(node.period / STEP)))
    return Sample(time[sent], shown[sent, 0], rate[sent])


def bias_in(model: Model) -> int:
    """Where in a row the gyro's bias stands."""
    return model.unknowns.names.index("gyro_bias")


@cache
def falling(model: Model):
    """The compiled function from a row to encoder and gyro, step by step."""

    from exoid.online.filter.motion import Span, advance, view

    def fall(start: Float[jax.Array, " unknown"], steps: int):
        sample = Sample(jnp.zeros(()), 0.0, 0.0)
        span = Span(jnp.asarray(STEP), jnp.zeros(()))

        def one(row, _):
            arrived = advance(model.unknowns, row, sample, span)
            row = jnp.concatenate([row[:-2], arrived.state])
            return row, view(model.unknowns, row, sample).shown

        return jax.lax.scan(one, start, length=steps)[1]

    return jax.jit(fall, static_argnums=1)
