"""A segment as it enters the fit: its channels, its extent, its clock, its noise."""

from dataclasses import dataclass

import numpy as np

from exoid.fit.systematics import DECLARED_NOTHING, Systematics, systematics
from exoid.recording.condition import (
    SMOOTHING,
    best_velocity,
    classify,
    clip,
    cut,
    local_line,
    measure_period,
    movements,
)
from exoid.recording.noise import angle_noise, velocity_noise
from exoid.recording.recording import Recording, Samples, Segment

FEWEST = 10  # samples that a movement must have to be fitted
RELEASE = 0.2  # s before 20 deg/s are reached, within which a leg was let go
MARKED = 0.045  # s of rest in front of a movement that was marked at its release: soft cuffs wait
FALL = 0.06  # s, in which a leg that was let go speeds up evenly
REVERSED = -0.5  # of the angle's own slope: below it a gyro turns the other way
STILL = np.radians(2.0)  # rad/s, reached within 2 ms of a release
SETTLING = 0.15  # s of rest before a cycle below which its clock starts with the segment


@dataclass(frozen=True, eq=False)
class Movement:
    """A segment as it enters the fit: clipped, on its own clock, with its noise and its drive."""

    name: str  # of the recording, and the segment's number in it
    kind: str  # passive, active or measured
    kind_said: bool  # by the sidecar; otherwise it was taken from the shape of the motion
    segment: Segment
    angle: Samples  # rad, the channel that is fitted
    angular_velocity: Samples | None
    filtered: bool  # that channel went through the firmware's filter
    angle_noise: float  # rad
    velocity_noise: float  # rad/s
    onset: float  # s, where the clock of Eq. 10 starts
    period: float  # s, of the cycle; nan where there is none
    added_mass: float  # kg
    added_mass_distance: float  # m, nan where it is to be estimated
    thigh_angle: float  # rad
    recording: int = 0  # of those that are fitted together
    systematics: Systematics = DECLARED_NOTHING  # how well what is declared is known

    @property
    def source(self) -> str:
        """The recording, by its name where there are several."""
        return self.name.rpartition(" ")[0] or "recording"

    @property
    def voluntary(self) -> bool:
        return self.kind == "active"

    @property
    def scaled(self) -> bool:
        """Does a known mass or torque act, so that this segment can tell the inertia?"""
        return self.kind == "measured" or self.added_mass > 0

    @property
    def unplaced(self) -> bool:
        """Is it unknown where the added mass sat?"""
        return self.added_mass > 0 and bool(np.isnan(self.added_mass_distance))


def movement(
    recording: Recording, number: int, name: str, belongs: int = 0, *, whole: bool = False
) -> Movement:
    """Condition one segment: choose its channels, clip its ends, find its clock and its noise.

    `belongs` counts the recordings that are fitted together. `whole` keeps the release and, of a
    drop, the coming to rest, which a fit leaves out: what Eq. 9 lacks may show in them.

    **Raises** `ValueError` where nothing moves, or a torque is missing.
    """
    segment, said = recording.segments[number], recording.kind(number)
    kind = said or classify(segment) or "passive"
    if kind == "measured" and segment.applied_torque is None:
        raise ValueError(f"segment {name} is said to be measured, but has no torque_nm column.")
    part, onset, period = extent(segment, kind, recording.cycle_period(number), name)
    if whole:
        part = slice(
            release(segment, part, kind), segment.time.size if kind == "passive" else part.stop
        )
    clipped = cut(segment, part)
    raw = clipped.raw_angle is not None
    angle = clipped.raw_angle if raw else clipped.angle
    velocity = clipped.raw_angular_velocity if raw else clipped.angular_velocity
    mass, distance = recording.added_mass(number), recording.added_mass_distance(number)
    assert angle is not None  # a Segment has one or the other
    check_sense(clipped, angle, velocity, name)
    return Movement(
        name=name,
        kind=kind,
        kind_said=said is not None,
        segment=clipped,
        angle=angle,
        angular_velocity=velocity,
        filtered=not raw,
        angle_noise=angle_noise(recording.sensors, angle),
        velocity_noise=velocity_noise(recording.sensors, velocity),
        onset=onset - float(segment.time[part.start]),
        period=period,
        added_mass=mass,
        added_mass_distance=np.nan if mass > 0 and distance is None else distance or 0.0,
        thigh_angle=recording.thigh_angle(number),
        recording=belongs,
        systematics=systematics(recording, number),
    )


def check_sense(segment: Segment, angle: Samples, velocity: Samples | None, name: str) -> None:
    """Refuse a gyro that turns the other way than the encoder."""
    if velocity is None:
        return
    slope, seen = local_line(segment.time, angle, SMOOTHING)[1], ~np.isnan(velocity)
    if np.sum(slope[seen] * velocity[seen]) < REVERSED * np.sum(slope[seen] ** 2):
        raise ValueError(
            f"segment {name}: the angular velocity is the angle's with the other sign. Extension "
            "is positive in both: change the sign of one of them."
        )


def extent(
    segment: Segment, kind: str, period: float | None, name: str
) -> tuple[slice, float, float]:
    """The samples to fit, and of a cycle when its clock starts [s] and how long it runs [s].

    Ends slower than 20 deg/s are cut off; a cycle also ends after its period, when it is caught.
    What a measured torque moves is kept whole: its rest tells about the torque.
    """
    if kind == "measured":
        return slice(0, segment.time.size), 0.0, np.nan
    try:
        part = clip(best_velocity(segment))
    except ValueError as fault:
        raise ValueError(f"segment {name}: {fault}") from fault
    onset = float(segment.time[0])
    if kind == "active":
        onset = find_onset(segment)
        period = measure_period(segment) if period is None else period
        stop = int(np.searchsorted(segment.time, onset + period, side="right"))
        part = slice(part.start, min(part.stop, stop))
    if part.stop - part.start < FEWEST:
        raise ValueError(
            f"segment {name} moves faster than 20 deg/s in {max(part.stop - part.start, 0)} "
            f"samples; {FEWEST} are the least. Check its marks, its period and its units."
        )
    return part, onset, np.nan if period is None else period


def release(segment: Segment, part: slice, kind: str) -> int:
    """The first sample of a segment that was marked at its release, else the last one at rest.

    Play and compliance may keep the sensors at rest for a moment after the leg was let go, or move
    them the other way. A leg that falls behind its play is as fast as if the sensors had followed
    from the release on.
    """
    velocity, time = best_velocity(segment), segment.time
    first = int(np.searchsorted(time, time[part.start] - RELEASE))
    speed = np.abs(velocity[first : part.start + 1])
    still = np.flatnonzero(speed < STILL)
    begun = first + int(np.argmax(speed >= STILL))
    if first == 0 and (not still.size or time[begun] - time[0] < MARKED):
        return 0
    if not still.size:
        return part.start
    last = first + int(still[-1])
    if kind != "passive":
        return last
    fallen = from_standstill(time, velocity, part.start)
    hidden = fallen < time[last] - MARKED / 2
    return max(first, int(np.argmin(np.abs(time - fallen)))) if hidden else last


def from_standstill(time: Samples, velocity: Samples, start: int) -> float:
    """When a leg that speeds up evenly was at rest [s]: its speed after `start`, followed back."""
    first = int(np.searchsorted(time, time[start] + SMOOTHING / 2))
    stop = max(int(np.searchsorted(time, time[first] + FALL)), first + 3)
    slope, level = np.polyfit(time[first:stop] - time[start], velocity[first:stop], 1)
    return float(time[start] - level / slope)


def find_onset(segment: Segment) -> float:
    """When the movement begins [s]: after the rest in front of it, or with the segment."""
    found = movements(segment)
    begin = float(segment.time[0])
    first = float(segment.time[found[0].start]) if found else begin
    return first if first > begin + SETTLING else begin


def smoothed_motion(each: Movement, width: float) -> tuple[Samples, Samples]:
    """Angle and angular velocity as the leg had them, before any chain, smoothed over `width` s."""
    part = each.segment
    angle = part.angle if part.raw_angle is None else part.raw_angle
    gyro = part.angular_velocity if part.raw_angle is None else part.raw_angular_velocity
    assert angle is not None  # a Segment has one or the other
    smooth, slope = local_line(part.time, angle, width)
    return smooth, slope if gyro is None else local_line(part.time, gyro, width)[0]
