"""What a fit, or a diagnosis, found of a joint, by the true clock."""

from collections.abc import Iterable

import jax.numpy as jnp
import numpy as np

from exoid.files.visible import visible
from exoid.fitting.data.observe import between, is_curved, with_gaps_bridged
from exoid.fitting.model.term_parameters import term_of
from exoid.fitting.result.conditions import Conditions
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.interchange.model.formulas import part_of
from exoid.interchange.model.joint import Joint, Sensing
from exoid.interchange.model.numbers import (
    drive_numbers,
    gravity_number,
    leg_numbers,
    ratio_numbers,
    term_numbers,
)
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.moment import SegmentConstants
from exoid.physics.motion.after_release import after_release
from exoid.physics.motion.simulate import cycle_of
from exoid.physics.scale import Scale
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.state import LegState
from exoid.physics.term import Term, name_of
from exoid.physics.torque import CycleTorque, MeasuredTorque, NoTorque, Torque

IF_SLACK = (
    "'if slack' is an error more, for a knee's spring that is slack elsewhere than at full "
    "extension."
)


def gather(result: FitResult, segment: int | None) -> Joint:
    """The joint of a fit: bare, or as one of its segments had it, with added mass and torque.

    A bare one begins as the first segment did. Segments count from 0, as the table of a fit does.

    **Raises** `ValueError` where the fit holds no one model, or has no such segment.
    """
    each, begun = chosen(result, segment)
    whole = segment is not None
    clock = (1 + begun.clock) * (1 + clock_error(result.fitted_terms))
    assert result.leg is not None  # `chosen` has asked
    leg = loaded(result.leg, begun) if whole else result.leg
    drive = driving(each, begun, clock) if whole else NoTorque()
    terms = tuple(by_clock(term, clock) for term in result.fitted_terms if not is_clock(term))
    model = LegModel(leg, drive, np.asarray(begun.thigh_angle), terms)
    first = float(begun.angle), float(begun.angular_velocity / clock)
    memories = remembered(model, first, float(each.time[0]) * clock, begun.number)
    return Joint(
        title=titled(result, each, begun, whole),
        numbers=tuple(leg_numbers(result, leg)),
        gravity=gravity_number(result, leg),
        ratios=tuple(ratio_numbers(result, leg)),
        thigh_angle=begun.thigh_angle,
        parts=tuple(
            part_of(term, term_numbers(term, result), memory)
            for term, memory in zip(terms, memories, strict=True)
        ),
        angle=first[0],
        rate=first[1],
        drive=drive,
        drive_numbers=drive_numbers(drive, each),
        number=begun.number,
        times=np.asarray(each.time) * clock,
        clock=clock,
        finer=begun.finer,
        sensing=sensing(each, begun),
        reach=reach(result),
        astray=result.astray,
    )


def chosen(result: FitResult, segment: int | None) -> tuple[SegmentFit, Conditions]:
    """The segment that is asked for, and how it began."""
    if result.leg is None:
        raise ValueError(
            "every segment was fitted alone there: it holds no one model. Fit them together."
        )
    number, last = segment or 0, len(result.segments) - 1
    if not 0 <= number <= last:
        raise ValueError(f"there is no segment {number}: the fit has the segments 0 to {last}.")
    each = result.segments[number]
    if each.conditions is None:
        raise ValueError(
            "this was saved by an older exoid, which did not keep how its segments began: fit "
            "again, and save that."
        )
    return each, each.conditions


def clock_error(terms: Iterable[Term]) -> float:
    """What a term says of the recording's clock: true seconds in a recorded one, less 1."""
    return sum((float(term.rate) for term in terms if isinstance(term, ClockRate)), start=0.0)


def is_clock(term: Term) -> bool:
    """Is it the recording's clock alone, which an exported leg does not have?"""
    return isinstance(term, ClockRate)


def loaded(leg: LegParameters, begun: Conditions) -> LegParameters:
    """The leg with the segment's added mass."""
    mass = leg.mass + begun.added_mass
    moment = leg.mass * leg.com_distance + begun.added_mass * begun.added_distance
    return LegParameters(
        np.asarray(mass),
        np.asarray(leg.inertia + begun.added_inertia),
        np.asarray(moment / mass),
        leg.damping,
        leg.stiffness,
    )


def driving(each: SegmentFit, begun: Conditions, clock: float) -> Torque:
    """What drove the segment."""
    if begun.torque is not None:
        return measured(np.asarray(each.time), np.asarray(begun.torque), clock)
    if begun.amplitude == 0.0:
        return NoTorque()
    period, frequency, onset = begun.period * clock, begun.frequency / clock, begun.onset * clock
    return CycleTorque(*map(jnp.asarray, (begun.amplitude, period, frequency, onset)))


def measured(time: np.ndarray, torque: np.ndarray, clock: float) -> MeasuredTorque:
    """A torque that was measured; of a curve between its samples, the fit saw the middle of every
    step, too.
    """
    at = with_middles(with_gaps_bridged(time)) if is_curved(torque) else time
    return MeasuredTorque(jnp.asarray(at * clock), jnp.asarray(between(at, time, torque)))


def with_middles(edges: np.ndarray) -> np.ndarray:
    """Where steps begin and end, and their middles."""
    return np.sort(np.append(edges, (edges[:-1] + edges[1:]) / 2))


def by_clock(term: Term, clock: float) -> Term:
    """A term's numbers by the true clock, where they hold seconds of the recording's."""
    scale = Scale(time=clock)
    return term_of(
        type(term),
        lambda name, said: float(getattr(term, name.partition(".")[2])) * scale.of(said.unit),
    )


def remembered(
    model: LegModel, first: tuple[float, float], time: float, number: int
) -> list[np.ndarray]:
    """What every term remembers where the motion begins: the fall from rest to there."""
    inertia = jnp.asarray(model.leg.inertia)
    place = SegmentConstants(
        model.ratios(), inertia, cycle_of(model.torque), jnp.asarray(float(number))
    )
    at = jnp.asarray(time)
    leg, push = LegState(*map(jnp.asarray, first)), model.torque(at) / inertia
    return [*map(np.asarray, after_release(place, model.terms, leg, at, push).memory)]


def reach(result: FitResult) -> tuple[float, float]:
    """The lowest and the highest angle of the fitted motions [rad]."""
    angles = np.concatenate([each.simulated_angle for each in result.segments])
    return float(np.nanmin(angles)), float(np.nanmax(angles))


def sensing(each: SegmentFit, begun: Conditions) -> Sensing:
    return Sensing(
        begun.zero, begun.gyro_scale, begun.gyro_bias, each.angle_noise, each.velocity_noise
    )


def titled(result: FitResult, each: SegmentFit, begun: Conditions, whole: bool) -> tuple[str, ...]:
    """What was exported, in lines."""
    names = [name_of(type(term)).replace("_", " ") for term in result.fitted_terms]
    called = visible(each.name)
    lines = [f"The leg that exoid fitted, with {', '.join(names) or 'Eq. 9 alone'}."]
    if whole and begun.added_mass:
        lines.append(
            f"As in segment {called}: with the added mass of {begun.added_mass:.3f} kg at "
            f"{begun.added_distance:.3f} m, which m, l and J hold."
        )
    elif whole:
        lines.append(f"As in segment {called}.")
    else:
        lines.append(f"Without any added mass or torque; it begins as segment {called} did.")
    push = each.torque_amplitude
    if whole and push is not None and push.value is None:
        lines.append(f"Its drive is not determined: {visible(push.reason or 'nothing tells it')}.")
    numbers = (result.of_leg | result.ratios | result.of_terms).values()
    if any(found.if_slack is not None for found in numbers):
        lines.append(IF_SLACK)
    if result.astray is not None:
        lines.append(
            f"It does not follow its recording: {visible(result.astray)}. Trust no number."
        )
    return tuple(lines)
