"""The compiled program: the whole library at once, each term along the motion that was measured.

A free-running simulation is linear in what is wrong with it only as long as little is. Here the
simulation is pinned to the measured motion x at every sample (multiple shooting, a node at each),
and what it does otherwise is carried along linearly:

    d(i+1) = F_x d(i) + F_z dz + F_u u(i) + F(x(i)) - x(i+1)

so that the misfit is exact to second order in the noise wherever the model is right, however far
the baseline is from it, and a term costs its torque along x and no simulation.
"""

from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float, Int

from exoid.fit.chain import Chain
from exoid.fit.condense import along
from exoid.fit.coordinates import TYPICAL, Coordinates, seated
from exoid.fit.observation import Observation
from exoid.fit.residual import Equation, Stage, advance, equation, residual, sensor_map
from exoid.physics.extended import delayed, moment
from exoid.physics.moment import Cycle, Place
from exoid.physics.parameter import declarations
from exoid.physics.state import LegState
from exoid.physics.step import Drive, march, rk4
from exoid.physics.term import Term

BATCH = 64  # lanes and segments at once
MOST = 6  # parameters of a term
FREE = Stage(jnp.zeros(()), jnp.zeros((), int))


class Course(eqx.Module):
    """The leg's motion that a candidate reads from the sensors."""

    angle: Float[Any, "*lane segment time"]  # rad
    angular_velocity: Float[Any, "*lane segment time"]  # rad/s
    angular_acceleration: Float[Any, "*lane segment time"]  # rad/s^2


class Clock(eqx.Module):
    """The cycle of every segment; of frequency 0 where nothing is voluntary."""

    period: Float[Any, " segment"]  # s
    frequency: Float[Any, " segment"]  # Hz
    onset: Float[Any, " segment"]  # s
    number: Float[Any, " segment"]


class Effect(eqx.Module):
    """What a term does along a course: torques per inertia, and what the sensors show."""

    push: Drive  # rad/s^2, at the stage times
    shown: Float[Any, "*batch time channel"]  # rad, rad/s


class Pinned(eqx.Module):
    """(J, r)'(J, r) of every lane and segment: baseline unknowns, zeros, terms, residual."""

    gram: Float[Any, "lane segment column column"]
    course: Course  # along which
    first: Effect  # of the first lanes: what their first term does, and its derivatives


class Given(eqx.Module):
    """First terms of lanes as they were found: linear in their parameters."""

    effect: Effect  # (given, 1 + parameter, segment, time): with none at 0
    whose: Int[Any, " lane"]  # which of them a lane has
    change: Float[Any, "lane parameter"]  # of the parameters since


def evaluate(
    values: tuple[Array, ...],
    lanes: tuple[Array, ...],
    slots: tuple[Array, ...],
    given: Given,
    points: Coordinates,
    zero: Float[Array, "lane 2"],  # rad/s of the gyro, rad of the encoder
    courses: Course,
    measured: Course,
    observation: Observation,
    known: Float[Array, "segment unknown"],
    clock: Clock,
    steps: Int[Array, ""],
    static: tuple[tuple[type[Term], ...], Chain],
) -> Pinned:
    """Every lane's misfit and its derivatives.

    `courses` are where the lanes were last, `measured` is what the sensors show.

    Of each term in `static` there are requests: its parameters' `values`, the lane that they belong
    to and which of the lane's terms they are (`slots`). A lane's first term may be `given`.
    """
    terms, chain = static
    count = zero.shape[0]
    first = jax.tree.map(partial(recalled, given), given.effect)
    angle = first.shown[:, 0, :, :, 0] + zero[:, 1, None, None]
    courses = read(values, lanes, points, courses, measured, observation, clock, terms, angle)
    pushes, shown = nothing(observation, count, 2)
    pushes = jax.tree.map(lambda all, new: all.at[:, 0].set(new), pushes, first.push)
    shown = shown.at[:, 0].set(first.shown)
    for term, value, owner, slot in zip(terms, values, lanes, slots, strict=True):
        whose = jax.tree.map(lambda leaf, owner=owner: leaf[owner], (points, courses))
        one = partial(columns, term, observation=observation, clock=clock)
        push, error = jax.vmap(one)(value, *whose)
        at = (owner, slot)
        pushes = jax.tree.map(lambda all, new, at=at: all.at[at].add(new), pushes, push)
        shown = shown.at[at].add(error)
    lanes_at_once = max(1, BATCH // observation.time.shape[0])
    mounting = jax.vmap(jax.vmap(seated, in_axes=(None, 0)), in_axes=(0, None))
    own = (
        points.shared,
        mounting(points.mounting, observation.seat),
        points.own,
        courses,
        jax.tree.map(lambda leaf: jnp.moveaxis(together(leaf), 2, 1), pushes),
        jnp.moveaxis(together(shown), 2, 1),
        zero,
    )

    each = partial(segment_gram, steps=steps, chain=chain)
    by_segment: Any = jax.vmap(each, in_axes=(None, 0, 0, 0, 0, 0, 0, 0, None))

    def lane(own):
        return by_segment(*own[:4], observation, known, *own[4:])

    gram = jax.lax.map(lane, own, batch_size=lanes_at_once)
    kept = given.effect.shown.shape[0]
    found = Effect(jax.tree.map(lambda leaf: leaf[:kept, 0], pushes), shown[:kept, 0])
    return Pinned(gram, courses, found)


def recalled(given: Given, leaf: Array) -> Array:
    """What every lane's given term does now."""
    own = leaf[given.whose]
    change = jnp.einsum("lp,lp...->l...", given.change, own[:, 1:])
    return own.at[:, 0].add(change)


def read(values, lanes, points, courses, measured, observation, clock, terms, angle) -> Course:
    """The leg's motion behind what the sensors show, if the lanes' terms are right.

    `angle` is what the given terms show.
    """
    for term, value, lane in zip(terms, values, lanes, strict=True):
        if term.shown is Term.shown:
            continue
        own = jax.tree.map(lambda leaf, lane=lane: leaf[lane], (points, courses))

        def error(value, point, course, term=term):
            return everywhere(named(term, value), point, course, observation, clock).shown[..., 0]

        angle = angle.at[lane].add(jax.vmap(error)(value, *own))
    slope = jax.vmap(jax.vmap(rate), in_axes=(0, None))
    velocity = slope(angle, observation.time)
    errors = Course(angle, velocity, slope(velocity, observation.time))
    return jax.tree.map(jnp.subtract, measured, errors)


def rate(value, time):
    """The time derivative, by the parabola through three samples."""
    steps, rises = jnp.diff(time), jnp.diff(value)
    slopes = rises / steps
    inner = (slopes[:-1] * steps[1:] + slopes[1:] * steps[:-1]) / (steps[1:] + steps[:-1])
    return jnp.concatenate([slopes[:1], inner, slopes[-1:]])


def nothing(observation: Observation, lanes: int, slots: int):
    """Room for what the terms of every lane do: (lane, slot, 1 + parameter, segment, time)."""
    segments, size = observation.time.shape
    room = (lanes, slots, 1 + MOST, segments)
    push = jnp.zeros((*room, size - 1))
    return Drive(push, push, push), jnp.zeros((*room, size, 2))


def together(leaf: Array) -> Array:
    """(lane, slot, 1 + parameter, ...) as (lane, column, ...): all derivatives, then the sum."""
    parts = [leaf[:, slot, 1:] for slot in range(leaf.shape[1])]
    return jnp.concatenate([*parts, leaf[:, :, :1].sum(axis=1)], axis=1)


def columns(
    term: type[Term],
    value: Float[Array, " parameter"],
    point: Coordinates,
    course: Course,
    observation: Observation,
    clock: Clock,
) -> tuple[Drive, Float[Array, "column segment time channel"]]:
    """A term's effect and its derivatives, in the order (effect, derivatives, nothing)."""

    def effect(value):
        return everywhere(named(term, value), point, course, observation, clock)

    now = effect(value)
    slopes = jax.jacfwd(effect)(value)
    missing = MOST - value.size

    def stacked(one, slope):
        slope = jnp.moveaxis(slope, -1, 0)
        room = jnp.zeros((missing, *one.shape))
        return jnp.concatenate([one[None], slope, room])

    stack = jax.tree.map(stacked, now, slopes)
    return stack.push, stack.shown


def everywhere(term: Term, point: Coordinates, course: Course, observation, clock) -> Effect:
    """One term along all segments."""
    mounting = jax.vmap(seated, in_axes=(None, 0))(point.mounting, observation.seat)
    one = partial(effect_of, term, point.shared)
    return jax.vmap(one)(mounting, point.own, course, observation, clock)


def named(term: type[Term], value: Float[Array, " parameter"]) -> Term:
    """The term with these values of its parameters."""
    names = [name for name, _ in declarations(term)]
    return term(**dict(zip(names, value, strict=True)))


def place_of(eq: Equation, own, clock) -> Place:
    """What a term may know of its segment."""
    inertia = 1 / eq.torque
    cycle = Cycle(eq.cycle * inertia, clock.period, clock.frequency, clock.onset)
    return Place(eq.ratios, inertia, cycle, clock.number)


def effect_of(term: Term, shared, mounting, own, course, observation, clock) -> Effect:
    """One term along one segment."""
    eq = equation(shared, mounting, own, observation, FREE)
    place = place_of(eq, own, clock)
    time, step = observation.time, jnp.diff(observation.time)
    drives = jax.tree.map(
        lambda cycle, torque: eq.cycle * cycle + eq.torque * torque,
        observation.cycle,
        observation.torque,
    )
    begin, middle, end = stages(course, step)

    def moments(leg, time, push):
        return jax.vmap(partial(moment, place))(leg, time, push)

    at = (
        moments(begin, time[:-1], drives.begin),
        moments(middle, time[:-1] + step / 2, drives.middle),
        moments(end, time[1:], drives.end),
    )
    memory = remembered(term, at, step)
    middles = (memory[:-1] + memory[1:]) / 2
    torque = jax.vmap(term.torque)
    pulled = Drive(
        begin=torque(at[0], memory[:-1]),
        middle=torque(at[1], middles),
        end=torque(at[2], memory[1:]),
    )
    rubbed = rubbing(term, at, begin, end)
    push = jax.tree.map(lambda one, two: (one + two) / place.inertia, pulled, rubbed)
    ends = moments(
        LegState(course.angle, course.angular_velocity),
        time,
        jnp.append(drives.begin, drives.end[-1]),
    )
    error = jax.vmap(term.shown)(ends, memory)
    late = delayed(time, course.angular_velocity, course.angular_acceleration, error.delay)
    velocity = error.angular_velocity + late - course.angular_velocity
    return Effect(push, jnp.stack([error.angle, velocity], axis=-1))


def stages(course: Course, step) -> tuple[LegState, LegState, LegState]:
    """The leg at the begin, middle and end of every step; Hermite's rule in between."""
    angle, velocity, acceleration = (
        course.angle,
        course.angular_velocity,
        course.angular_acceleration,
    )
    begin, end = LegState(angle[:-1], velocity[:-1]), LegState(angle[1:], velocity[1:])
    middle = LegState(
        (angle[:-1] + angle[1:]) / 2 + step / 8 * (velocity[:-1] - velocity[1:]),
        (velocity[:-1] + velocity[1:]) / 2 + step / 8 * (acceleration[:-1] - acceleration[1:]),
    )
    return begin, middle, end


def remembered(term: Term, at, step) -> Float[Array, "time memory"]:
    """The term's own state at every sample, driven by the course."""
    first = jax.tree.map(lambda leaf: leaf[0], at[0])
    start = term.memory_at_rest(first)
    table = jnp.zeros((step.size + 1, term.memory_size))
    if not term.memory_size:
        return table

    def forward(index, memory):
        now = {
            part: jax.tree.map(lambda leaf: leaf[index], stage)
            for part, stage in zip((0.0, 0.5, 1.0), at, strict=True)
        }

        def part_of(number, memory):
            first = number / term.substeps

            def rate(memory, part):
                return term.memory_rate(blended(now, first + part / term.substeps), memory)

            return rk4(rate, memory, step[index] / term.substeps)

        memory = jax.lax.fori_loop(0, term.substeps, part_of, memory)
        return term.memory_within(now[1.0], memory)

    def store(index, memory, table):
        return table.at[index].set(memory)

    return march(forward, store, start, table, step.size)


def blended(now, part):
    """The moment at a fraction of a step, by the parabola through its three."""
    first, last = (1 - part) * (1 - 2 * part), part * (2 * part - 1)
    middle = 4 * part * (1 - part)
    return jax.tree.map(
        lambda a, b, c: first * a + middle * b + last * c, now[0.0], now[0.5], now[1.0]
    )


def rubbing(term: Term, at, begin: LegState, end: LegState) -> Drive:
    """Dry friction of a moving leg; a step across a reversal feels the mean of both directions."""
    if type(term).dry_friction is Term.dry_friction:
        none = jnp.zeros_like(begin.angle)
        return Drive(none, none, none)
    before, after = begin.angular_velocity, end.angular_velocity
    crossing = before * after < 0
    change = jnp.where(crossing, after - before, 1.0)
    mixed = (jnp.abs(after) - jnp.abs(before)) / change
    direction = jnp.where(crossing, mixed, jnp.sign(before + after))
    return Drive(*(-jax.vmap(term.dry_friction)(stage) * direction for stage in at))


def segment_gram(
    shared, mounting, own, course, observation, known, pushes, shown, zero, *, steps, chain
) -> Float[Array, "column column"]:
    """The products of one segment: baseline unknowns, zeros of gyro and encoder, terms' parameters,
    residual.

    The last column is no derivative but where the simulation stands beside the course.
    """
    unknowns = (shared, mounting, own)
    point, unravel = ravel_pytree(unknowns)
    sizes = (TYPICAL.shared, TYPICAL.mounting, TYPICAL.own)
    unit, _ = ravel_pytree(jax.tree.map(jnp.full_like, unknowns, sizes))
    base, terms = known.size, shown.shape[0]

    def setup(scaled):
        shared, mounting, own = unravel(scaled * unit)
        eq = equation(shared, mounting, own, observation, FREE)
        return eq, sensor_map(mounting, observation), LegState(own.angle, own.angular_velocity)

    (eq, sensors, start), (by_eq, by_sensors, by_start) = along(
        setup, (point / unit,), (jnp.diag(1 - known),)
    )
    pinned = LegState(course.angle, course.angular_velocity)
    steppers = jax.vmap(partial(linear_step, eq, by_eq, pinned, observation))
    carry, by_base, by_push, defect = steppers(jnp.arange(course.angle.size - 1))
    pushed = moved_by(by_push, pushes, eq).at[:, -1].add(defect)
    added = jnp.concatenate([by_base, jnp.zeros_like(by_base[:, :2]), pushed], axis=1)

    begin = jnp.stack(jax.tree.leaves(by_start), axis=1)
    offset = jnp.stack(
        [start.angle - course.angle[0], start.angular_velocity - pinned.angular_velocity[0]]
    )
    begin = jnp.concatenate([begin, jnp.zeros((2 + terms, 2)).at[-1].set(offset)])

    def forward(index, state):
        return state @ carry[index].T + added[index]

    def store(index, state, folded):
        memory, table = folded
        memory, seen = jax.vmap(chain.push)(memory, LegState(state[:, 0], state[:, 1]))
        return memory, table.at[index].set(jnp.stack([seen.angle, seen.angular_velocity], axis=1))

    memory = jax.vmap(chain.begin)(LegState(begin[:, 0], begin[:, 1]))
    table = jnp.zeros((course.angle.size, *begin.shape))
    moved = march(forward, store, begin, (memory, table), steps)[1]

    nothing = jnp.zeros((base, *shown.shape[1:]))
    drifting = jnp.zeros((2, *shown.shape[1:])).at[0, :, 1].set(1.0).at[1, :, 0].set(1.0)
    errors = jnp.moveaxis(jnp.concatenate([nothing, drifting, shown]), 0, 1)
    by_sensors = jnp.concatenate([by_sensors, jnp.zeros((2 + terms, 3))])

    def show(index):
        tangents = jnp.moveaxis(moved[index] + errors[index], 1, 0)

        def misfit(angle, velocity, sensors):
            return residual(LegState(angle, velocity), sensors, index, observation)

        here = (course.angle[index], course.angular_velocity[index], sensors)
        value, rows = along(misfit, here, (*tangents, by_sensors))
        return rows.at[-1].add(value + zero @ rows[base : base + 2])

    rows = jax.vmap(show)(jnp.arange(course.angle.size))
    rows = jnp.where(jnp.arange(course.angle.size)[:, None, None] <= steps, rows, 0.0)
    flat = jnp.moveaxis(rows, 1, 0).reshape(rows.shape[1], -1)
    return flat @ flat.T


def moved_by(by_push, pushes: Drive, eq: Equation) -> Float[Array, "step column state"]:
    """What torques at the stage times of every step do to its end."""
    return jnp.einsum("tsp,pct->tcs", by_push, jnp.stack(jax.tree.leaves(pushes)) / eq.share)


def linear_step(eq, by_eq, pinned, observation, index):
    """One step from the course: its derivatives by state, by every baseline unknown and by the
    torques at its begin, middle and end, and how far it ends from the course.
    """

    def step(eq, state, missing):
        return advance(eq, state, index, observation, FREE, missing)

    zero = jnp.zeros(())
    here, after = (jax.tree.map(lambda leaf, i=i: leaf[i], pinned) for i in (index, index + 1))
    following, by_base = along(lambda eq: step(eq, here, Drive(zero, zero, zero)), (eq,), (by_eq,))
    carry = jax.jacfwd(lambda state: vector(step(eq, LegState(*state), Drive(zero, zero, zero))))
    push = jax.jacfwd(lambda missing: vector(step(eq, here, Drive(*missing))))
    defect = vector(following) - vector(after)
    return carry(vector(here)), jnp.stack(jax.tree.leaves(by_base), 1), push(jnp.zeros(3)), defect


def vector(state: LegState):
    return jnp.stack([state.angle, state.angular_velocity])
