"""What a term does along a measured motion, and its derivatives by the term's parameters."""

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.mismatch.screen.hypothesis import Effect
from exoid.mismatch.screen.measured_motion import SegmentMotion, at_step, throughout
from exoid.physics.moment import Moment
from exoid.physics.motion.step import Drive, march, parabola, rk4
from exoid.physics.motion.with_terms import delayed
from exoid.physics.parameter import declarations
from exoid.physics.term import Memory, Reading, Term, brief, holds


def named(term: type[Term], value: Float[Any, " parameter"]) -> Term:
    """The term with these values of its parameters."""
    names = [name for name, _ in declarations(term)]
    return term(**dict(zip(names, value, strict=True)))


def columns(term: type[Term], value: Float[Array, " parameter"], motions: SegmentMotion) -> Effect:
    """(effect, derivatives) of a term in all segments, along the first axis."""

    def effect(value):
        found = jax.vmap(partial(effect_of, named(term, value)))(motions)
        return found, found

    slopes, now = jax.jacfwd(effect, has_aux=True)(value)

    def stacked(one, slope):
        return jnp.concatenate([one[None], jnp.moveaxis(slope, -1, 0)])

    return jax.tree.map(stacked, now, slopes)


def effect_of(term: Term, motion: SegmentMotion) -> Effect:
    """One term along one segment."""
    memory = remembered(term, motion)
    before, after = memory[:-1], memory[1:]
    memories = (before, (before + after) / 2, after)
    pulled = Drive(*map(partial(throughout, term, "torque"), stages(motion), memories))
    inertia = motion.begin.place.inertia
    push = jax.tree.map(lambda one, two: (one + two) / inertia, pulled, rubbing(term, motion))
    return Effect(push, wrongly_shown(term, motion, memory))


def wrongly_shown(
    term: Term, motion: SegmentMotion, memory: Float[Array, "time memory"]
) -> Float[Array, "time channel"]:
    """What encoder and gyro show at every sample minus how the leg moves, with the gyro's delay."""
    time, velocity = motion.sample.time, motion.sample.angular_velocity
    if type(term).shown is Term.shown:
        return jnp.zeros((time.size, 2))
    error = shown(term, motion, memory)
    late = delayed(time, velocity, motion.acceleration, error.delay) - velocity
    return jnp.stack([error.angle, error.angular_velocity + late], axis=-1)


def shown(term: Term, motion: SegmentMotion, memory: Float[Array, "time memory"]) -> Reading:
    """What the sensors show at every sample minus how the leg moves."""
    return throughout(term, "shown", motion.sample, memory)


def remembered(term: Term, motion: SegmentMotion) -> Float[Array, "time memory"]:
    """The term's own state at every sample, driven by the measured."""
    steps = motion.step.size
    table = jnp.zeros((steps + 1, term.memory_size))
    if not term.memory_size:
        return table

    def forward(index, memory):
        ends = tuple(at_step(each, index) for each in stages(motion))

        def part_of(number, memory):
            def slope(memory, part):
                return memory_rate(term, memory, ends, (number + part) / term.substeps)

            return rk4(slope, memory, motion.step[index] / term.substeps, compact=brief(type(term)))

        if term.substeps == 1:
            memory = part_of(0, memory)
        else:
            memory = jax.lax.fori_loop(0, term.substeps, part_of, memory)
        return term.memory_within(ends[-1], memory)

    def store(index, memory, table):
        return table.at[index].set(memory)

    start = term.memory_at_rest(at_step(motion.begin, jnp.array(0)))
    return march(forward, store, start, table, steps)


@jax.jit  # traced once, for all stages of a step
def memory_rate(term: Term, memory: Memory, ends: tuple[Moment, Moment, Moment], at: Any) -> Memory:
    """Of a term's own state, at a fraction of a step that has this begin, middle and end."""
    return term.memory_rate(parabola(*ends, at), memory)


def rubbing(term: Term, motion: SegmentMotion) -> Drive:
    """Dry friction of a moving leg; a step across a reversal feels the mean of both directions."""
    before, after = motion.begin.angular_velocity, motion.end.angular_velocity
    if not holds(type(term)):
        none = jnp.zeros_like(before)
        return Drive(none, none, none)
    crossing = before * after < 0
    change = jnp.where(crossing, after - before, 1.0)
    mixed = (jnp.abs(after) - jnp.abs(before)) / change
    direction = jnp.where(crossing, mixed, jnp.sign(before + after))
    return Drive(*(-throughout(term, "dry_friction", now) * direction for now in stages(motion)))


def stages(motion: SegmentMotion) -> tuple[Moment, Moment, Moment]:
    """The begins, middles and ends of all steps."""
    return motion.begin, motion.middle, motion.end
