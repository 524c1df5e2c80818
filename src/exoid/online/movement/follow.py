"""A leg that moves freely: its samples are absorbed one by one."""

from dataclasses import replace

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.online.filter.absorb import TICK, Innovation, absorb
from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.motion import Span
from exoid.online.filter.pack import as_long_as
from exoid.online.filter.select import select
from exoid.online.filter.sensor_noise import SensorNoise
from exoid.online.filter.whiteness import seen, unwhite
from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.unknowns import AT
from exoid.online.movement.evidence import evidence
from exoid.online.movement.knowledge import Course, Kept, Knowledge, Sensing

AT_ONCE = 4  # samples a step that are absorbed at most, where some wait
BRIDGED = 1.5 * TICK  # s, longer steps are taken in pieces of a tick
GATE = 40.0  # chi-square of a sample: noise goes beyond once in 5e8
NOISY = (0.25, 4.0)  # times the declared variance that a sensor's can be found to have
KEPT = 0.15  # s between two keepings of the filters: a hand is seen that much later at most
FIRST_RATE = 2.0  # rad/s, standard deviation of the first rate about what the gyro shows
FIRST_ANGLE = 0.1  # rad


def follow(model: Model, belief: Knowledge) -> Knowledge:
    """The samples that wait, a few at a time."""

    def waits(state):
        count, now = state
        return (count < AT_ONCE) & (now.recent.absorbed < now.recent.heard)

    def one(state):
        count, now = state
        return count + 1, next_one(model, now)

    return as_long_as(waits, one, (jnp.zeros((), int), belief))[1]


def next_one(model: Model, belief: Knowledge) -> Knowledge:
    """The next sample, or a tick on the way to it."""
    recent, course = belief.recent, belief.course
    row = recent.rows[recent.absorbed % recent.rows.shape[0]]
    blind = jnp.isnan(row[1])
    begins = ~course.opened & ~blind
    filters = select(begins, opened(belief.filters, row), belief.filters)
    whole = jnp.where(course.opened, row[0] - course.reached, 0.0)
    bridges = whole > BRIDGED
    row = select(bridges, between(course, row, whole), row)
    span = Span(jnp.where(bridges, TICK, whole), jnp.where(course.opened, course.torque, row[3]))
    noise = noise_of(belief.sensing, course.scatter)
    taken = jax.vmap(absorb, in_axes=(None, 0, None, None, None))
    after, innovation = taken(model, filters, Sample(*row), span, noise)
    skips = ~course.opened & blind
    moved = replace(
        belief,
        filters=select(skips, belief.filters, after),
        course=select(skips, course, surprised(course, innovation, row)),
        recent=replace(recent, absorbed=recent.absorbed + jnp.where(bridges, 0, 1)),
    )
    return remembered(moved, begins)


def between(course: Course, row: Float[Array, " 6"], whole: Float[Array, ""]):
    """What is known a tick after the last sample: nothing was seen, and a torque is linear."""
    torque = course.torque + (row[3] - course.torque) * TICK / whole
    blind = row.at[1:3].set(jnp.nan)
    return blind.at[0].set(course.reached + TICK).at[3].set(torque)


def opened(filters: Gaussian, row: Float[Array, " 6"]) -> Gaussian:
    """The filters at the first sample of a movement, of which nothing but that is known."""
    angle = row[1]
    rate = row[2] - filters.mean[:, AT["gyro_bias"]]
    rate = jnp.where(jnp.isnan(rate), 0.0, rate)
    first = jnp.stack([jnp.broadcast_to(angle, rate.shape), rate], axis=1)
    size = filters.mean.shape[1]
    wide = jnp.zeros((2, size)).at[0, -2].set(FIRST_ANGLE).at[1, -1].set(FIRST_RATE)
    mean = jnp.concatenate([filters.mean[:, :-2], first], axis=1)
    both = jnp.broadcast_to(wide, (2, 2, size))
    return Gaussian(mean, jnp.concatenate([filters.root[:, :-2], both], axis=1))


def noise_of(declared: Sensing, scatter: Float[Array, "2 2"]) -> SensorNoise:
    """The sensors' noise as far as it was learned."""
    times = jnp.clip(scatter[:, 0] / scatter[:, 1], *NOISY)
    return SensorNoise(
        times[0] * declared.angle,
        times[1] * declared.angular_velocity,
        declared.wander,
        declared.drift,
        jnp.asarray(GATE),
    )


def surprised(course: Course, innovation: Innovation, row: Float[Array, " 6"]) -> Course:
    """What innovations of both filters say. The drop's own filter judges samples."""
    whitened = jnp.where(innovation.used, innovation.whitened, 0.0)
    measured = innovation.used.any() | (innovation.far > 0).any()
    off = innovation.far[1] >= GATE
    more = seen(course.whiteness, whitened, innovation.used, innovation.white)
    learned = jnp.stack([innovation.square[1], jnp.where(innovation.tells[1], 1.0, 0.0)], axis=1)
    return replace(
        course,
        reached=row[0],
        torque=row[3],
        opened=jnp.asarray(True),
        whiteness=select(measured, more, course.whiteness),
        likelihood=course.likelihood + innovation.log_likelihood,
        astray=jnp.where(measured, jnp.where(off, course.astray + 1, 0), course.astray),
        scatter=course.scatter + learned,
    )


def remembered(belief: Knowledge, begins: Bool[Array, ""]) -> Knowledge:
    """With the filters kept as they are now, from time to time."""
    course = belief.course
    white = unwhite(course.whiteness)[1]
    now = Kept(belief.filters, course.reached, white, course.turns, evidence(course))
    due = begins | (course.reached - belief.newer.time >= KEPT)
    return replace(
        belief,
        newer=select(due, now, belief.newer),
        older=select(begins, now, select(due, belief.newer, belief.older)),
    )
