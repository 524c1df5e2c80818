"""The motion that was measured, as a term sees it: every instant at which a torque counts."""

from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.equation import Equation, applied, place_of
from exoid.physics.moment import Moment
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import moment
from exoid.physics.state import LegState
from exoid.physics.term import Term

FREE = Stage(np.zeros(()), np.zeros((), int))


class MeasuredMotion(eqx.Module):
    """The leg's motion that a candidate reads from the sensors."""

    angle: Float[Any, "*candidate segment time"]  # rad
    angular_velocity: Float[Any, "*candidate segment time"]  # rad/s
    angular_acceleration: Float[Any, "*candidate segment time"]  # rad/s^2


def behind(
    measured: MeasuredMotion, error: Float[np.ndarray, "segment time"], time: np.ndarray
) -> MeasuredMotion:
    """The motion of a leg whose encoder shows an error [rad], and with it a slope and a bend."""
    slope = rate(error, time)
    return MeasuredMotion(
        measured.angle - error,
        measured.angular_velocity - slope,
        measured.angular_acceleration - rate(slope, time),
    )


def rate(value: np.ndarray, time: np.ndarray) -> np.ndarray:
    """The time derivative, by the parabola through three samples."""
    steps, rises = np.diff(time), np.diff(value)
    slopes, before, after = rises / steps, steps[..., :-1], steps[..., 1:]
    inner = (slopes[..., :-1] * after + slopes[..., 1:] * before) / (after + before)
    return np.concatenate([slopes[..., :1], inner, slopes[..., -1:]], axis=-1)


class SegmentMotion(eqx.Module):
    """A segment's motion: the stages of every step, and every sample."""

    begin: Moment
    middle: Moment
    end: Moment
    sample: Moment
    acceleration: Float[Any, "*batch time"]  # rad/s^2, measured at every sample
    step: Float[Any, "*batch step"]  # s


def segment_motion(
    eq: Equation, measured: MeasuredMotion, observation: Observation
) -> SegmentMotion:
    """One segment's; Hermite's rule between samples."""
    place, drive = place_of(eq, observation, FREE), drive_of(eq, observation)
    time, step = observation.time, jnp.diff(observation.time)
    angle, velocity = measured.angle, measured.angular_velocity
    acceleration = measured.angular_acceleration
    middle = LegState(
        (angle[:-1] + angle[1:]) / 2 + step / 8 * (velocity[:-1] - velocity[1:]),
        (velocity[:-1] + velocity[1:]) / 2 + step / 8 * (acceleration[:-1] - acceleration[1:]),
    )
    pushed = jnp.append(drive.begin, drive.end[-1])
    return SegmentMotion(
        moment(place, LegState(angle[:-1], velocity[:-1]), time[:-1], drive.begin),
        moment(place, middle, time[:-1] + step / 2, drive.middle),
        moment(place, LegState(angle[1:], velocity[1:]), time[1:], drive.end),
        moment(place, LegState(angle, velocity), time, pushed),
        acceleration,
        step,
    )


def drive_of(eq: Equation, observation: Observation) -> Drive:
    """The known torques per inertia at the stage times [rad/s^2]."""
    return jax.tree.map(
        lambda cycle, torque: eq.cycle * cycle + applied(eq, torque),
        observation.cycle,
        observation.torque,
    )


@partial(jax.jit, static_argnames="name")  # traced once, for all stages of a step
def throughout(term: Term, name: str, now: Moment, *others: Any) -> Any:
    """What a term says, `term.name(moment, ...)`, of every instant of a segment."""
    motion = (now.time, now.angle, now.angular_velocity, now.angular_acceleration)

    def at(time, angle, velocity, acceleration, *others):
        moment = Moment(time, angle, velocity, acceleration, now.place)
        return getattr(term, name)(moment, *others)

    return jax.vmap(at)(*motion, *others)


def at_step(now: Moment, index: Array) -> Moment:
    """One instant of a segment."""
    return Moment(
        now.time[index],
        now.angle[index],
        now.angular_velocity[index],
        now.angular_acceleration[index],
        now.place,
    )
