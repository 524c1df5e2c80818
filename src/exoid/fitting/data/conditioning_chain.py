"""What conditioning did to the data is done to the simulation too, sample by sample."""

from abc import abstractmethod

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import PyTree

from exoid.physics.state import LegState
from exoid.recordings.filter.constants import MEASUREMENT_NOISE, PROCESS_NOISE

RECURSIONS = 500  # of the covariance; it settles within 100


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


class SteadyKalman(Chain):
    """The firmware's filter once its covariance has settled: x <- A x, x <- x + K (z - x)."""

    time_step: float = eqx.field(static=True)  # s, what the filter takes for its step

    def begin(self, start: LegState) -> PyTree:
        return jnp.stack([start.angle, start.angular_velocity, jnp.zeros_like(start.angle)])

    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        predicted = jnp.asarray(transition(self.time_step)) @ memory
        measured = jnp.stack([state.angle, state.angular_velocity])
        gain = jnp.asarray(steady_gain(self.time_step))
        memory = predicted + gain @ (measured - predicted[:2])
        return memory, LegState(memory[0], memory[1])


def transition(step: float) -> np.ndarray:
    """A of Eq. 1."""
    return np.array([[1.0, step, step**2 / 2], [0.0, 1.0, step], [0.0, 0.0, 1.0]])


def steady_gain(step: float) -> np.ndarray:
    """The gain (state, measurement) to which the firmware's filter converges, by its Riccati
    recursion; 0.25 s bring it within a thousandth.
    """
    after, see = transition(step), np.eye(2, 3)
    covariance = np.eye(3)
    gain = np.zeros((3, 2))
    for _ in range(RECURSIONS):
        covariance = after @ covariance @ after.T + np.diag(PROCESS_NOISE)
        gain = (
            covariance
            @ see.T
            @ np.linalg.inv(see @ covariance @ see.T + np.diag(MEASUREMENT_NOISE))
        )
        covariance = covariance - gain @ see @ covariance
    return gain
