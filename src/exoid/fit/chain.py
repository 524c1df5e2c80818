"""What conditioning did to the data is done to the simulation too, sample by sample."""

from abc import abstractmethod

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float, PyTree

from exoid.physics.state import LegState


class Chain(eqx.Module):
    """A linear filter that runs beside the simulation, with a memory of its own."""

    @abstractmethod
    def begin(self, start: LegState) -> PyTree:
        """The memory before the first sample."""

    @abstractmethod
    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        """Take in a sample; give the memory afterwards and what comes out."""


class Raw(Chain):
    """The raw channels are fitted: nothing was done to them."""

    def begin(self, start: LegState) -> PyTree:
        return ()

    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        return memory, state


class MovingAverage(Chain):
    """Eq. 3: the mean of the last `window` samples, as the data's windows end at each sample."""

    window: int = eqx.field(static=True)

    def begin(self, start: LegState) -> PyTree:
        held = jnp.stack([start.angle, start.angular_velocity])
        return jnp.broadcast_to(held, (self.window, 2))

    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        newest = jnp.stack([state.angle, state.angular_velocity])
        memory = jnp.concatenate([memory[1:], newest[None]])
        mean = memory.mean(axis=0)
        return memory, LegState(mean[0], mean[1])


class SettledKalman(Chain):
    """The firmware's filter once its covariance has settled: x <- A x, x <- x + K (z - x)."""

    transition: Float[Array, "3 3"]
    gain: Float[Array, "3 2"]

    def begin(self, start: LegState) -> PyTree:
        return jnp.stack([start.angle, start.angular_velocity, jnp.zeros_like(start.angle)])

    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        predicted = self.transition @ memory
        measured = jnp.stack([state.angle, state.angular_velocity])
        memory = predicted + self.gain @ (measured - predicted[:2])
        return memory, LegState(memory[0], memory[1])
