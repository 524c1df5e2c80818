"""The objective of a fit as a plain function of the raw parameters of Eq. 13, for SciPy."""

from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.residual import predict, residual
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.belief import NAMES
from exoid.fitting.model.constraint import NEVER, SIZE, SIZE_TORQUE, constraint_names, violations
from exoid.fitting.model.coordinates import (
    TYPICAL,
    Coordinates,
    Mounting,
    Own,
    Shared,
    leg_parameters,
    scaled,
    torque_amplitudes,
)
from exoid.fitting.model.prior import Prior, mounting_residual, prior_residual
from exoid.fitting.multistart.starts import first_state, usual_mounting
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import GRAVITY
from exoid.physics.state import LegState

LEG = 5  # m, J, l, d, c come first in a vector
TRUE = np.zeros(3)  # a sensor map that changes nothing
POSITIVE = 1e-3  # of its typical size: mass and inertia have a logarithm


@dataclass(frozen=True, eq=False)
class Objective:
    """What SLSQP sees: functions of (m, J, l, d, c, tau, states), each over its typical size.

    After them comes what the recording owns, as far as it is not known.
    """

    problem: Problem
    scale: float  # the noise is this much larger than the sensors'
    bounded: bool  # with prior and limits, or the data alone

    def cost(self, vector: np.ndarray) -> float:
        """Half the sum of squares of data and prior."""
        prior = self.problem.belief.prior
        point = self.point(vector)
        data, belief = squares(point, self.seen, prior, self.stage, self.problem.chain)
        declared = float(np.sum(mounting_residual(prior, point.mounting, np) ** 2))
        return float(data / self.scale**2 + self.bounded * belief + declared) / 2

    def slack(self, vector: np.ndarray) -> np.ndarray:
        """What is left of every limit, negative where it is violated."""
        positive = vector[:2] - POSITIVE
        if not self.bounded:
            return positive
        limits, point = self.problem.belief.limits, self.point(vector)
        limit = violations(limits, leg_parameters(point, np), torque_amplitudes(point, np), np)
        held = [name in self.fixed for name in constraint_names(len(self.problem.movements))]
        return np.concatenate([-np.where(held, NEVER, limit), positive])

    @cached_property
    def fixed(self) -> dict[str, float]:
        """What does not move."""
        return dict(self.problem.belief.by_hand.fix) if self.bounded else {}

    @cached_property
    def axes(self) -> np.ndarray:
        """The directions in which a vector may move: (entry, direction)."""
        free = np.ones(self.sizes.size, dtype=bool)
        free[[NAMES.index(name) for name in self.fixed]] = False
        return np.eye(free.size)[:, free]

    @cached_property
    def samples(self) -> int:
        """The number of measured values that are fitted."""
        seen = self.problem.observation
        return int(np.sum(seen.angle_weight > 0) + np.sum(seen.velocity_weight > 0))

    @cached_property
    def seen(self) -> Observation:
        return jax.device_put(self.problem.observation)

    @cached_property
    def stage(self) -> Stage:
        return Stage(np.asarray(0.0), np.asarray(self.problem.steps))

    @cached_property
    def usual(self) -> Mounting:
        return usual_mounting(self.problem.movements, owned=self.problem.owned)

    @cached_property
    def voluntary(self) -> list[int]:
        return [n for n, each in enumerate(self.problem.movements) if each.voluntary]

    @cached_property
    def sizes(self) -> np.ndarray:
        """What a vector is divided by."""
        segments = len(self.problem.movements)
        torques = [SIZE_TORQUE] * len(self.voluntary)
        states = [TYPICAL.own.angle] * segments + [TYPICAL.own.angular_velocity] * segments
        owned = [getattr(TYPICAL.mounting, name) for name in self.owned]
        return np.array([*jax.tree.leaves(SIZE), *torques, *states, *owned], dtype=float)

    @cached_property
    def owned(self) -> list[str]:
        """The unknowns of the one recording's mounting."""
        known = self.problem.known[:, 4:-3].min(axis=0)
        return [name for name, at in zip(self.problem.owned, known, strict=True) if not at]

    def point(self, vector: np.ndarray) -> Coordinates:
        """The vector in the coordinates in which the misfit is written."""
        segments = len(self.problem.movements)
        values, owned = np.split(vector * self.sizes, [vector.size - len(self.owned)])
        mass, inertia, com_distance, damping, stiffness = (np.asarray(v) for v in values[:LEG])
        log_mass, log_inertia = logarithms(mass, inertia)
        torque = np.zeros(segments)
        torque[self.voluntary] = values[LEG : -2 * segments]
        shared = Shared(
            log_inertia=log_inertia,
            gravity=mass * com_distance * GRAVITY / inertia,
            stiffness=stiffness / inertia,
            damping=damping / inertia,
        )
        own = Own(torque / inertia, values[-2 * segments : -segments], values[-segments:])
        mounting = replace(self.usual, **dict(zip(self.owned, owned[:, None], strict=True)))
        return Coordinates(shared, log_mass, mounting, own)

    def vector(self, start: np.ndarray) -> np.ndarray:
        """The start (m, J, l, d, c, tau), every movement from its first measured state."""
        states = np.array([first_state(each) for each in self.problem.movements])
        torques = [start[LEG]] * len(self.voluntary)
        leg = [self.fixed.get(name, value) for name, value in zip(NAMES, start, strict=False)]
        owned = np.zeros(len(self.owned))
        return np.array([*leg, *torques, *states[:, 0], *states[:, 1], *owned]) / self.sizes

    def flat(self, vector: np.ndarray) -> np.ndarray:
        """The coordinates of `point` as the fit scales and orders them."""
        return np.concatenate([np.ravel(x) for x in jax.tree.leaves(scaled(self.point(vector)))])


def logarithms(*values: Float[Any, ""]) -> list[Float[Any, ""]]:
    """nan beyond the limit `POSITIVE`, from where a line search turns back."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return [np.log(value) for value in values]


@partial(jax.jit, static_argnames="chain")
def squares(
    point: Coordinates, observation: Observation, prior: Prior, stage: Stage, chain: Chain
) -> tuple[Float[Array, ""], Float[Array, ""]]:
    """The sums of squares of the data residual and of the prior's."""

    def one(own: Own, seen: Observation) -> Float[Array, "time 2"]:
        shown = predict(point.shared, point.mounting, own, seen, stage, chain)
        at = jnp.arange(seen.time.size)
        return jax.vmap(
            lambda angle, velocity, i: residual(LegState(angle, velocity), TRUE, i, seen)
        )(shown.angle, shown.angular_velocity, at)

    belief = prior_residual(prior, leg_parameters(point))
    return jnp.sum(jax.vmap(one)(point.own, observation) ** 2), belief @ belief
