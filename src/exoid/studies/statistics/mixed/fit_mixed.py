"""Fits the variances of a mixed model, and its fixed effects."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.optimize import minimize

from exoid.files.counted import counted
from exoid.studies.statistics.mixed.likelihood import Fitted, Variances, likelihood
from exoid.studies.statistics.mixed.stacks import Effects, Problem, problem_of
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import NotTold

LEAST = 1e-9  # of the variance of all values: what each value has for itself
STARTS = (1.0,)  # of the variance of all values, shared by the levels


@dataclass(frozen=True, eq=False)
class Mixed:
    """`variances` of each level and the covariance of the `effects`, in units of the values."""

    effects: Float[np.ndarray, " effect"]
    covariance: Float[np.ndarray, "effect effect"]
    variances: Mapping[str, float]
    people: int
    problem: Problem
    found: Variances  # in units of the problem
    fitted: Fitted


def fit_mixed(frame: Frame, effects: Effects) -> Mixed:
    """The most likely variances; the first of the effects is the mean.

    **Raises** `NotTold` (why) where the frame does not tell them.
    """
    people = frame["person"].nunique()
    if people < 3:
        who = counted(people, "person is", "people are")
        raise NotTold(f"{who} too few: at least 3 are needed.")
    if people <= effects.shape[1]:
        raise NotTold(f"{people} people are too few for {effects.shape[1]} effects.")
    problem = problem_of(frame, effects)
    found = most_likely(problem)
    fitted = likelihood(found, problem)
    shifted = fitted.effects * problem.scale
    shifted[0] += problem.origin
    return Mixed(
        shifted,
        fitted.covariance * problem.scale**2,
        dict(zip(problem.levels, (found * problem.scale**2).tolist(), strict=True)),
        people,
        problem,
        found,
        fitted,
    )


def most_likely(problem: Problem) -> Variances:
    """The best of some starts."""
    count = len(problem.levels)
    ends = [
        minimize(
            lambda each: at(each, problem),
            np.full(count, start / count),
            jac=True,
            method="L-BFGS-B",
            bounds=limits(problem),
            options={"ftol": 1e-12, "gtol": 1e-7},
        )
        for start in STARTS
    ]
    return np.asarray(min(ends, key=lambda end: end.fun).x)


def limits(problem: Problem) -> list[tuple[float, None]]:
    """No variance is negative, and none of the values is exact."""
    return [
        (LEAST if at == len(problem.levels) - 1 else 0.0, None) for at in range(len(problem.levels))
    ]


def at(variances: Variances, problem: Problem) -> tuple[float, Variances]:
    fitted = likelihood(variances, problem)
    return fitted.deviance, fitted.slope
