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
from exoid.fitting.model.constraint import NEVER, SIZE, SIZE_TORQUE, term_violations, violations_at
from exoid.fitting.model.coordinates import (
    TYPICAL,
    Coordinates,
    Own,
    Shared,
    Unknowns,
    leg_parameters,
    of_segments,
    scaled,
)
from exoid.fitting.model.limits import Prior
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.prior import mounting_residual, prior_residual, term_residual
from exoid.fitting.model.term_parameters import over_inertia, parameters_of, step_of, term_of
from exoid.fitting.multistart.starts import first_state, usual_mounting
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import GRAVITY
from exoid.physics.state import LegState

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
        terms = float(np.sum(term_residual(prior, point, np) ** 2))
        return float(data / self.scale**2 + self.bounded * (belief + terms) + declared) / 2

    def slack(self, vector: np.ndarray) -> np.ndarray:
        """What is left of every limit, negative where it is violated."""
        positive = vector[:2] - POSITIVE
        limits, point = self.problem.belief.limits, self.point(vector)
        if not self.bounded:
            return np.concatenate([-term_violations(limits, point, np), positive])
        held = [name in self.fixed for name in self.problem.constraints]
        limit = violations_at(limits, point, np)
        return np.concatenate([-np.where(held, NEVER, limit), positive])

    @cached_property
    def fixed(self) -> dict[str, float]:
        """What does not move."""
        return dict(self.problem.belief.by_hand.fix) if self.bounded else {}

    @cached_property
    def axes(self) -> np.ndarray:
        """The directions in which a vector may move: (entry, direction)."""
        return np.eye(len(self.names))[:, [name not in self.fixed for name in self.names]]

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
        terms = [step_of(declared) for _, declared in parameters_of(self.problem.terms)]
        leg = jax.tree.leaves(SIZE)
        return np.array([*leg, *torques, *states, *owned, *terms], dtype=float)

    @cached_property
    def names(self) -> list[str]:
        """What every entry of a vector is."""
        segments = len(self.problem.movements)
        torques = [f"torque_amplitude[{number}]" for number in self.voluntary]
        states = [f"{kind}[{n}]" for kind in ("angle", "velocity") for n in range(segments)]
        terms = [name for name, _ in parameters_of(self.problem.terms)]
        return [*NAMES, *torques, *states, *self.owned, *terms]

    @cached_property
    def owned(self) -> list[str]:
        """The unknowns of the one recording's mounting."""
        return [name for name in self.problem.owned if self.problem.estimates(name, 0)]

    def point(self, vector: np.ndarray) -> Coordinates:
        """The vector in the coordinates in which the misfit is written."""
        each = dict(zip(self.names, map(np.asarray, vector * self.sizes), strict=True))
        mass, inertia, com_distance, damping, stiffness = (each[name] for name in NAMES)
        log_mass, log_inertia = logarithms(mass, inertia)
        torque, angle, velocity = (
            np.array([each.get(f"{kind}[{n}]", 0.0) for n in range(len(self.problem.movements))])
            for kind in ("torque_amplitude", "angle", "velocity")
        )
        shared = Shared(
            log_inertia=log_inertia,
            gravity=mass * com_distance * GRAVITY / inertia,
            stiffness=stiffness / inertia,
            damping=damping / inertia,
        )
        own = Own(torque / inertia, angle, velocity)
        mounting = replace(self.usual, **{name: each[name][None] for name in self.owned})
        terms = tuple(
            over_inertia(term_of(term, lambda name, _: each[name]), inertia)
            for term in self.problem.terms
        )
        return Coordinates(shared, log_mass, mounting, own, terms)

    def vector(self, start: np.ndarray, terms: np.ndarray) -> np.ndarray:
        """The start (m, J, l, d, c, tau) and the terms' parameters, every movement from its first
        measured state.
        """
        states = np.array([first_state(each) for each in self.problem.movements])
        torques, leg = [start[-1]] * len(self.voluntary), start[:-1]
        owned = np.zeros(len(self.owned))
        row = np.array([*leg, *torques, *states[:, 0], *states[:, 1], *owned, *terms])
        values = [self.fixed.get(name, one) for name, one in zip(self.names, row, strict=True)]
        return np.array(values) / self.sizes

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

    def one(unknowns: Unknowns, seen: Observation) -> Float[Array, "time 2"]:
        shown = predict(unknowns, seen, stage, chain)
        at = jnp.arange(seen.time.size)
        return jax.vmap(
            lambda angle, velocity, i: residual(LegState(angle, velocity), TRUE, i, seen)
        )(shown.angle, shown.angular_velocity, at)

    belief = prior_residual(prior, leg_parameters(point))
    each = of_segments(point, observation.seat)
    rows = jax.vmap(one)(each, observation)
    return jnp.sum(rows**2), belief @ belief
