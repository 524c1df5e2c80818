"""What conditioning did to the data is done to the simulation too, sample by sample."""

from abc import abstractmethod
from functools import cache

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import PyTree

from exoid.physics.state import LegState
from exoid.recordings.filter.constants import DESIGNS, UNTOLD

RECURSIONS = 5_000  # of the covariance: 50 s; that of the bias settles in 3 s
SEEN = np.array([[1.0, 0, 0, 0], [0, 1, 0, 1]])  # angle; velocity and bias of the gyro


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
    """The firmware's filter once its covariance has settled: x <- A x, x <- x + K (z - H x).

    It begins with no bias of the gyro: what a node had learned of one is in its log no more. In the
    first 5 s after its start a node that still learns takes more for bias: 5 mrad/s at 1.5 s where
    the gyro's scale is 1 % off, which moved the ratios of simulated drops by less than 0.05 %.
    """

    time_step: float = eqx.field(static=True)  # s, what the filter takes for its step
    design: str = eqx.field(static=True, default=UNTOLD)  # of `DESIGNS`

    def begin(self, start: LegState) -> PyTree:
        nothing = jnp.zeros_like(start.angle)
        return jnp.stack([start.angle, start.angular_velocity, nothing, nothing])

    def push(self, memory: PyTree, state: LegState) -> tuple[PyTree, LegState]:
        predicted = jnp.asarray(transition(self.time_step)) @ memory
        measured = jnp.stack([state.angle, state.angular_velocity])
        gain = jnp.asarray(steady_gain(self.time_step, self.design))
        memory = predicted + gain @ (measured - jnp.asarray(SEEN) @ predicted)
        return memory, LegState(memory[0], memory[1])


def transition(step: float) -> np.ndarray:
    """A of Eq. 1, where a bias of the gyro stays."""
    return np.array(
        [
            [1.0, step, step**2 / 2, 0.0],
            [0.0, 1.0, step, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [0.0] * 3 + [1.0],
        ]
    )


@cache
def steady_gain(step: float, design: str) -> np.ndarray:
    """The gain (state, measurement) to which the firmware's filter converges, by its Riccati
    recursion; of the motion 0.25 s bring it within a thousandth.
    """
    after, noise = transition(step), DESIGNS[design]
    covariance = np.diag(noise.start_variance)
    gain = np.zeros((4, 2))
    for _ in range(RECURSIONS):
        covariance = after @ covariance @ after.T + np.diag(noise.process_noise)
        seen = SEEN @ covariance @ SEEN.T + np.diag(noise.measurement_noise)
        gain = covariance @ SEEN.T @ np.linalg.inv(seen)
        covariance = covariance - gain @ SEEN @ covariance
    return gain
