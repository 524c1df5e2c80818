"""A live estimate beside the batch fit of the same drops, and how the filter goes on from that."""

from dataclasses import dataclass, replace
from functools import cache, partial

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.fitting.result.fit_result import FitResult
from exoid.online.belief import DEFAULT, Belief, belief_of, knowledge_of
from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.read_out import Seated, slope_of_seat, slopes
from exoid.online.filter.read_out import ratios as ratios_of
from exoid.online.filter.read_out import seated as seated_by
from exoid.online.model.model import Model, Node
from exoid.online.model.trust import Phase

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
FAR = 3.0  # standard errors of their difference, from which on two estimates disagree
LEAST = 0.01  # of what the seat's tilt allows, which no refinement is surer than

Matrix = Float[np.ndarray, "unknown unknown"]


@dataclass(frozen=True)
class Agreement:
    """How far the live estimate and the batch fit of the same drops are apart."""

    differences: dict[str, float]  # over the standard errors of both together, by ratio

    @property
    def holds(self) -> bool:
        return max(map(abs, self.differences.values())) < FAR


def agreement(belief: Belief, found: FitResult, model: Model = DEFAULT) -> Agreement:
    """Do the live estimate and the batch fit agree within their errors?

    Both saw the same samples, so where both are right they are closer than these errors say.
    """
    values, errors = told(seated(belief, model))
    batch, others = of_fit(found)
    apart = (values - batch) / np.hypot(errors, others)
    return Agreement(dict(zip(RATIOS, apart.tolist(), strict=True)))


def refined(belief: Belief, found: FitResult, model: Model = DEFAULT) -> Belief:
    """The belief with the batch's ratios in the place of its own; what else is known stays as it is
    given the ratios (Jeffrey's rule).

    **Raises** `ValueError` while the leg moves: then the fit knows less than the belief.
    """
    now = knowledge_of(belief, model)
    if now.phase == Phase.MOVING:
        raise ValueError("the leg moves: refine the belief when the movement has ended.")
    believed = seated(belief, model)
    values, errors = told(believed)
    one = believed.level
    batch, others = of_fit(found)
    with jax.enable_x64(True):
        slope = np.asarray(slopes(one.mean))
    covariance = one.root @ one.root.T
    cross = covariance @ slope.T
    own = slope @ cross
    gain = np.linalg.solve(own, cross.T).T
    wanted = own * np.outer(others / errors, others / errors)
    mean = one.mean + gain @ (batch - values)
    after = covariance - gain @ (own - wanted) @ gain.T
    known = off_the_seat(mean, after, model.node.tilt)
    both = jax.tree.map(lambda each, new: np.stack([new, each[1]]), now.filters, known)
    return belief_of(replace(now, filters=both), model)


def seated(belief: Belief, model: Model) -> Seated:
    """What all drops told, with what is known of the seat."""
    known = jax.tree.map(lambda both: both[0], knowledge_of(belief, model).filters)
    with jax.enable_x64(True):
        return jax.tree.map(np.asarray, on_seat(model.node)(known))


@cache
def on_seat(node: Node):
    return jax.jit(partial(seated_by, node=node))


def told(known: Seated) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """The ratios and their errors."""
    with jax.enable_x64(True):
        values, errors = ratios_of(known)
    return np.asarray(values), np.asarray(errors)


def of_fit(found: FitResult) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """The same of a fit; infinite errors where it tells none.

    **Raises** `ValueError` where it does not follow the drops.
    """
    if not found.follows:
        raise ValueError(f"the batch fit does not follow the drops: {found.astray}.")
    each = [found.ratios[name] for name in RATIOS]
    if any(one.value is None or one.standard_error is None for one in each):
        raise ValueError("the batch fit lies at a bound: it tells no errors to go on from.")
    return np.array([one.value for one in each]), np.array([one.standard_error for one in each])


def off_the_seat(mean: np.ndarray, covariance: Matrix, tilt: float) -> Gaussian:
    """`on_the_seat` undone: that is taken in at every reading, and counts once."""
    with jax.enable_x64(True):
        found = slope_of_seat(jnp.asarray(mean), tilt)
    value, slope, allowed = (np.asarray(each) for each in found)
    along = covariance @ slope
    left = max(float(allowed - slope @ along), LEAST * float(allowed))
    wider = covariance + np.outer(along, along) / left
    return Gaussian(mean + along * float(value) / left, np.linalg.cholesky((wider + wider.T) / 2))
