"""What is true of a case, as its truth file says it."""

from dataclasses import asdict
from typing import Any

import numpy as np

from .bound import Levels, Swing, refit, smallest_errors
from .case import Case
from .devices import Errors
from .measure import Segment
from .session import Happened, Session

HARMLESS = 0.1  # of a noise level: what the rest of a hand's push may still do
FEWEST = 3  # samples of a swing that tell anything


def truth_of(case: Case, session: Session, segments: tuple[Segment, ...]) -> dict[str, Any]:
    """Times are the time column's, in the segment that is named."""
    device, leg = case.device, case.person.leg
    levels = Levels(device.whole_angle_noise, device.whole_velocity_noise or 1.0)
    placed = [(drop, place(drop, session, segments)) for drop in session.drops]
    drops, swings = [], []
    for drop, number in placed:
        start = harmless(case, session, drop, levels)
        drops.append(told(drop, start, number, segments[number], case.errors.clock))
        swing = swing_of(case, session, segments[number], max(start, drop.held), drop.end)
        swings += [swing] if swing.time.size >= FEWEST else []
    found = refit(leg.ratios, swings, levels) if case.effect.name != "none" else None
    return {
        "id": case.name,
        "person": case.person.kind,
        "body_mass_kg": case.person.body_mass,
        "height_m": case.person.height,
        "leg": leg._asdict(),
        "ratios": leg.ratios,
        "bound": smallest_errors(leg.ratios, swings, levels),
        "device": asdict(device),
        "angle_noise_rad": device.whole_angle_noise,
        "velocity_noise_rad_s": device.whole_velocity_noise,
        "trouble": case.trouble,
        "effect": case.effect.name,
        "size": case.effect.size,
        "visible": None if found is None else found.left,
        "refitted_ratios": None if found is None else found.ratios,
        "systematic": case.systematic,
        "tilt_rad": case.physics.tilt,
        "errors": asdict(case.errors),
        "table": case.protocol.table,
        "tremor_rad": [drop.tremor.size for drop in case.protocol.drops],
        "motionless_segments": [0] if case.protocol.hanging and not case.protocol.table else [],
        "drops": drops,
    }


def place(drop: Happened, session: Session, segments: tuple[Segment, ...]) -> int:
    """The segment that shows a drop."""
    ends = [end for _, end in session.windows]
    return int(np.searchsorted(ends, drop.end - 1e-9))


def harmless(case: Case, session: Session, drop: Happened, levels: Levels) -> float:
    """s of the session, from which on what the hand still does is below any noise."""
    motion = session.motion
    low, high = np.searchsorted(motion.time, [drop.released, drop.free])
    push = motion.hand[low : high + 1] / case.physics.inertia
    tick = motion.time[1] - motion.time[0]
    speed = np.abs(np.cumsum(push[::-1])[::-1]) * tick  # still to come, rad/s
    way = np.cumsum(speed[::-1])[::-1] * tick  # rad
    gyro = case.device.velocity_noise is not None
    seen = (way > HARMLESS * levels.angle) | (gyro & (speed > HARMLESS * levels.velocity))
    last = int(np.flatnonzero(seen)[-1]) + 1 if seen.any() else 0
    return float(motion.time[min(low + last, high)])


def told(drop: Happened, start: float, number: int, segment: Segment, clock: float):
    """A drop, in the time column of its segment."""

    def recorded(time: float) -> float:
        return round(float(segment.recorded(time, clock)), 6)

    return {
        "segment": number,
        "begins_in_motion": drop.held > drop.free,
        "held_s": recorded(min(drop.held, drop.released)),
        "release_begins_s": recorded(drop.released),
        "harmless_s": recorded(start),
        "release_ends_s": recorded(drop.free),
        "end_s": recorded(drop.end),
        "end": drop.kind,
    }


def swing_of(case: Case, session: Session, segment: Segment, begin: float, end: float) -> Swing:
    """What the sensors would show without noise, at the samples of the free swing that are there.

    Errors of the sensors that are systematic are left out; those that are the effect are in.
    """
    errors, motion = Errors(**case.effect.sensor), session.motion
    free = (segment.time >= begin) & (segment.time < end)
    time, columns = segment.time[free], {k: v[free] for k, v in segment.columns.items()}
    seen = time[np.isfinite(columns["raw_angle_rad"])]
    gyro = columns.get("raw_velocity_rad_s", np.full(time.size, np.nan))
    felt = time[np.isfinite(gyro)]
    first = min((t[0] for t in (seen, felt) if t.size), default=begin)
    start = (float(motion.angle_at(first)), float(motion.rate_at(first)))
    rate = errors.velocity(motion.rate_at(np.maximum(felt - errors.delay, 0.0)))
    return Swing(seen, errors.angle(motion.angle_at(seen)), felt, rate, start)
