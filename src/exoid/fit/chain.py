"""What conditioning did to the data is done to the simulation too."""

from abc import abstractmethod

import equinox as eqx
import jax.numpy as jnp

from exoid.physics.simulate import Trajectory


class Chain(eqx.Module):
    """A step of conditioning, as it acts on a simulated motion."""

    @abstractmethod
    def __call__(self, trajectory: Trajectory) -> Trajectory:
        """The motion as the conditioned recording would show it."""


class Raw(Chain):
    """The raw channels are fitted: nothing was done to them."""

    def __call__(self, trajectory: Trajectory) -> Trajectory:
        return trajectory
