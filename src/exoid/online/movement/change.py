"""Is this the leg that was known? The drop's own estimate against the belief."""

from dataclasses import replace

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool

from exoid.online.filter.pack import where_so
from exoid.online.filter.read_out import on_the_seat, values
from exoid.online.filter.whiteness import fails
from exoid.online.model.model import Model
from exoid.online.movement.end import SWINGS
from exoid.online.movement.evidence import EVIDENCE, evidence
from exoid.online.movement.knowledge import Knowledge

WHITE = 4.0  # standard deviations, within which the drop's own filter explains it
LONG_ENOUGH = 0.6  # s of a drop that tell its own ratios
MATTERS = (0.03, 0.03, 0.03)  # of m l g / J, of c / J beside it, of d / J beside the frequency


def changed(model: Model, belief: Knowledge) -> Knowledge:
    """The belief, begun anew where the leg is another one."""
    course = belief.course
    sure = (evidence(course) > EVIDENCE) & ~fails(course.whiteness)[1] & (belief.verdict.drops > 0)
    long = (course.reached - course.begun > LONG_ENOUGH) & (belief.older.turns >= SWINGS)
    found = sure & long & (course.late == 0) & (belief.older.unwhite < WHITE)

    def looked_at(belief: Knowledge) -> Knowledge:
        return where_so(differs(model, belief), begun_anew, belief)

    return where_so(found, looked_at, belief)


def begun_anew(belief: Knowledge) -> Knowledge:
    """The drop's own filter is all that is known of the leg."""
    course = belief.course
    filters, newer, older = (
        jax.tree.map(lambda both: jnp.stack([both[1], both[1]]), one)
        for one in (belief.filters, belief.newer.filters, belief.older.filters)
    )
    return replace(
        belief,
        filters=filters,
        newer=replace(belief.newer, filters=newer),
        older=replace(belief.older, filters=older),
        before=belief.prior,
        course=replace(
            course,
            likelihood=jnp.stack([course.likelihood[1]] * 2),
            rested=jnp.zeros_like(course.rested),
        ),
        verdict=replace(
            belief.verdict,
            drops=jnp.zeros_like(belief.verdict.drops),
            rests=jnp.zeros_like(belief.verdict.rests),
            changed=jnp.asarray(True),
        ),
    )


def differs(model: Model, belief: Knowledge) -> Bool[Array, ""]:
    """Is the drop's own leg another one by more than a leg differs from drop to drop?"""
    both = jax.tree.map(
        lambda before, filters: jnp.stack([before, filters[1]]), belief.before, belief.filters
    )
    seated = jax.vmap(on_the_seat, in_axes=(0, None))(both, model.node.tilt)
    ratios = jax.vmap(values)(seated.mean)
    apart = jnp.abs(ratios[1] - ratios[0])
    gravity = ratios[0, 0]
    sizes = jnp.stack([gravity, gravity, jnp.sqrt(jnp.abs(gravity))])
    return (apart > jnp.array(MATTERS) * sizes).any()
