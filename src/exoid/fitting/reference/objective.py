"""The objective of a fit as a plain function of the raw parameters of Eq. 13, for SciPy."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.residual import predict, residual
from exoid.fitting.model.constraint import NEVER, SIZE, SIZE_TORQUE, term_violations, violations_at
from exoid.fitting.model.coordinates import (
    TYPICAL,
    Coordinates,
    SegmentUnknowns,
    Unknowns,
    flattened,
    leg_parameters,
    of_segments,
    scaled,
    shared_of,
    unflattened,
)
from exoid.fitting.model.limits import Prior
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.prior import mounting_residual, prior_residual, term_residual
from exoid.fitting.model.systematics import OWNED
from exoid.fitting.model.term_parameters import over_inertia, typical_term, with_values
from exoid.fitting.multistart.beginning.starts import first_state, usual_mounting
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import LegParameters
from exoid.physics.record import record
from exoid.physics.state import LegState
from exoid.physics.term import Term

TRUE = np.zeros(3)  # a sensor map that changes nothing
POSITIVE = 1e-3  # of its typical size: mass and inertia have a logarithm


@record
class Raw:
    """What SLSQP moves, in its own units; of the mounting only what is not known."""

    leg: LegParameters
    torque: Float[Any, " voluntary"]  # N m
    angle: Float[Any, " segment"]  # rad, at the first sample
    angular_velocity: Float[Any, " segment"]  # rad/s
    mounting: Mounting
    terms: tuple[Term, ...]

    def at(self, values: Mapping[str, float]) -> "Raw":
        """The same with these parameters of the leg and its terms."""
        terms = tuple(with_values(term, values) for term in self.terms)
        return replace(self, leg=with_values(self.leg, values), terms=terms)


@dataclass(frozen=True, eq=False)
class Objective:
    """What SLSQP sees: functions of a `Raw` in one row, each entry over its typical size."""

    problem: Problem
    scale: float  # the noise is this much larger than the sensors'
    bounded: bool  # with prior and limits, or the data alone

    def cost(self, vector: np.ndarray) -> float:
        """Half the sum of squares of data and prior."""
        prior = self.problem.belief.prior
        point = self.point(vector)
        data, belief = squares(point, self.seen, prior, self.problem.free, self.problem.chain)
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
        moves = flattened(self.sizes.at(dict.fromkeys(self.fixed, 0.0))) != 0
        return np.eye(moves.size)[:, moves]

    @cached_property
    def seen(self) -> Observation:
        return jax.device_put(self.problem.observation)

    @cached_property
    def usual(self) -> Mounting:
        return usual_mounting(self.problem.movements, owned=self.problem.owned)

    @cached_property
    def sizes(self) -> Raw:
        """What a vector is divided by: a step of order one."""
        problem, segments = self.problem, len(self.problem.movements)
        unknown = {
            name: np.full(int(problem.estimates(name, 0)), getattr(TYPICAL.mounting, name))
            for name in OWNED
        }
        return Raw(
            leg=SIZE,
            torque=np.full(len(problem.voluntary), SIZE_TORQUE),
            angle=np.full(segments, TYPICAL.own.angle),
            angular_velocity=np.full(segments, TYPICAL.own.angular_velocity),
            mounting=Mounting(**unknown),
            terms=tuple(map(typical_term, problem.terms)),
        )

    def point(self, vector: np.ndarray) -> Coordinates:
        """The vector in the coordinates in which the misfit is written."""
        raw = unflattened(vector * flattened(self.sizes), self.sizes)
        leg, torque = raw.leg, np.zeros(raw.angle.size)
        torque[self.problem.voluntary] = raw.torque
        with np.errstate(invalid="ignore", divide="ignore"):
            # nan beyond the limit `POSITIVE`, from where a line search turns back
            shared, log_mass = shared_of(leg), np.log(leg.mass)
        own = SegmentUnknowns(torque / leg.inertia, raw.angle, raw.angular_velocity)
        mounting = jax.tree.map(lambda a, b: b if b.size else a, self.usual, raw.mounting)
        terms = tuple(over_inertia(term, leg.inertia) for term in raw.terms)
        return Coordinates(shared, log_mass, mounting, own, terms)

    def vector(self, start: np.ndarray, terms: np.ndarray) -> np.ndarray:
        """The start (m, J, l, d, c, tau) and the terms' parameters, every movement from its first
        measured state.
        """
        states = np.array([first_state(each) for each in self.problem.movements])
        raw = Raw(
            leg=LegParameters(*map(np.asarray, start[:-1])),
            torque=np.full(len(self.problem.voluntary), start[-1]),
            angle=states[:, 0],
            angular_velocity=states[:, 1],
            mounting=jax.tree.map(np.zeros_like, self.sizes.mounting),
            terms=jax.tree.unflatten(jax.tree.structure(self.sizes.terms), [*terms]),
        )
        return flattened(raw.at(self.fixed)) / flattened(self.sizes)

    def flat(self, vector: np.ndarray) -> np.ndarray:
        """The coordinates of `point` as the fit scales and orders them."""
        return flattened(scaled(self.point(vector)))


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
    each = of_segments(point, observation.owner)
    rows = jax.vmap(one)(each, observation)
    return jnp.sum(rows**2), belief @ belief
