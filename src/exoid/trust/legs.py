"""Are recordings that were fitted together of one leg?"""

from dataclasses import dataclass, replace

import numpy as np

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.multistart.beginning.simpler_problems import with_inertia_kept
from exoid.fitting.multistart.beginning.starts import usual_mounting
from exoid.fitting.multistart.beginning.tethers import FINE
from exoid.fitting.multistart.weight_by_kind import explained
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import advance, around, take, task
from exoid.fitting.solve.problem import Problem

SURPRISE = 30.0  # of chi-square with three degrees of freedom: once in a million
LARGE = 0.1  # relative difference of a ratio, below which legs are not told apart by it alone
EXPLAINED = 1.5  # chi-square per sample, up to which a recording by itself is explained
LEG = 5  # coordinates: those that it owns and log m
TORN = 4.0  # times as much chi-square together as apart: no one leg, however it was mounted
COMMON = list(RATIOS)[:3]  # that every recording of a leg shares


@dataclass(frozen=True, eq=False)
class Alone:
    """What one recording gives by itself."""

    recording: str
    ratios: np.ndarray
    covariance: np.ndarray
    misfit: float  # chi-square per sample


def strangers(result: FitResult) -> list[str]:
    """Sentences on recordings that one leg cannot have made.

    Only where the joint fit, in which each has a mounting of its own, leaves more than noise.
    """
    basis = result.basis
    if basis is None or basis.ended.disturbance.cause is None:
        return []
    numbers = sorted({each.recording for each in basis.problem.movements})
    if len(numbers) < 2:
        return []
    each = [alone(result, number) for number in numbers]
    together = float(basis.ended.best.misfit[0]) / samples(basis.problem)
    torn = all(one.misfit < EXPLAINED and TORN * one.misfit < together for one in each)
    return [
        sentence
        for at, one in enumerate(each)
        for other in each[at + 1 :]
        if (sentence := disagreement(one, other, torn and len(each) == 2))
    ]


def samples(problem: Problem) -> int:
    seen = problem.observation
    return int((seen.angle_weight > 0).sum() + (seen.velocity_weight > 0).sum())


def alone(result: FitResult, recording: int) -> Alone:
    """The same problem, blind to all other recordings, the scale as expected."""
    basis = result.basis
    assert basis is not None
    problem = blinded(basis.problem, recording)
    best = take(basis.ended.best.coordinates, [0])
    start = replace(best, mounting=usual_mounting(problem.movements, (1,), problem.owned))
    solved = advance(problem, start, task(problem, 0.0, problem.steps, FINE))
    local = around(problem, solved, explained(problem, solved))
    rows = [problem.quantities.index(name) for name in COMMON]
    none = np.zeros((0, local.data.shape[0]))
    prior = local.prior.copy()
    prior[:LEG], prior[:, :LEG] = 0.0, 0.0  # the leg by itself, its recording as declared
    values, vectors = Information(local.data, prior, none).posterior
    along = local.quantities[rows] @ vectors
    return Alone(
        recording=next(m.source for m in problem.movements if m.recording == recording),
        ratios=solved.quantities[0, rows],
        covariance=(along / values) @ along.T,
        misfit=float(solved.misfit[0]) / samples(problem),
    )


def blinded(problem: Problem, recording: int) -> Problem:
    """The same problem, with no sample of any other recording."""
    own = np.array([each.recording == recording for each in problem.movements])[:, None]
    return with_inertia_kept(replace(problem, observation=problem.observation.weighed(own)))


def disagreement(one: Alone, other: Alone, torn: bool) -> str | None:
    """What to say of two recordings, where they cannot be of one leg."""
    apart = one.ratios - other.ratios
    covariance = one.covariance + other.covariance
    relative = np.abs(apart) / np.maximum((np.abs(one.ratios) + np.abs(other.ratios)) / 2, 1e-9)
    errors = np.abs(apart) / np.sqrt(np.diag(covariance))
    surprise = apart @ np.linalg.solve(covariance, apart)
    if not torn and (surprise < SURPRISE or relative.max() < LARGE):
        return None
    said = f"{one.recording} and {other.recording} do not look like one leg, or it changed"
    possible = (one.ratios > 0) & (other.ratios > 0)
    worst = int(np.argmax(np.where(possible, relative, 0.0)))
    if possible.any():
        symbol, _, unit = RATIOS[COMMON[worst]]
        values = " and ".join(f"{each.ratios[worst]:.3g}" for each in (one, other))
        said += f": by themselves they give {symbol} = {values} {unit}"
    if torn:
        said += ", and each alone is explained, but not both together, however they were mounted"
    elif possible.any():
        said += f", {errors[worst]:.0f} standard errors apart"
    return f"{said}. If they are of different legs, fit them apart."
