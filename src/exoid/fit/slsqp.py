"""The reference method: SciPy's SLSQP on the same objective, over the raw parameters of Eq. 13."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float
from scipy.optimize import OptimizeResult, minimize

from exoid.fit.chain import Chain
from exoid.fit.constraint import SIZE, SIZE_TORQUE, Limits, violations
from exoid.fit.coordinates import (
    TYPICAL,
    Coordinates,
    Own,
    Shared,
    leg_parameters,
    torque_amplitudes,
)
from exoid.fit.multistart import Ended, Problem, advance, finite, spread_of, take, task
from exoid.fit.observation import Observation
from exoid.fit.prior import Prior, prior_residual
from exoid.fit.residual import Stage, predict, residual
from exoid.fit.starts import first_state
from exoid.physics.leg import GRAVITY
from exoid.physics.state import LegState

LEG = 5  # m, J, l, d, c come first in a vector
POSITIVE = 1e-3  # of its typical size: a mass and an inertia have a logarithm
PRECISION = 1e-12  # change of the cost per sample that ends a search
ITERATIONS = 1000
NOTHING_MOVES = np.inf  # tolerance of a solver that is to look at a point, not to leave it


@dataclass(frozen=True, eq=False)
class Objective:
    """What SLSQP sees: functions of a vector of parameters, each over its typical size."""

    problem: Problem
    scale: float  # the noise is this much larger than the sensors'
    bounded: float  # 1: with prior and limits, 0: the data alone

    def cost(self, vector: np.ndarray) -> float:
        """Half the sum of squares of data and prior, per sample."""
        problem, belief = self.problem, self.problem.belief
        stage = Stage(np.asarray(0.0), np.asarray(problem.steps))
        data, prior = squares(
            self.point(vector), problem.observation, belief.prior, stage, problem.chain
        )
        return float(data / self.scale**2 + self.bounded * prior) / 2 / self.samples

    def slack(self, vector: np.ndarray) -> np.ndarray:
        """What is left of every limit, negative where it is violated."""
        return -np.asarray(exceeded(self.point(vector), self.problem.belief.limits))

    @property
    def samples(self) -> int:
        seen = self.problem.observation
        return int(np.sum(seen.angle_weight > 0) + np.sum(seen.velocity_weight > 0))

    @property
    def voluntary(self) -> list[int]:
        return [n for n, each in enumerate(self.problem.movements) if each.voluntary]

    def sizes(self) -> np.ndarray:
        """What a vector is divided by."""
        segments = len(self.problem.movements)
        torques = [SIZE_TORQUE] * len(self.voluntary)
        states = [TYPICAL.own.angle] * segments + [TYPICAL.own.angular_velocity] * segments
        return np.array([*jax.tree.leaves(SIZE), *torques, *states], dtype=float)

    def point(self, vector: np.ndarray) -> Coordinates:
        """The vector in the coordinates in which the misfit is written."""
        segments = len(self.problem.movements)
        values = vector * self.sizes()
        mass, inertia, com_distance, damping, stiffness = values[:LEG]
        torque = np.zeros(segments)
        torque[self.voluntary] = values[LEG : -2 * segments]
        shared = Shared(
            log_inertia=np.log(inertia),
            gravity=np.asarray(mass * com_distance * GRAVITY / inertia),
            stiffness=np.asarray(stiffness / inertia),
            damping=np.asarray(damping / inertia),
        )
        own = Own(torque / inertia, values[-2 * segments : -segments], values[-segments:])
        return Coordinates(shared, np.log(mass), own)

    def vector(self, start: np.ndarray) -> np.ndarray:
        """The start (m, J, l, d, c, tau), every movement from its first measured state."""
        states = np.array([first_state(each) for each in self.problem.movements])
        torques = [start[LEG]] * len(self.voluntary)
        return np.array([*start[:LEG], *torques, *states[:, 0], *states[:, 1]]) / self.sizes()


@partial(jax.jit, static_argnames="chain")
def squares(
    point: Coordinates, observation: Observation, prior: Prior, stage: Stage, chain: Chain
) -> tuple[Float[Array, ""], Float[Array, ""]]:
    """The sums of squares of the data residual and of the prior's."""

    def one(own: Own, seen: Observation) -> Float[Array, "time 2"]:
        shown = predict(point.shared, own, seen, stage, chain)
        at = jnp.arange(seen.time.size)
        return jax.vmap(lambda angle, velocity, i: residual(LegState(angle, velocity), i, seen))(
            shown.angle, shown.angular_velocity, at
        )

    belief = prior_residual(prior, leg_parameters(point))
    return jnp.sum(jax.vmap(one)(point.own, observation) ** 2), belief @ belief


@jax.jit
def exceeded(point: Coordinates, limits: Limits) -> Float[Array, " constraint"]:
    """Every limit, positive where it is violated."""
    return violations(limits, leg_parameters(point), torque_amplitudes(point))


def search_slsqp(problem: Problem, starts: np.ndarray) -> Ended:
    """SLSQP with finite differences from every start (m, J, l, d, c, tau), one after the other.

    Every start is brought to data, prior and limits at once. The best of them without prior and
    limits tells how far the residual exceeds the noise, and is then brought to both under it.
    """
    objective = Objective(problem, 1.0, 1.0)
    found = [descend(objective, objective.vector(start)) for start in starts]
    free = look(problem, [objective.point(each.x) for each in found])
    arrived = np.array([each.success for each in found]) & np.isfinite(free.loss)
    cost = finite(np.where(arrived, [each.fun for each in found], np.inf))
    if not arrived.any():
        raise ArithmeticError(f"no start of SLSQP succeeded: {found[0].message}.")
    nearest = found[int(np.argmin(cost))].x
    alone = descend(replace(objective, bounded=0.0), nearest)
    at_data = look(problem, [objective.point(alone.x)])
    scale = spread_of(problem, at_data)
    widened = replace(objective, scale=scale)
    best = descend(widened, nearest)
    information = jax.tree.map(lambda leaf: leaf[0] / scale, at_data.condensed)
    settled = look(problem, [widened.point(best.x)], scale=scale, information=information)
    return Ended(
        free=free,
        member=np.where(arrived, np.arange(arrived.size), -1),
        failures=dict(Counter(each.message for each in found if not each.success)),
        best=replace(settled, multiplier=best.multipliers[None] * widened.samples),
        noise_scale=scale,
        starts=stacked([objective.point(objective.vector(start)) for start in starts]),
    )


def descend(objective: Objective, start: np.ndarray) -> OptimizeResult:
    """One search, with the gradients that SciPy takes by finite differences."""
    limits = {"constraints": {"type": "ineq", "fun": objective.slack}} if objective.bounded else {}
    lower = np.full(start.size, -np.inf)
    lower[:2] = POSITIVE
    return minimize(
        objective.cost,
        start,
        method="SLSQP",
        bounds=np.stack([lower, np.full(start.size, np.inf)], axis=1),
        options={"ftol": PRECISION, "maxiter": ITERATIONS},
        **limits,
    )


def look(problem: Problem, points: list[Coordinates], **bounded):
    """The compiled program at these points, told that every step is negligible."""
    still = task(problem, 0.0, problem.steps, NOTHING_MOVES, **bounded)
    return advance(problem, stacked(points), still)


def stacked(points: list[Coordinates]) -> Coordinates:
    return jax.tree.map(lambda *each: np.stack(each), *points)
