"""What a fit sees of a recording: samples to meet, their noise, and what drove each segment."""

from dataclasses import dataclass
from typing import Any

import equinox as eqx
import jax
import numpy as np
from jaxtyping import Float

from exoid.fit.coordinates import Seat
from exoid.physics.simulate import Drive
from exoid.physics.torque import cycle_shape
from exoid.recording.condition import (
    best_velocity,
    classify,
    clip,
    cut,
    interpolated,
    local_line,
    measure_period,
    movements,
    torque_frequencies,
)
from exoid.recording.recording import Recording, Samples, Segment, Sensors

LONGEST_STEP = 0.02  # s; a gap or slow sampling is bridged by samples that weigh nothing
FEWEST = 10  # samples that a movement must have to be fitted
SETTLING = 0.15  # s of rest before a cycle below which its clock starts with the segment
GUIDE_WIDTH = 0.06  # s, over which angle and velocity are smoothed to guide a start


class Observation(eqx.Module):
    """One segment; a joint fit carries one more leading axis `segment`.

    Rows beyond the end of a segment continue its clock with weight 0, so that segments of
    different length share one shape.
    """

    time: Float[Any, "*segment time"]  # s
    angle: Float[Any, "*segment time"]  # rad
    angular_velocity: Float[Any, "*segment time"]  # rad/s
    angle_weight: Float[Any, "*segment time"]  # 1/rad: 1/noise, 0 where nothing was measured
    velocity_weight: Float[Any, "*segment time"]  # s/rad
    guide_angle: Float[Any, "*segment time"]  # rad, smoothed: what a start is tied to
    guide_velocity: Float[Any, "*segment time"]  # rad/s
    cycle: Drive  # Eq. 10 for unit amplitude at the stage times, 0 where not voluntary
    torque: Drive  # N m, the measured torque at the stage times, 0 where none was
    added_mass: Float[Any, "*segment"]  # kg
    added_mass_distance: Float[Any, "*segment"]  # m
    thigh_angle: Float[Any, "*segment"]  # rad, the knee above the hip
    seat: Seat


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


def movement(recording: Recording, number: int, name: str, belongs: int = 0) -> Movement:
    """Condition one segment: choose its channels, clip its ends, find its clock and its noise.

    `belongs` counts the recordings that are fitted together.

    **Raises** `ValueError` where nothing moves, or a torque is missing.
    """
    segment, said = recording.segments[number], recording.kind(number)
    kind = said or classify(segment) or "passive"
    if kind == "measured" and segment.applied_torque is None:
        raise ValueError(f"segment {name} is said to be measured, but has no torque_nm column.")
    part, onset, period = extent(segment, kind, recording.cycle_period(number), name)
    clipped = cut(segment, part)
    raw = clipped.raw_angle is not None
    angle = clipped.raw_angle if raw else clipped.angle
    velocity = clipped.raw_angular_velocity if raw else clipped.angular_velocity
    mass, distance = recording.added_mass(number), recording.added_mass_distance(number)
    assert angle is not None  # a Segment has one or the other
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
        thigh_angle=recording.protocol.thigh_angle or 0.0,
        recording=belongs,
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


def find_onset(segment: Segment) -> float:
    """When the movement begins [s]: after the rest in front of it, or with the segment."""
    found = movements(segment)
    begin = float(segment.time[0])
    first = float(segment.time[found[0].start]) if found else begin
    return first if first > begin + SETTLING else begin


def angle_noise(sensors: Sensors, angle: Samples) -> float:
    """Standard deviation [rad] of an angle sample: declared, else from the data; and its steps."""
    step = 0.0 if sensors.encoder_counts is None else 2 * np.pi / sensors.encoder_counts
    white = scatter(angle) if sensors.angle_noise is None else sensors.angle_noise
    return float(np.hypot(white, step / np.sqrt(12)))


def velocity_noise(sensors: Sensors, velocity: Samples | None) -> float:
    """Standard deviation [rad/s] of a gyro sample: declared, else from the data."""
    if velocity is None:
        return np.inf
    return scatter(velocity) if sensors.velocity_noise is None else sensors.velocity_noise


def scatter(samples: Samples) -> float:
    """White noise of a smooth signal, from its third differences (whose variance is 20 times)."""
    third = np.diff(samples[~np.isnan(samples)], 3)
    spread = float(np.median(np.abs(third)) / 0.6745 / np.sqrt(20))
    return spread if spread > 0 else float(np.std(third) / np.sqrt(20)) or 1e-6


def observe(movements: list[Movement], reading: str) -> Observation:
    """All movements in one shape; `reading` of Eq. 4 gives the torque its frequency."""
    grids = [with_gaps_bridged(each.segment.time) for each in movements]
    size = bucket(max(grid.size for grid in grids))
    rows = [
        one_observation(each, grid, size, reading, seat)
        for each, grid, seat in zip(movements, grids, seats(movements), strict=True)
    ]
    return jax.tree.map(lambda *each: np.stack(each), *rows)


def bucket(size: int) -> int:
    """The shape that serves this many samples, so that few lengths need compiling."""
    coarse = 64 if size <= 512 else 256 if size <= 4096 else 2048
    return -(-size // coarse) * coarse


def with_gaps_bridged(time: Samples) -> Samples:
    """The sample times, and more between them where they are farther apart than a safe step."""
    pieces = np.maximum(np.ceil(np.diff(time) / LONGEST_STEP - 1e-6), 1).astype(int)
    parts = [
        np.linspace(start, stop, count, endpoint=False)
        for start, stop, count in zip(time[:-1], time[1:], pieces, strict=True)
        if count > 1
    ]
    if not parts:
        return time
    return np.union1d(time, np.concatenate(parts))


def places(movements: list[Movement]) -> list[int]:
    """The recordings in which an added mass sat at an unknown distance."""
    return sorted({each.recording for each in movements if each.unplaced})


def remounts(movements: list[Movement]) -> list[int]:
    """The recordings but the first, whose sensors are compared with those of the first."""
    return sorted({each.recording for each in movements})[1:]


def seats(movements: list[Movement]) -> list[Seat]:
    """Which entries of the mounting every segment has."""
    distances, others = places(movements), remounts(movements)

    def entry(known: list[int], each: Movement, has: bool):
        return np.asarray(known.index(each.recording) if has else -1)

    return [
        Seat(entry(distances, each, each.unplaced), entry(others, each, each.recording in others))
        for each in movements
    ]


def one_observation(
    each: Movement, grid: Samples, size: int, reading: str, seat: Seat
) -> Observation:
    own = each.segment.time
    at = np.searchsorted(grid, own)
    step = np.median(np.diff(grid))
    time = np.concatenate([grid, grid[-1] + step * np.arange(1, size - grid.size + 1)])

    def placed(samples: Samples | None, noise: float) -> tuple[Samples, Samples]:
        value, weight = np.zeros(size), np.zeros(size)
        if samples is not None:
            known = ~np.isnan(samples)
            value[at[known]], weight[at[known]] = samples[known], 1 / noise
        return value, weight

    angle, angle_weight = placed(each.angle, each.angle_noise)
    velocity, velocity_weight = placed(each.angular_velocity, each.velocity_noise)
    guide, _ = smoothed_motion(each, GUIDE_WIDTH)
    slope = local_line(own, guide, GUIDE_WIDTH)[1]  # of the angle itself, whatever the gyro says
    return Observation(
        time=time,
        angle=angle,
        angular_velocity=velocity,
        angle_weight=angle_weight,
        velocity_weight=velocity_weight,
        guide_angle=np.interp(time, own, guide),
        guide_velocity=np.interp(time, own, slope),
        cycle=staged(time, lambda at: cycle_torque(at - each.onset, each, reading)),
        torque=staged(time, lambda at: measured_torque(at, each)),
        added_mass=np.asarray(each.added_mass),
        added_mass_distance=np.nan_to_num(np.asarray(each.added_mass_distance)),
        thigh_angle=np.asarray(each.thigh_angle),
        seat=seat,
    )


def smoothed_motion(each: Movement, width: float) -> tuple[Samples, Samples]:
    """Angle and angular velocity as the leg had them, before any chain, smoothed over `width` s."""
    part = each.segment
    angle = part.angle if part.raw_angle is None else part.raw_angle
    gyro = part.angular_velocity if part.raw_angle is None else part.raw_angular_velocity
    assert angle is not None  # a Segment has one or the other
    smooth, slope = local_line(part.time, angle, width)
    return smooth, slope if gyro is None else local_line(part.time, gyro, width)[0]


def staged(time: Samples, torque) -> Drive:
    """A torque at the begin, middle and end of every step."""
    return Drive(torque(time[:-1]), torque((time[:-1] + time[1:]) / 2), torque(time[1:]))


def cycle_torque(time: Samples, each: Movement, reading: str) -> Samples:
    """Eq. 10 for unit amplitude at `time` since the onset, 0 where nothing is voluntary."""
    if not each.voluntary:
        return np.zeros_like(time)
    frequency = torque_frequencies(each.period)[reading]
    return cycle_shape(time, each.period, frequency, xp=np)


def measured_torque(time: Samples, each: Movement) -> Samples:
    """The torque that was measured [N m], linear between its samples."""
    torque = each.segment.applied_torque
    if each.kind != "measured" or torque is None:
        return np.zeros_like(time)
    return np.interp(time, each.segment.time, interpolated(each.segment.time, torque))
