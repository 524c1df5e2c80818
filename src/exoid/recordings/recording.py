"""What was measured: a Recording of one leg (or rig), in SI units, on one clock, checked here.

Plain frozen dataclasses over NumPy arrays: reading a file must not load JAX.
"""

# ruff: noqa: RUF009 (the calls below make dataclass fields)
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any, Literal

import numpy as np

from exoid.files.counted import counted
from exoid.recordings import summary
from exoid.recordings.samples import Samples, goes_round
from exoid.recordings.unit_hint import unit_hint

Kind = Literal["passive", "active", "measured"]

KINDS: tuple[Kind, ...] = ("passive", "active", "measured")
TORQUE_FREQUENCIES = ("1/T", "2/T")  # the two readings of Eq. 4
SIDES = ("left", "right")
ABSENT = ("none",)  # what a rig can be said to have of gravity or of a spring
FLIPS = ("angle", "gyro", "all")  # channels whose sign is the other one
ZEROS = ("extended", "hanging", "unknown")  # what the encoder calls 0
FILTERS = ("3 states", "4 states")  # of the node: of the motion; and of the gyro's bias
ROUND = 'Does a rig without a spring go round and round? Then say kind = "rig", spring = "none".'
KNEE_ANGLE_LIMIT = 3.6  # rad; a knee spans about -2.7 (heel at the thigh) to +0.3


def ranged(key: str, unit: str, lower: float, upper: float, default=None):
    """A number of the sidecar: its TOML key, its unit, and the range in which it can be true."""
    return field(
        default=default, metadata={"key": key, "unit": unit, "lower": lower, "upper": upper}
    )


def text(key: str, choices: tuple[str, ...] | None = None):
    """A word of the sidecar: its TOML key and, where only some words make sense, which."""
    return field(default=None, metadata={"key": key, "choices": choices})


def flag(key: str):
    """A true or false of the sidecar, and its TOML key."""
    return field(default=None, metadata={"key": key, "flag": True})


def extra():
    """What a file holds that this format does not know: kept, by name, as it was read."""
    return field(default_factory=dict, hash=False)


def known(table):
    """The fields that the format names: all but what is kept as extra."""
    return [entry for entry in fields(table) if entry.metadata]


def check_words(table) -> None:
    """Refuses a word that is none of those that a field can be."""
    for entry in known(table):
        value = getattr(table, entry.name)
        for each in value if isinstance(value, tuple) else (value,):
            check_word(entry.metadata, each)


def check_word(meta, value) -> None:
    choices = meta.get("choices")
    if choices and value is not None and value not in choices:
        raise ValueError(f"{meta['key']} is {value!r}; it can be {' or '.join(choices)}.")


@dataclass(frozen=True)
class Subject:
    """Whose leg, or which rig. None means unknown, never a default.

    **Raises** `ValueError` for a word that a field cannot be, as do `Protocol` and `Sensors`.

    >>> exoid.Subject(kind="leg", body_mass=77.0, height=1.8).age is None  # unknown
    True
    """

    kind: Literal["leg", "rig"] | None = text("kind", ("leg", "rig"))
    id: str | None = text("id")
    side: str | None = text("side", SIDES)
    session: str | None = text("session")
    body_mass: float | None = ranged("body_mass_kg", "kg", 2.0, 400.0)
    height: float | None = ranged("height_m", "m", 0.4, 2.6)
    age: float | None = ranged("age_years", "years", 0.0, 130.0)
    shank_length: float | None = ranged("shank_length_m", "m", 0.05, 0.8)
    shank_foot_mass: float | None = ranged("shank_foot_mass_kg", "kg", 0.05, 40.0)
    com_distance: float | None = ranged("com_distance_m", "m", 0.01, 0.8)
    added_mass: float | tuple[float, ...] | None = ranged("added_mass_kg", "kg", 0.0, 50.0)
    added_mass_distance: float | tuple[float, ...] | None = ranged(
        "added_mass_distance_m", "m", 0.0, 1.0
    )
    added_mass_uncertainty: float | None = ranged("added_mass_uncertainty_kg", "kg", 0.0, 10.0)
    added_mass_distance_uncertainty: float | None = ranged(
        "added_mass_distance_uncertainty_m", "m", 0.0, 0.5
    )
    added_mass_gyration: float | None = ranged("added_mass_gyration_m", "m", 0.0, 0.5)
    gravity: str | None = text("gravity", ABSENT)
    spring: str | None = text("spring", ABSENT)
    notes: str | None = text("notes")
    extra_keys: Mapping[str, Any] = extra()

    def __post_init__(self):
        check_words(self)


@dataclass(frozen=True)
class Protocol:
    """How the leg was moved. A tuple holds one value per segment.

    >>> exoid.Protocol(kind=("passive", "active"), cycle_period=(float("nan"), 1.8)).kind
    ('passive', 'active')
    """

    kind: Kind | tuple[Kind, ...] | None = text("kind", KINDS)
    cycle_period: float | tuple[float, ...] | None = ranged("cycle_period_s", "s", 0.05, 120.0)
    torque_frequency: str | None = text("torque_frequency", TORQUE_FREQUENCIES)
    thigh_angle: float | tuple[float, ...] | None = ranged("thigh_angle_rad", "rad", -1.2, 1.2)
    thigh_angle_uncertainty: float | None = ranged("thigh_angle_uncertainty_rad", "rad", 0.0, 1.2)
    segment_start: tuple[float, ...] | None = ranged("segment_start_s", "s", 0.0, 1e6)
    segment_end: tuple[float, ...] | None = ranged("segment_end_s", "s", 0.0, 1e6)
    torque_known: bool | None = flag("torque_known")
    time_origin: float | None = ranged("time_origin_s", "s", 0.0, 1e19)
    extra_keys: Mapping[str, Any] = extra()

    def __post_init__(self):
        check_words(self)

    @property
    def measured(self) -> bool:
        """Is a torque said to be measured, of any segment?"""
        return "measured" in (self.kind if isinstance(self.kind, tuple) else (self.kind,))


@dataclass(frozen=True)
class Sensors:
    """What is known of the sensors. An uncertainty is one standard deviation, None where not told.

    `flip`, `zero` and `angle_zero` say how a file differs from exoid's convention; `load` mends its
    samples accordingly and clears them (`recordings/conventions/mounting.py`).

    >>> exoid.Sensors(encoder_counts=4096.0).angle_noise is None  # not told
    True
    """

    encoder_counts: float | None = ranged("encoder_counts", "counts per turn", 16.0, 2.0**26)
    angle_noise: float | None = ranged("angle_noise_rad", "rad", 1e-9, 1.0)
    velocity_noise: float | None = ranged("velocity_noise_rad_s", "rad/s", 1e-9, 10.0)
    gyro_range: float | None = ranged("gyro_range_dps", "deg/s", 10.0, 20000.0)
    sample_rate: float | None = ranged("sample_rate_hz", "Hz", 1.0, 20000.0)
    flip: str | None = text("flip", FLIPS)
    zero: str | None = text("zero", ZEROS)
    angle_zero: float | None = ranged("angle_zero_rad", "rad", -7.0, 7.0)
    angle_zero_uncertainty: float | None = ranged("angle_zero_uncertainty_rad", "rad", 0.0, 3.2)
    gyro_scale_uncertainty: float | None = ranged("gyro_scale_uncertainty", "of 1", 0.0, 0.5)
    clock_uncertainty: float | None = ranged("clock_uncertainty", "of 1", 0.0, 0.5)
    torque_zero_uncertainty: float | None = ranged("torque_zero_uncertainty_nm", "N m", 0.0, 1e3)
    torque_gain_uncertainty: float | None = ranged("torque_gain_uncertainty", "of 1", 0.0, 0.5)
    device: str | None = text("device")
    filter: str | None = text("filter", FILTERS)
    filter_step: float | None = ranged("filter_step_s", "s", 1e-5, 1.0)
    extra_keys: Mapping[str, Any] = extra()

    def __post_init__(self):
        check_words(self)


class BadSample(ValueError):
    """A sample that cannot be true, and which it is: a reader adds the line of its file."""

    segment: int
    sample: int


def bad_sample(segment: int, sample: int, message: str) -> BadSample:
    error = BadSample(message)
    error.segment, error.sample = segment, sample
    return error


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

    def __repr__(self) -> str:
        return summary.segment_line(self)


@dataclass(frozen=True, eq=False)
class Recording:
    """One trial: its segments and what is known of subject, protocol and sensors.

    **Raises** `ValueError` (one line: what, which segment and sample, what to do) when times do
    not increase, lengths differ, no angle was measured, a value is infinite or beyond what a
    knee can do, or a per-segment entry of the metadata does not match the segments.

    >>> recording = exoid.load("drops.csv").recording
    >>> len(recording.segments), recording.subject.body_mass  # kg
    (2, 77.0)
    """

    segments: tuple[Segment, ...]
    subject: Subject = Subject()
    protocol: Protocol = Protocol()
    sensors: Sensors = Sensors()
    extra_tables: Mapping[str, Any] = extra()

    def __post_init__(self):
        if not self.segments:
            raise ValueError("A recording needs at least one segment, and this one has none.")
        for number, segment in enumerate(self.segments):
            check_segment(number, segment, "stiffness" in self.absent)
            if self.subject.kind != "rig":
                check_knee(number, segment)
        check_metadata(self)

    def __repr__(self) -> str:
        return summary.line(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    def to_dataframe(self) -> Any:
        """The table that `write_table` writes, for pandas: `time_s`, `segment`, the channels in SI.

        `exoid.recording(frame, subject=..., protocol=..., sensors=...)` makes a recording of it.
        """
        from exoid.recordings.flat_table import frame_of

        return frame_of(self)

    def kind(self, segment: int) -> Kind | None:
        """How this segment was moved: passive, active, measured, or None where unknown."""
        return per_segment(self.protocol.kind, segment)

    def cycle_period(self, segment: int) -> float | None:
        """The period of the voluntary cycle in this segment [s], None where unknown."""
        return per_segment(self.protocol.cycle_period, segment)

    @property
    def absent(self) -> tuple[str, ...]:
        """What of Eq. 9 this rig is said not to have: gravity, stiffness."""
        said = {"gravity": self.subject.gravity, "stiffness": self.subject.spring}
        return tuple(name for name, word in said.items() if word == "none")

    def added_mass(self, segment: int) -> float:
        """The mass fixed to the shank in this segment [kg]."""
        return per_segment(self.subject.added_mass, segment) or 0.0

    def thigh_angle(self, segment: int) -> float:
        """The knee above the hip [rad], on a seat that is not level."""
        return per_segment(self.protocol.thigh_angle, segment) or 0.0

    def added_mass_distance(self, segment: int) -> float | None:
        """The distance of that mass from the knee axis [m], None where unknown."""
        return per_segment(self.subject.added_mass_distance, segment)


def per_segment(value, segment: int):
    """An entry of the metadata that holds for all segments, or one for each (nan: not this one)."""
    one = value[segment] if isinstance(value, tuple) else value
    return None if one != one else one


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
        check_channel(number, entry, getattr(segment, entry.name), time.size, springless)
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


def check_channel(number: int, entry, samples: Samples | None, size: int, springless: bool) -> None:
    """Refuses samples that cannot be true; without a spring an angle may go round and round."""
    if samples is None:
        return
    where = f"segment {number}"
    name, upper, unit = (entry.metadata[key] for key in ("column", "upper", "unit"))
    if samples.shape != (size,):
        raise ValueError(f"{name} in {where} has shape {samples.shape}, but time_s has {size}.")
    if np.isnan(samples).all():
        raise ValueError(f"{name} in {where} holds no number. Leave the column out.")
    bad = np.abs(samples) > upper  # NaN compares false: a missing sample passes
    angle = name in ("angle_rad", "raw_angle_rad")
    if bad.any() and not (angle and springless and goes_round(samples)):
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


def check_metadata(recording: Recording) -> None:
    marks, segments = recording.protocol.segment_start, len(recording.segments)
    if marks and segments == 1:
        segments = len(marks)  # a log not split yet: its entries are one for each mark
    for table in (recording.subject, recording.protocol, recording.sensors):
        for entry in known(table):
            check_entry(entry.metadata, getattr(table, entry.name), segments)
    subject = recording.subject
    for key in ("gravity", "spring"):
        if getattr(subject, key) is not None and subject.kind != "rig":
            raise ValueError(
                f'{key} = "none" is of a rig: a leg has both. Say kind = "rig", or leave it out.'
            )
    if subject.added_mass_distance is not None and subject.added_mass is None:
        raise ValueError("added_mass_distance_m is given without added_mass_kg. Give both.")


def check_entry(meta, value, segments: int | None) -> None:
    """Refuses an entry that cannot be true; its count only where `segments` is known."""
    if value is None:
        return
    key = meta["key"]
    values = value if isinstance(value, tuple) else (value,)
    if isinstance(value, tuple) and segments is not None and len(value) != segments:
        raise ValueError(
            f"{key} lists {counted(len(value), 'value')} for {counted(segments, 'segment')}. "
            "Give one for each."
        )
    for each in values:
        check_word(meta, each)
        if isinstance(value, tuple) and each != each:
            continue  # nan in a list: this segment has none, as a passive one has no period
        if "lower" in meta and not meta["lower"] <= each <= meta["upper"]:
            raise ValueError(
                f"{key} is {each:g} {meta['unit']}; it must lie between "
                f"{meta['lower']:g} and {meta['upper']:g}."
                f"{unit_hint(key, meta['unit'], each, (meta['lower'], meta['upper']))}"
            )
