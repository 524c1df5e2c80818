"""How well variances explain the values of all people, by restricted maximum likelihood.

    value = effects beta + person + side + day + side on a day + drop + error,

each but the last of an unknown variance theta, the error of the variance that its estimate came
with. So a drop that tells little weighs little, and what errors explain is not taken for scatter of
the leg.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.studies.statistics.mixed.stacks import Problem, Stack

Variances = Float[np.ndarray, " level"]


@dataclass(frozen=True, eq=False)
class Fitted:
    """At given variances: -2 log of the likelihood with its slope, and the fixed effects."""

    deviance: float
    slope: Variances
    effects: Float[np.ndarray, " effect"]
    covariance: Float[np.ndarray, "effect effect"]
    weights: tuple[Float[np.ndarray, "_ _"], ...]  # V^-1 (value - effects beta), by stack


def likelihood(variances: Variances, problem: Problem) -> Fitted:
    """-2 l = log|V| + log|X' V^-1 X| + r' V^-1 r, without its constant."""
    inverses = [np.linalg.inv(spread(variances, each)) for each in problem.stacks]
    pairs = list(zip(problem.stacks, inverses, strict=True))
    weighed = [inverse @ stack.effects for stack, inverse in pairs]
    both = list(zip(problem.stacks, inverses, weighed, strict=True))
    normal = sum(np.einsum("pve,pvf->ef", stack.effects, one) for stack, _, one in both)
    right = sum(np.einsum("pve,pv->e", one, stack.value) for stack, _, one in both)
    covariance = np.linalg.inv(np.asarray(normal))
    effects = covariance @ np.asarray(right)
    left = [stack.value - stack.effects @ effects for stack in problem.stacks]
    weights = [
        np.einsum("pvw,pw->pv", inverse, one) for inverse, one in zip(inverses, left, strict=True)
    ]
    volume = -sum(float(np.linalg.slogdet(inverse)[1].sum()) for inverse in inverses)
    fit = sum(float(np.sum(a * b)) for a, b in zip(left, weights, strict=True))
    deviance = volume - float(np.linalg.slogdet(covariance)[1]) + fit
    slope = sum(
        slope_of(stack, inverse, one, weight, covariance)
        for (stack, inverse, one), weight in zip(both, weights, strict=True)
    )
    return Fitted(deviance, np.asarray(slope), effects, covariance, tuple(weights))


def spread(variances: Variances, stack: Stack) -> Float[np.ndarray, "person value value"]:
    """V of each person."""
    known = stack.known[:, :, None] * np.eye(stack.known.shape[1])
    return np.einsum("k,kpvw->pvw", variances, stack.same) + known


def slope_of(
    stack: Stack,
    inverse: Float[np.ndarray, "person value value"],
    weighed: Float[np.ndarray, "person value effect"],
    weight: Float[np.ndarray, "person value"],
    covariance: Float[np.ndarray, "effect effect"],
) -> Variances:
    """d(-2 l) / d theta_k = tr(P same_k) - r' V^-1 same_k V^-1 r."""
    projected = inverse - weighed @ covariance @ weighed.transpose(0, 2, 1)
    outer = weight[:, :, None] * weight[:, None, :]
    return np.einsum("kpvw,pvw->k", stack.same, projected - outer)
