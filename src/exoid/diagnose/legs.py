"""Are recordings that were fitted together of one leg?"""

from dataclasses import dataclass, replace

import equinox as eqx
import numpy as np

from exoid.fit.belief import NAMES
from exoid.fit.coordinates import QUANTITIES
from exoid.fit.estimates import RATIOS
from exoid.fit.local import penalties, weighed
from exoid.fit.multistart import LIMITED
from exoid.fit.problem import Problem, advance, around, explained, take, task
from exoid.fit.result import FitResult
from exoid.fit.uncertainty import Information

SURPRISE = 30.0  # of chi-square with three degrees of freedom: once in a million
LARGE = 0.1  # relative difference of a ratio, below which legs are not told apart by it
COMMON = list(RATIOS)[:3]  # that every recording of a leg shares


@dataclass(frozen=True, eq=False)
class Alone:
    """The ratios that one recording gives by itself."""

    recording: str
    ratios: np.ndarray
    covariance: np.ndarray


def strangers(result: FitResult) -> list[str]:
    """Sentences on recordings whose ratios disagree far beyond their errors.

    Only where the joint fit leaves more than noise: what one leg explains is of one leg.
    """
    basis = result.basis
    if basis is None or basis.ended.disturbance.cause is None:
        return []
    numbers = sorted({each.recording for each in basis.problem.movements})
    each = [alone(result, number) for number in numbers] if len(numbers) > 1 else []
    return [
        sentence
        for at, one in enumerate(each)
        for other in each[at + 1 :]
        if (sentence := disagreement(one, other))
    ]


def alone(result: FitResult, recording: int) -> Alone:
    """The joint fit's program, blind to all other recordings, from where the joint fit ended."""
    basis = result.basis
    assert basis is not None
    problem, ended = blinded(basis.problem, recording), basis.ended
    start = take(ended.best.coordinates, [0])
    penalty = penalties(weighed(around(problem, ended.best), 1.0))
    solved = advance(problem, start, task(problem, 0.0, problem.steps, LIMITED, penalty))
    local = around(problem, solved, explained(problem, solved))
    rows = slice(len(NAMES), QUANTITIES)
    gradients = local.quantities[rows]
    none = np.zeros((0, local.data.shape[0]))
    values, vectors = Information(local.data, local.prior, none).posterior
    along = gradients @ vectors
    return Alone(
        recording=next(m.source for m in problem.movements if m.recording == recording),
        ratios=solved.quantities[0, rows],
        covariance=(along / np.maximum(values, 1e-12)) @ along.T,
    )


def blinded(problem: Problem, recording: int) -> Problem:
    """The same problem, with no sample of any other recording."""
    own = np.array([each.recording == recording for each in problem.movements])[:, None]
    seen = problem.observation
    weights = tuple(np.where(own, w, 0.0) for w in (seen.angle_weight, seen.velocity_weight))
    masked = eqx.tree_at(lambda each: (each.angle_weight, each.velocity_weight), seen, weights)
    return replace(problem, observation=masked)


def disagreement(one: Alone, other: Alone) -> str | None:
    """What to say of two recordings, where they cannot be of one leg."""
    apart = one.ratios - other.ratios
    covariance = one.covariance + other.covariance
    mean = np.maximum((np.abs(one.ratios) + np.abs(other.ratios)) / 2, 1e-9)
    surprise = apart @ np.linalg.solve(covariance, apart)
    if surprise < SURPRISE or (np.abs(apart) / mean).max() < LARGE:
        return None
    errors = np.abs(apart) / np.sqrt(np.diag(covariance))
    worst = int(np.argmax(np.where(np.abs(apart) / mean > LARGE, errors, 0.0)))
    symbol, _, unit = RATIOS[COMMON[worst]]
    values = [
        f"{each.ratios[worst]:.3g} ± {np.sqrt(each.covariance[worst, worst]):.1g} {unit}"
        for each in (one, other)
    ]
    return (
        f"{one.recording} and {other.recording} do not look like one leg: by itself the first has "
        f"{symbol} = {values[0]}, the second {values[1]}, {errors[worst]:.0f} standard errors "
        "apart. If they are of different legs, fit them apart."
    )
