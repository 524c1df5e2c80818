"""What was sampled from one release, or one cycle, to its end."""

# ruff: noqa: RUF009 (the calls below make dataclass fields)
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from exoid.files.counted import counted
from exoid.recordings.declared.entry import extra, known
from exoid.recordings.measured.bad_sample import bad_sample
from exoid.recordings.measured.samples import Samples, goes_round

ROUND = 'Does a rig without a spring go round and round? Then say kind = "rig", spring = "none".'
KNEE_ANGLE_LIMIT = 3.6  # rad; a knee spans about -2.7 (heel at the thigh) to +0.3


def channel(column: str, unit: str, upper: float):
    """A measured channel: its CSV column, its unit, and the size beyond which no knee can go."""
    return field(default=None, metadata={"column": column, "unit": unit, "upper": upper})


@dataclass(frozen=True, eq=False)
class Segment:
    """One release, or one movement cycle with its rest before it. NaN marks a missing sample.

    >>> segment = exoid.Segment(np.arange(3) * 0.01, raw_angle=np.radians([-20.0, -20.1, -20.3]))
    >>> list(segment.channels())
    ['time', 'raw_angle']
    """

    time: Samples = field(metadata={"column": "time_s", "unit": "s", "upper": 1e19})
    angle: Samples | None = channel("angle_rad", "rad", 14.0)
    angular_velocity: Samples | None = channel("velocity_rad_s", "rad/s", 100.0)
    angular_acceleration: Samples | None = channel("acceleration_rad_s2", "rad/s^2", 1e5)
    raw_angle: Samples | None = channel("raw_angle_rad", "rad", 14.0)
    raw_angular_velocity: Samples | None = channel("raw_velocity_rad_s", "rad/s", 100.0)
    raw_acceleration_x: Samples | None = channel("raw_acceleration_x_m_s2", "m/s^2", 1000.0)
    raw_acceleration_z: Samples | None = channel("raw_acceleration_z_m_s2", "m/s^2", 1000.0)
    applied_torque: Samples | None = channel("torque_nm", "N m", 1000.0)
    extra_columns: Mapping[str, tuple[str, ...]] = extra()
    begins: float = 0.0  # s, where its time 0 lies on the clock of what it was cut from

    def channels(self) -> dict[str, Samples]:
        """The channels that were measured, by field name, `time` first."""
        found = {f.name: getattr(self, f.name) for f in known(self)}
        return {name: samples for name, samples in found.items() if samples is not None}

    @property
    def best_angle(self) -> Samples:
        """The encoder's angle, or the filtered one where there is no other [rad]."""
        angle = self.angle if self.raw_angle is None else self.raw_angle
        assert angle is not None  # a Recording's segment has one or the other
        return angle

    @property
    def driven(self) -> bool:
        """Was the torque measured that moves it, which may be quicker than what a leg does?"""
        return self.applied_torque is not None

    @property
    def duration(self) -> float:
        """From the first sample to the last [s]."""
        return float(self.time[-1] - self.time[0])

    def __repr__(self) -> str:
        names = " + ".join([*self.channels()][1:])
        return f"<Segment: {self.duration:.2f} s, {self.time.size} samples, {names}>"


def check_segment(number: int, segment: Segment, springless: bool) -> None:
    where = f"segment {number}"
    time = segment.time
    if time.size < 2:
        raise ValueError(
            f"{where} has {counted(time.size, 'sample')}; at least 2 are needed. Drop it."
        )
    if segment.angle is None and segment.raw_angle is None:
        raise ValueError(f"{where} has no angle: give `angle_rad` or `raw_angle_rad`.")
    if np.isnan(time).any():
        at = int(np.flatnonzero(np.isnan(time))[0])
        raise bad_sample(number, at, f"time_s is missing in {where}, sample {at}. Drop that row.")
    for entry in known(segment):
        check_channel(number, entry, getattr(segment, entry.name), time, springless)
    for name, cells in segment.extra_columns.items():
        if len(cells) != time.size:
            raise ValueError(f"{name} in {where} has {len(cells)} cells, but time_s {time.size}.")
    steps = np.diff(time)
    if (steps <= 0).any():
        at = int(np.flatnonzero(steps <= 0)[0])
        raise bad_sample(
            number,
            at + 1,
            f"time_s must increase, but in {where} sample {at + 1} ({time[at + 1]:.6f} s) does not "
            f"come after sample {at} ({time[at]:.6f} s). {why_not_later(time, at)}",
        )


def why_not_later(time: Samples, at: int) -> str:
    """What makes the time after this sample not come after it, and what to do."""
    if time[at + 1] <= time[: at + 1].min():
        return (
            "Does a new recording begin there, as after a pause? Then give each a file of its own "
            "and analyse the files together; or, where each is one drop or cycle, number them in a "
            "column segment: 0, 1, ... Else: did the clock wrap, were rows repeated?"
        )
    if time[at + 1] < time[at]:
        return "Did the clock wrap, were rows repeated?"
    return (
        "Were rows repeated? Then drop them. Were times rounded? Then write them with more digits, "
        "or leave the column out and give sample_rate_hz in [sensors]."
    )


def check_channel(
    number: int, entry, samples: Samples | None, time: Samples, springless: bool
) -> None:
    """Refuses samples that cannot be true; without a spring an angle may go round and round."""
    if samples is None:
        return
    where = f"segment {number}"
    name, upper, unit = (entry.metadata[key] for key in ("column", "upper", "unit"))
    if samples.shape != time.shape:
        raise ValueError(
            f"{name} in {where} has shape {samples.shape}, but time_s has {time.size}."
        )
    if np.isnan(samples).all():
        raise ValueError(f"{name} in {where} holds no number. Leave the column out.")
    bad = np.abs(samples) > upper  # NaN compares false: a missing sample passes
    angle = name in ("angle_rad", "raw_angle_rad")
    if bad.any() and not (angle and springless and goes_round(time, samples)):
        at = int(np.flatnonzero(bad)[0])
        degrees = name.replace("_rad", "_deg")
        hint = f" Is it in degrees? {called(degrees)}" if degrees != name else ""
        hint += f" {ROUND}" if angle and not springless else ""
        raise bad_sample(
            number,
            at,
            f"{name} in {where}, sample {at} is {samples[at]:g} {unit}, beyond +-{upper:g}.{hint}",
        )


def called(column: str) -> str:
    """What to do where a column's unit is another than its name says."""
    return f'Then name the column {column}, or say columns={{"{column}": NAME}}.'


def check_knee(number: int, segment: Segment) -> None:
    for name, angle in (("angle_rad", segment.angle), ("raw_angle_rad", segment.raw_angle)):
        if angle is None or np.nanmax(np.abs(angle)) <= KNEE_ANGLE_LIMIT:
            continue
        if np.nanmax(angle) - np.nanmin(angle) > KNEE_ANGLE_LIMIT:  # else its zero is elsewhere
            at = int(np.nanargmax(np.abs(angle)))
            raise bad_sample(
                number,
                at,
                f"{name} in segment {number}, sample {at} is {angle[at]:g} rad = "
                f"{np.degrees(angle[at]):.0f} deg, which no knee reaches."
                f"{of_wrap(angle)} Is it in degrees? "
                f"{called(name.removesuffix('_rad') + '_deg')} Is this a rig? Then say so with "
                '[subject] kind = "rig".',
            )


def of_wrap(angle: Samples) -> str:
    """That an angle jumps by more than half a turn, and what to do; nothing where it does not."""
    jump = float(np.degrees(np.abs(np.diff(angle[~np.isnan(angle)])).max()))
    if jump <= 180:
        return ""
    return (
        f" It jumps by {jump:.0f} deg from one sample to the next. Does the encoder pass 0 or "
        "360 deg there? Then export it so that it goes on."
    )
