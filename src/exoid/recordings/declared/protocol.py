"""How the leg was moved, segment by segment."""

# ruff: noqa: RUF009 (the calls below make dataclass fields)
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from exoid.recordings.declared.entry import check_words, extra, flag, ranged, text

Kind = Literal["passive", "active", "measured"]

KINDS: tuple[Kind, ...] = ("passive", "active", "measured")
TORQUE_FREQUENCIES = ("1/T", "2/T")  # the two readings of Eq. 4


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
