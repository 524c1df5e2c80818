"""What was measured: a Recording of one leg (or rig), in SI units, on one clock, checked here.

Plain frozen dataclasses over NumPy arrays: reading a file must not load JAX.
"""

# ruff: noqa: RUF009 (no default here can be changed)
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from exoid.recordings import summary
from exoid.recordings.declared.check_entries import check_entries
from exoid.recordings.declared.entry import extra
from exoid.recordings.declared.protocol import Kind, Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment, check_knee, check_segment


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
        check_declared(self.subject, self.protocol, self.sensors, len(self.segments))

    def __repr__(self) -> str:
        return summary.line(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    def to_dataframe(self) -> Any:
        """The table that `write_table` writes, for pandas: `time_s`, `segment`, the channels in SI.

        `exoid.recording(frame, subject=..., protocol=..., sensors=...)` makes a recording of it.
        """
        from exoid.recordings.flat_table import frame_of

        return frame_of(self.segments)

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


def check_declared(subject: Subject, protocol: Protocol, sensors: Sensors, segments: int) -> None:
    marks = protocol.segment_start
    if marks and segments == 1:
        segments = len(marks)  # a log not split yet: its entries are one for each mark
    for table in (subject, protocol, sensors):
        check_entries(table, segments)
    for key in ("gravity", "spring"):
        if getattr(subject, key) is not None and subject.kind != "rig":
            raise ValueError(
                f'{key} = "none" is of a rig: a leg has both. Say kind = "rig", or leave it out.'
            )
    if subject.added_mass_distance is not None and subject.added_mass is None:
        raise ValueError("added_mass_distance_m is given without added_mass_kg. Give both.")
