"""What each leg is, told by its own drops and by all other people: a hierarchical Bayesian model.

One drop tells little of a leg, and all other legs tell in which range it lies. The model is that of
`mixed`, with a prior on each standard deviation. numpyro samples these and the means; what a leg is
then follows without sampling. So the intervals of a leg hold that the variances are not known
either, which matters where people are few.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from exoid.files.counted import counted
from exoid.files.extras import require
from exoid.studies.statistics.mixed.stacks import Problem, problem_of
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.values import LEG, Values

LASTING = ("person", "side")
FEWEST = 3  # people
LEAST = 1e-6  # of the variance of all values, that none is without


@dataclass(frozen=True, eq=False)
class Shrunk:
    """`legs` has a row per leg: `plain`, the mean of its drops, and what the model says, `value`
    with its standard `error`. Of people who came on one day only it is the leg on that day: how far
    days differ nobody told.
    """

    quantity: str
    unit: str
    legs: Frame


def shrunk(values: Values, by: str = "", *, draws: int = 400, seed: int = 0) -> Shrunk:
    """Every leg, drawn towards the mean of all people, or of its group of `by`.

    **Raises** `NotTold` (why) for too few people or values that do not vary, `ValueError` (which
    extra to install) without numpyro.
    """
    require("numpyro", "hierarchical models are sampled")
    if values.people < FEWEST:
        who = counted(values.people, "person is", "people are")
        raise NotTold(f"{who} too few: {FEWEST} are needed.")
    frame = values.frame.reset_index(drop=True)
    names = frame[by].astype(str) if by else frame["person"].map(lambda _: "")
    effects = np.stack([names == each for each in sorted(names.unique())], axis=1).astype(float)
    problem = problem_of(frame, effects)
    value, error = np.empty(len(frame)), np.empty(len(frame))
    for stack, (mean, spread) in zip(problem.stacks, legs(problem, draws, seed), strict=True):
        value[stack.rows] = problem.origin + problem.scale * mean
        error[stack.rows] = problem.scale * spread
    told = frame.assign(plain=frame["value"], value=value, error=error).groupby(LEG, sort=True)
    return Shrunk(
        values.quantity,
        values.unit,
        told[["plain", "value", "error"]].mean().reset_index(),
    )


def legs(problem: Problem, draws: int, seed: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Of every value the leg that it is of, by stack: its mean, and its standard deviation."""
    import jax
    from numpyro.infer import MCMC, NUTS

    sampler = MCMC(NUTS(hierarchy), num_warmup=draws, num_samples=draws, progress_bar=False)
    sampler.run(jax.random.key(seed), problem)
    drawn = sampler.get_samples()
    found = []
    for stack in problem.stacks:
        each = jax.lax.map(
            lambda one, stack=stack: of_legs(stack, problem, *one),
            (drawn["means"], drawn["spreads"]),
        )
        mean, square = (np.asarray(one) for one in each)
        found.append((mean.mean(0), np.sqrt(mean.var(0) + square.mean(0))))
    return found


def hierarchy(problem: Problem) -> None:
    """In standard deviations of all values: 1 is a wide guess for every part of them."""
    import numpyro
    from numpyro import distributions as of

    count = len(problem.levels)
    means = numpyro.sample("means", of.Normal(0.0, 2.0).expand([problem.effects]).to_event(1))
    spreads = numpyro.sample("spreads", of.HalfNormal(1.0).expand([count]).to_event(1))
    for at, stack in enumerate(problem.stacks):
        seen = of.MultivariateNormal(stack.effects @ means, spread_of(stack, spreads))
        numpyro.sample(f"stack {at}", seen, obs=stack.value)


def spread_of(stack: Any, spreads: Any) -> Any:
    """V of each person."""
    import jax.numpy as jnp

    known = (stack.known + LEAST)[:, :, None] * jnp.eye(stack.known.shape[1])
    return jnp.einsum("k,kpvw->pvw", spreads**2, stack.same) + known


def of_legs(stack: Any, problem: Problem, means: Any, spreads: Any) -> tuple[Any, Any]:
    """Mean and variance of the leg of each value, where means and spreads are known."""
    import jax.numpy as jnp

    lasting = jnp.array([float(each in LASTING) for each in problem.levels])
    shared = jnp.einsum("k,kpvw->pvw", lasting * spreads**2, stack.same)
    expected = stack.effects @ means
    weights = jnp.linalg.solve(spread_of(stack, spreads), shared)  # V^-1 shared
    told = jnp.einsum("pwv,pw->pv", weights, stack.value - expected)
    left = (lasting * spreads**2).sum() - jnp.einsum("pvw,pwv->pv", shared, weights)
    return expected + told, left
