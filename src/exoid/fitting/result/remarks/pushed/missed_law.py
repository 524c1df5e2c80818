"""What most of what is missed may be: a law beside Eq. 9, and how far the numbers are from where
they would be with it.

Dry friction and drag damp a swing as viscous damping does, by less or more of it as swings shrink;
tissue that relaxes does it as far as it lags behind. A fit takes each for d; a little is left, as
where the sensors are a little noisier. So it takes a constant torque on a rig, as friction that
differs by direction is beside an even one, for a spring and a zero. Of a leg, whose spring is slack
somewhere, `slack_angle` tells that.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.misfit.gram import Grams
from exoid.fitting.misfit.gram_matrices import JITTER, hats, nodes_of
from exoid.fitting.model.term_parameters import ratio_unit
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.remarks.pushed.answer import answer, beyond_noise, grams_of
from exoid.fitting.result.remarks.pushed.laws import CONSTANT, LAWS, Law
from exoid.fitting.solve.problem import Problem
from exoid.physics.parameter import declarations
from exoid.physics.term import holds, name_of

RATIOS = {
    "damping": "d / J would be {:.4g} 1/s",
    "gravity": "m l g / J would be {:.4g} 1/s^2",
    "stiffness": "c / J {:.2g} 1/s^2",
}
CLEAR = 4.0  # standard errors of its size
MOSTLY = 0.5  # of the squares that are missed, that it takes away
NEARLY_ALL = 0.8  # of the same: no hand need be in it, of which it takes 0.2


@dataclass(frozen=True, eq=False)
class MissedLaw:
    """A law of what is missed."""

    law: Law
    size: float  # of the term's first parameter, over J
    error: float
    steps: np.ndarray  # of the coordinates, from where they would be with it
    share: float  # of the squares that are missed, that it takes away

    @property
    def clear(self) -> bool:
        """Is it told by the recording, and not below 0 where it can only brake?"""
        size = self.size if self.law.one_way else abs(self.size)
        return size > CLEAR * self.error


def missed_law(problem: Problem, ended: SearchResult, free: np.ndarray) -> MissedLaw | None:
    """The law that explains most of what is missed; None where none explains much."""
    if ended.disturbance.cause is None:
        return None
    grams = grams_of(problem, ended)
    each = [law_of(problem, ended, free, grams, law) for law in asked_of(problem)]
    clear = [one for one in each if one.clear and one.share > MOSTLY]
    return max(clear, key=lambda one: one.share, default=None)


def lawful(problem: Problem, ended: SearchResult, free: np.ndarray) -> bool:
    """Does a law explain nearly all that is missed, and no hand need to?"""
    law = missed_law(problem, ended, free)
    return law is not None and law.share > NEARLY_ALL


def asked_of(problem: Problem) -> list[Law]:
    """The laws that it may be, whose term the model does not have."""
    having = set(map(name_of, problem.terms))
    constant = problem.belief.rig and not any(term.steady for term in problem.terms)
    return [
        law for law in LAWS if name_of(law.term) not in having and (constant or law != CONSTANT)
    ]


def law_of(
    problem: Problem,
    ended: SearchResult,
    free: np.ndarray,
    grams: Sequence[Grams],
    law: Law,
) -> MissedLaw:
    """How much of it the recording shows, near the end point of a fit without it."""
    shapes = along_motion(problem, ended, law)
    pull, told, size = answer(problem, ended, free, grams, shapes)
    error, size = (told**-0.5, size / told) if told > 0 else (np.inf, 0.0)
    share = size**2 * told * ended.disturbance.scale**2 / beyond_noise(problem, ended)
    return MissedLaw(law, size, error, size * pull, share)


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


def of_law(found: MissedLaw | None, problem: Problem, ended: SearchResult) -> list[str]:
    """What most of what is missed may be, what the ratios would be with it, and what to do."""
    if found is None:
        return []
    law = found.law
    _, size = next(declarations(law.term))
    with_it = ", ".join(ratios_with(found, problem, ended))
    return [
        f"most of what is missed is as {in_words(law, problem)} would leave it, {size.symbol} / J "
        f"= {found.size:.2g} {ratio_unit(size)}{law.of}: with it {with_it}. ± holds how far "
        f"numbers would move; fit it by --with {name_of(law.term)}."
    ]


def in_words(law: Law, problem: Problem) -> str:
    """What the law is called; a constant torque beside dry friction is friction by direction."""
    if law != CONSTANT:
        return law.term.title
    even = any(map(holds, problem.terms))
    return "a constant torque (friction that differs by direction)" if even else "a constant torque"


def ratios_with(found: MissedLaw, problem: Problem, ended: SearchResult) -> Iterator[str]:
    """What the ratios would be with it that a fit without it takes it for."""
    for name in found.law.booked:
        gradient = ended.local.quantities[problem.quantities.index(f"{name}_over_inertia")]
        if off := float(gradient @ found.steps):
            yield RATIOS[name].format(float(getattr(ended.point.shared, name)) - off)
