"""That damping follows another law than Eq. 9's: what most of what is missed may be, and how far
the numbers are from where they would be with it.

Dry friction and drag damp a swing as viscous damping does, by less or more of it as swings shrink.
A fit takes each for d; a little is left, as where the sensors are a little noisier.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

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
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

LAWS: dict[type[Term], Callable[[np.ndarray], np.ndarray]] = {  # over J, of one unit
    CoulombFriction: lambda rate: -np.sign(rate),
    QuadraticDrag: lambda rate: -rate * np.abs(rate),
}
CLEAR = 4.0  # standard errors of its size
MOSTLY = 0.5  # of the squares that are missed, that it takes away


@dataclass(frozen=True, eq=False)
class DampingLaw:
    """A law that damping follows beside Eq. 9's."""

    term: type[Term]
    size: float  # over J
    error: float
    steps: np.ndarray  # of the coordinates, from where they would be with it
    share: float  # of the squares that are missed, that it takes away


def damping_law(problem: Problem, ended: SearchResult, free: np.ndarray) -> DampingLaw | None:
    """The law that explains most of what is missed; None where none explains much."""
    if ended.disturbance.cause is None:
        return None
    having, grams = set(map(name_of, problem.terms)), grams_of(problem, ended)
    terms = [term for term in LAWS if name_of(term) not in having]
    each = [law_of(problem, ended, free, grams, term) for term in terms]
    clear = [one for one in each if one.size > CLEAR * one.error and one.share > MOSTLY]
    return max(clear, key=lambda one: one.share, default=None)


def law_of(
    problem: Problem,
    ended: SearchResult,
    free: np.ndarray,
    grams: Sequence[Grams],
    term: type[Term],
) -> DampingLaw:
    """How much of it the recording shows, near the end point of a fit without it."""
    shapes = along_motion(problem, ended, LAWS[term])
    pull, told, size = answer(problem, ended, free, grams, shapes)
    error, size = (told**-0.5, size / told) if told > 0 else (np.inf, 0.0)
    share = size**2 * told * ended.disturbance.scale**2 / beyond_noise(problem, ended)
    return DampingLaw(term, size, error, size * pull, share)


def along_motion(
    problem: Problem, ended: SearchResult, law: Callable[[np.ndarray], np.ndarray]
) -> list[np.ndarray]:
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
    law: Callable[[np.ndarray], np.ndarray],
) -> np.ndarray:
    """Its values at the nodes, by least squares up to the last sample that counts."""
    lasting = np.arange(time.size) <= np.flatnonzero(counts)[-1]
    rows = hats(time[lasting], nodes)
    normal = rows @ rows.T + JITTER * np.eye(nodes.size)
    return np.linalg.solve(normal, rows @ law(rate[lasting]))


def of_law(law: DampingLaw | None, problem: Problem, ended: SearchResult) -> list[str]:
    """What most of what is missed may be, what d / J would be with it, and what to do."""
    if law is None:
        return []
    _, size = next(declarations(law.term))
    damping = ended.local.quantities[problem.quantities.index("damping_over_inertia")]
    here = float(ended.point.shared.damping)
    there = here - float(damping @ law.steps)
    return [
        f"most of what is missed is as {law.term.title} would leave it, {size.symbol} / J = "
        f"{law.size:.2g} {ratio_unit(size)}: with it d / J would be {there:.4g} 1/s. ± holds how "
        f"far numbers would move; fit it by --with {name_of(law.term)}."
    ]
