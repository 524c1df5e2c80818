"""What a drop's first swing misses, and where: a push, or what sensor or spring do at an angle?

A push, a hand or a muscle's twitch acts at a moment; what an angle sensor or a spring does, it does
wherever the leg passes the same angle again. Over short windows the rate changes by what Eq. 9
makes of it, and by what is missing: its impulse, of which nothing need be assumed.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.data.guide import GUIDE_WIDTH
from exoid.fitting.data.movement import KeptBack, Movement, smoothed_motion
from exoid.physics.ratios import Ratios
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.local_line import interpolated, local_line

WINDOW = 0.1  # s
STRONG = 0.06  # of a drop's greatest speed: springs and sensors that bend make 0.04 at most
LOUD = 8.0  # standard deviations of what later swings miss: sensors that bend make 6.1 at most
BENT = 0.25  # of how far such an impulse moves the leg in a window, and ...
LEAST = float(np.radians(0.2))  # ... at least, by which an encoder departs from its gyro


@dataclass(frozen=True)
class Thrust:
    """The largest impulse that a first swing misses."""

    size: float  # rad/s, over the inertia
    clear: bool  # is it more than a release and noise make?
    place: tuple[float, float]  # rad, where the leg was
    first: tuple[float, float]  # rad, between which it fell
    later: tuple[float, float]  # rad, between which it swung afterwards
    shown_by_gyro: bool  # does a gyro show the same motion as the encoder?


def thrust(each: Movement, leg: Ratios, zero: float, begin: int) -> Thrust:
    """Of a drop whose swings from sample `begin` on have shown the leg; `zero` of its encoder."""
    shown, rate = smoothed_motion(each, GUIDE_WIDTH)
    time, angle, end = each.segment.time, shown - zero, each.kept or each.angle.size
    width = max(1, int(np.searchsorted(time, time[0] + WINDOW)))
    missing = impulses(time, angle, rate, leg)
    lost = (missing[width:] - missing[:-width])[: max(end - width, 1)]
    early = min(int(np.searchsorted(time, time[0] + GUIDE_WIDTH)), max(begin - width, 0))
    fall = lost[early : max(begin - width, 0) + 1]
    spread = float(np.std(lost[begin:])) if lost.size > begin + 1 else np.inf
    at = early + int(np.argmax(np.abs(fall)))
    size, speed = float(lost[at]), float(np.abs(rate[: begin + 1]).max())
    return Thrust(
        size=size,
        clear=abs(size) > max(STRONG * speed, LOUD * spread),
        place=between(angle[at : at + width + 1]),
        first=between(angle[: begin + 1]),
        later=between(angle[begin:end]),
        shown_by_gyro=agree(each, max(BENT * abs(size) * WINDOW, LEAST)),
    )


def impulses(time: Samples, angle: Samples, rate: Samples, leg: Ratios) -> Samples:
    """What the rate has gained up to each sample that Eq. 9 does not make [rad/s]."""
    law = by_law(angle, rate, leg)
    made = np.cumsum((law[1:] + law[:-1]) / 2 * np.diff(time))
    return rate - np.concatenate([[0.0], made])


def by_law(angle: Samples, rate: Samples, leg: Ratios) -> Samples:
    """What Eq. 9 makes of it where no torque acts [rad/s^2]."""
    pull = -leg.gravity * np.cos(angle + leg.thigh_angle) - leg.stiffness * angle
    return np.asarray(pull - leg.damping * rate)


def between(angle: Samples) -> tuple[float, float]:
    return float(angle.min()), float(angle.max())


def agree(each: Movement, bent: float) -> bool:
    """Does a gyro, but for bias and scale, move as the encoder, which departs from it by less than
    `bent` [rad]?
    """
    if each.angular_velocity is None:
        return False
    time = each.segment.time
    angle, rate = (interpolated(time, one) for one in (each.angle, each.angular_velocity))
    turned = np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2 * np.diff(time))])
    columns = np.stack([np.ones_like(time), time, turned], axis=1)
    apart = angle - columns @ np.linalg.lstsq(columns, angle)[0]
    inside = (time > time[0] + GUIDE_WIDTH) & (time < time[-1] - GUIDE_WIDTH)
    shown = local_line(time, apart, GUIDE_WIDTH)[0][inside]
    return bool(np.abs(shown).max(initial=0.0) < bent)


def pushed_by(drops: Sequence[Thrust | None]) -> list[KeptBack]:
    """What may have moved each of these drops otherwise in its first swing, if it did: what the
    leg passes elsewhere without it, neither a sensor nor a spring makes. All may, where none
    clearly did.
    """
    known = [one for one in drops if one is not None]
    clear = [one for one in known if one.clear]
    even = all(one.shown_by_gyro for one in clear or known)
    by: KeptBack = "thrust or spring" if even else "neither"
    if any(passed(one, known) for one in clear):
        by = "thrust"
    return ["alike" if clear and not (one and one.clear) else by for one in drops]


def passed(one: Thrust, drops: Sequence[Thrust]) -> bool:
    """Does the leg pass the place of a thrust in other swings, without any?"""
    ways = [each.later for each in drops] + [each.first for each in drops if not each.clear]
    return min(low for low, _ in ways) <= one.place[0] and one.place[1] <= max(
        high for _, high in ways
    )
