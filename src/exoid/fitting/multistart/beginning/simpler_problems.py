"""Problems with fewer unknowns, on the way to the whole one."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.pace import parts_of
from exoid.fitting.model.systematics import deviations, in_common, owned_by
from exoid.fitting.solve.problem import Problem, known_of


def without_scale(problem: Problem) -> Problem:
    """The same, the inertia of a start kept where nothing can tell it: the same mass was on the leg
    in every segment. Along what is flat a search may go anywhere.
    """
    each = problem.movements
    if len({one.load for one in each}) > 1 or any(one.kind == "measured" for one in each):
        return problem
    return with_inertia_kept(problem)


def with_inertia_kept(problem: Problem) -> Problem:
    """The same, every start's inertia where it is."""
    kept = np.ones(len(problem.movements))
    shared = replace(problem.known.shared, log_inertia=kept)
    return replace(problem, known=replace(problem.known, shared=shared))


def as_declared(problem: Problem) -> Problem:
    """The same, recordings as they are declared: what differs is small, but far from the leg it may
    pass for anything, the place of an added mass for a leg without inertia.
    """
    declared = jax.tree.map(np.ones_like, problem.known.mounting)
    return replace(problem, known=replace(problem.known, mounting=declared))


def with_zero_free(problem: Problem) -> Problem:
    """`as_declared` but for the zero of the encoder: that of a rig may be degrees off, and a swing
    about another middle than the one it is taken for passes for a heavier or a lighter one.
    """
    declared = as_declared(problem).known
    mounting = replace(declared.mounting, zero=problem.known.mounting.zero)
    return replace(problem, known=replace(declared, mounting=mounting))


def without_terms(problem: Problem) -> Problem:
    """The same by Eq. 9 alone, whose program is the fastest."""
    if not problem.terms:
        return problem
    movements, belief = problem.movements, problem.belief
    owned = owned_by(movements)
    declared = {"mounting": deviations(movements, owned), "in_common": in_common(movements, owned)}
    prior = replace(belief.prior, terms=(), terms_deviation=(), **declared)
    belief = replace(
        belief, prior=prior, limits=replace(belief.limits, lower_terms=(), upper_terms=())
    )
    known = known_of(movements, belief, owned, ())
    seen = replace(problem.observation, parts=parts_of(movements))
    return replace(problem, observation=seen, belief=belief, known=known, owned=owned, terms=())


def with_terms_kept(problem: Problem) -> Problem:
    """The same, every start's terms as they are: the leg finds its way to them first."""
    kept = jax.tree.map(np.ones_like, problem.known.terms)
    return replace(problem, known=replace(problem.known, terms=kept))
