"""From movements and what is believed to the problem of a fit."""

from dataclasses import replace

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.observe import observe
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.systematics import OWNED, deviations, in_common, owned_by
from exoid.fitting.solve.problem import Problem, known_of
from exoid.physics.term import Term


def pose(
    movements: list[Movement],
    belief: Belief,
    reading: str,
    chain: Chain,
    *,
    owned: tuple[str, ...] = OWNED,
    terms: tuple[type[Term], ...] = (),
) -> Problem:
    """The problem of fitting one leg to these movements; of what recordings own, `owned` are
    unknowns, but for what one of the `terms` is itself.
    """
    replaced = {term.replaces for term in terms}
    owned = tuple(name for name in owned_by(movements, owned) if name not in replaced)
    declared, alike = deviations(movements, owned), in_common(movements, owned)
    prior = replace(belief.prior, mounting=declared, in_common=alike)
    return Problem(
        movements,
        observe(movements, reading, terms),
        known_of(movements, belief, owned, terms),
        replace(belief, prior=prior),
        chain,
        owned,
        terms,
    )
