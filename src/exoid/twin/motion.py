"""The true motion of a session: rest, release, motion, catch, rest, lift to the next release."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Literal

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import LegModel
from exoid.physics.moment import Moment, SegmentConstants
from exoid.physics.motion.parts_of_a_step import parts_to_follow
from exoid.physics.motion.simulate import FIRST, cycle_of, simulate
from exoid.physics.motion.step import march, rk4
from exoid.physics.motion.with_terms import delayed, errors
from exoid.physics.state import LegState
from exoid.physics.term import SensorTerm
from exoid.physics.torque import CycleTorque, NoTorque
from exoid.recordings.declared.protocol import Kind
from exoid.twin.sensors import ShownMotion

REST = 1.5  # s held still before each release
REST_MARKED = 1.0  # s of that rest which belong to the segment
CATCH = 0.03  # s, time constant with which a hand stops the leg
CAUGHT = 1.0  # s from the catch to the next lift
LIFT = 1.5  # s from where one movement ended to where the next begins

FrequencyReading = Literal["1/T", "2/T"]  # of Eq. 4
CYCLES = {"1/T": 1.0, "2/T": 2.0}  # of the torque's sine in one period


@dataclass(frozen=True)
class Movement:
    """One release from rest: a passive drop, or a voluntary cycle of Eq. 10."""

    start_angle: Annotated[float, "rad"]
    duration: Annotated[float, "s"]  # from the release to the catch; of a cycle its period T
    amplitude: Annotated[float | None, "N m"] = None  # tau of Eq. 10; None for a drop
    added_mass: Annotated[float, "kg"] = 0.0
    added_mass_distance: Annotated[float, "m"] = 0.0

    @property
    def kind(self) -> Kind:
        return "passive" if self.amplitude is None else "active"


class Session(eqx.Module):
    """The motion of a whole session, and the samples at which its segments start and end."""

    course: ShownMotion
    start: tuple[int, ...] = eqx.field(static=True)
    end: tuple[int, ...] = eqx.field(static=True)


def perform(
    model: LegModel, movements: Sequence[Movement], reading: FrequencyReading, time_step: float
) -> Session:
    """The movements one after the other, on a grid of `time_step` [s].

    What is wrong with the sensors is so all the time, while a hand holds or lifts the leg as well.
    """
    parts, starts, ends, size = [], [], [], 0
    sensing = tuple(term for term in model.terms if isinstance(term, SensorTerm))
    others = tuple(term for term in model.terms if not isinstance(term, SensorTerm))
    motions = release(replace(model, terms=others), movements, reading, time_step)
    for before, motion, after in surround(motions, time_step):
        released = size + before.angle.size
        starts.append(released - round(REST_MARKED / time_step))
        ends.append(released + motion.angle.size - 1)
        size = ends[-1] + 1 + after.angle.size
        parts += [before, motion, after]
    shown = sensed(model, sensing, joined(parts), time_step)
    return Session(shown, tuple(starts), tuple(ends))


def sensed(
    model: LegModel, sensing: tuple[SensorTerm, ...], course: ShownMotion, time_step: float
) -> ShownMotion:
    """What encoder and gyro show of a course."""
    if not sensing:
        return course
    place = SegmentConstants(
        model.ratios(), jnp.asarray(model.leg.inertia), cycle_of(NoTorque()), FIRST
    )
    time = jnp.arange(course.angle.size) * time_step

    def moment(time, angle, velocity, acceleration):
        return Moment(time, angle, velocity, acceleration, place)

    motion = (course.angle, course.angular_velocity, course.angular_acceleration)
    moments = jax.vmap(moment)(time, *motion)
    memory = tuple(remembered(term, moments, time_step) for term in sensing)
    each = jax.vmap(partial(errors, sensing))(moments, memory)
    velocity = course.angular_velocity + each.angular_velocity
    late = delayed(time, velocity, course.angular_acceleration, each.delay)
    return ShownMotion(course.angle + each.angle, late, course.angular_acceleration)


def remembered(term: SensorTerm, moments: Moment, time_step: float) -> Float[Array, "time memory"]:
    """The sensor's own state at every sample of a course that begins at rest."""
    steps = moments.time.size - 1

    def at_sample(index):
        return jax.tree.map(lambda leaf: leaf[index], moments)

    def forward(index, memory):
        before, after = at_sample(index), at_sample(index + 1)

        def rate(memory, part):
            now = jax.tree.map(lambda begin, end: begin + part * (end - begin), before, after)
            return term.memory_rate(now, memory)

        return rk4(rate, memory, jnp.asarray(time_step))

    def store(index, memory, table):
        return table.at[index].set(memory)

    table = jnp.zeros((steps + 1, term.memory_size))
    return march(forward, store, term.memory_at_rest(at_sample(0)), table, steps)


def release(
    model: LegModel, movements: Sequence[Movement], reading: FrequencyReading, time_step: float
) -> list[ShownMotion]:
    """The motion of every movement from its release to its catch, all in one compiled program."""
    samples = [1 + round(movement.duration / time_step) for movement in movements]
    time = jnp.arange(max(samples)) * time_step

    def motion(number, start, period, amplitude, mass, distance):
        torque = CycleTorque(amplitude, period, CYCLES[reading] / period, jnp.zeros(()))
        driven = replace(model, leg=model.leg.with_added_mass(mass, distance), torque=torque)
        begin = LegState(start, jnp.zeros_like(start))
        parts = parts_to_follow([*map(type, model.terms)], time_step)
        moved = simulate(driven, begin, time, number, parts=parts)
        return ShownMotion(moved.shown_angle, moved.shown_velocity, moved.angular_acceleration)

    rows = [
        (k, m.start_angle, m.duration, m.amplitude or 0.0, m.added_mass, m.added_mass_distance)
        for k, m in enumerate(movements)
    ]
    moved = jax.jit(jax.vmap(motion))(*jnp.array(rows).T)
    return [jax.tree.map(lambda s, i=i, n=n: s[i, :n], moved) for i, n in enumerate(samples)]


def surround(motions: list[ShownMotion], time_step: float):
    """Each motion between the rest before it and the catch and lift after it."""
    begins = [motion.angle[0] for motion in motions]
    for motion, begin, following in zip(motions, begins, [*begins[1:], None], strict=True):
        caught = catch(motion, time_step)
        raised = [] if following is None else [lift(caught.angle[-1], following, time_step)]
        yield hold(begin, round(REST / time_step)), motion, joined([caught, *raised])


def hold(angle: Float[Array, ""], samples: int) -> ShownMotion:
    still = jnp.zeros(samples)
    return ShownMotion(still + angle, still, still)


def catch(motion: ShownMotion, time_step: float) -> ShownMotion:
    """A hand stops the leg: its velocity decays with `CATCH`, then it is held."""
    time = jnp.arange(1, round(CAUGHT / time_step)) * time_step
    angle, velocity = motion.angle[-1], motion.angular_velocity[-1]
    slowing = velocity * jnp.exp(-time / CATCH)
    return ShownMotion(angle + CATCH * (velocity - slowing), slowing, -slowing / CATCH)


def lift(start: Float[Array, ""], end: Float[Array, ""], time_step: float) -> ShownMotion:
    """A raised cosine from one angle to another."""
    rate, half = jnp.pi / LIFT, (end - start) / 2
    phase = jnp.linspace(0, jnp.pi, round(LIFT / time_step))
    return ShownMotion(
        start + half * (1 - jnp.cos(phase)),
        half * rate * jnp.sin(phase),
        half * rate**2 * jnp.cos(phase),
    )


def joined(parts: list[ShownMotion]) -> ShownMotion:
    return jax.tree.map(lambda *each: jnp.concatenate(each), *parts)
