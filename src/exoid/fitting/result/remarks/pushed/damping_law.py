"""That damping follows another law than Eq. 9's: what most of what is missed may be, and how far
the numbers are from where they would be with it.

Dry friction and drag damp a swing as viscous damping does, by less or more of it as swings shrink;
tissue that relaxes does it as far as it lags behind. A fit takes each for d; a little is left, as
where the sensors are a little noisier.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from exoid.fitting.misfit.gram import Grams
from exoid.fitting.misfit.gram_matrices import JITTER, hats, nodes_of
from exoid.fitting.model.term_parameters import ratio_unit
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.remarks.pushed.answer import answer, beyond_noise, grams_of
from exoid.fitting.solve.problem import Problem
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag


@dataclass(frozen=True)
class Law:
    """A torque that damps, and its value over J along a motion, for a unit of the term's size."""

    term: type[Term]
    along: Callable[[np.ndarray, np.ndarray], np.ndarray]  # time [s], rate [rad/s]
    of: str = ""  # what else it has, in words


def lagging(time: np.ndarray, rate: np.ndarray, relaxation_time: float) -> np.ndarray:
    """-(phi - z) with z' = (phi - z) / t_r, of tissue that was relaxed when the motion began."""
    kept = np.exp(-np.diff(time) / relaxation_time)
    gained = relaxation_time * (1 - kept) * (rate[1:] + rate[:-1]) / 2
    lag = np.zeros(time.size)
    for at, (share, more) in enumerate(zip(kept.tolist(), gained.tolist(), strict=True)):
        lag[at + 1] = share * lag[at] + more
    return -lag


def relaxing(relaxation_time: float) -> Law:
    """Of tissue that relaxes within so many seconds."""
    along = partial(lagging, relaxation_time=relaxation_time)
    return Law(MaxwellElement, along, f", t_r = {relaxation_time:.2g} s")


LAWS = (
    Law(CoulombFriction, lambda _, rate: -np.sign(rate)),
    Law(QuadraticDrag, lambda _, rate: -rate * np.abs(rate)),
    *map(relaxing, np.geomspace(0.1, 0.8, 7).tolist()),  # s; else it is as a spring or a damper
)
CLEAR = 4.0  # standard errors of its size
MOSTLY = 0.5  # of the squares that are missed, that it takes away
NEARLY_ALL = 0.8  # of the same: no hand need be in it, of which it takes 0.2


@dataclass(frozen=True, eq=False)
class DampingLaw:
    """A law that damping follows beside Eq. 9's."""

    law: Law
    size: float  # of the term's first parameter, over J
    error: float
    steps: np.ndarray  # of the coordinates, from where they would be with it
    share: float  # of the squares that are missed, that it takes away


def damping_law(problem: Problem, ended: SearchResult, free: np.ndarray) -> DampingLaw | None:
    """The law that explains most of what is missed; None where none explains much."""
    if ended.disturbance.cause is None:
        return None
    having, grams = set(map(name_of, problem.terms)), grams_of(problem, ended)
    laws = [law for law in LAWS if name_of(law.term) not in having]
    each = [law_of(problem, ended, free, grams, law) for law in laws]
    clear = [one for one in each if one.size > CLEAR * one.error and one.share > MOSTLY]
    return max(clear, key=lambda one: one.share, default=None)


def lawful(problem: Problem, ended: SearchResult, free: np.ndarray) -> bool:
    """Does a law that damping follows explain nearly all that is missed, and no hand need to?"""
    law = damping_law(problem, ended, free)
    return law is not None and law.share > NEARLY_ALL


def law_of(
    problem: Problem,
    ended: SearchResult,
    free: np.ndarray,
    grams: Sequence[Grams],
    law: Law,
) -> DampingLaw:
    """How much of it the recording shows, near the end point of a fit without it."""
    shapes = along_motion(problem, ended, law)
    pull, told, size = answer(problem, ended, free, grams, shapes)
    error, size = (told**-0.5, size / told) if told > 0 else (np.inf, 0.0)
    share = size**2 * told * ended.disturbance.scale**2 / beyond_noise(problem, ended)
    return DampingLaw(law, size, error, size * pull, share)


def along_motion(problem: Problem, ended: SearchResult, law: Law) -> list[np.ndarray]:
    """The torque over J at the nodes of every segment that is nearest to the law's."""
    seen, rates = problem.observation, np.asarray(ended.best.angular_velocity[0])
    weights = np.asarray(seen.angle_weight + seen.velocity_weight) > 0
    each = zip(np.asarray(seen.time), rates, weights, nodes_of(problem.durations), strict=True)
    return [nearest(*one, law) for one in each]


def nearest(
    time: np.ndarray,
    rate: np.ndarray,
    counts: np.ndarray,
    nodes: np.ndarray,
    law: Law,
) -> np.ndarray:
    """Its values at the nodes, by least squares up to the last sample that counts."""
    lasting = np.arange(time.size) <= np.flatnonzero(counts)[-1]
    rows = hats(time[lasting], nodes)
    normal = rows @ rows.T + JITTER * np.eye(nodes.size)
    return np.linalg.solve(normal, rows @ law.along(time[lasting], rate[lasting]))


def of_law(found: DampingLaw | None, problem: Problem, ended: SearchResult) -> list[str]:
    """What most of what is missed may be, what d / J would be with it, and what to do."""
    if found is None:
        return []
    term = found.law.term
    _, size = next(declarations(term))
    damping = ended.local.quantities[problem.quantities.index("damping_over_inertia")]
    here = float(ended.point.shared.damping)
    there = here - float(damping @ found.steps)
    return [
        f"most of what is missed is as {term.title} would leave it, {size.symbol} / J = "
        f"{found.size:.2g} {ratio_unit(size)}{found.law.of}: with it d / J would be {there:.4g} "
        f"1/s. ± holds how far numbers would move; fit it by --with {name_of(term)}."
    ]
