"""A recording with what a step found of it."""

from dataclasses import dataclass, field
from typing import Any

from exoid.recordings.rate import rate_of
from exoid.recordings.recording import Recording
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.quantities import Row


@dataclass
class Measured:
    """A recording with what a step found; `fault` says why the step failed."""

    item: Item
    recording: Recording | None = None
    rows: list[Row] = field(default_factory=list)
    fault: str | None = None


def facts(one: Measured) -> dict[str, Any]:
    """What is known of a recording beside its quantities."""
    if one.recording is None:
        return {}
    subject, segments = one.recording.subject, one.recording.segments
    return {
        "segments": len(segments),
        "samples": sum(each.time.size for each in segments),
        "duration_s": float(sum(each.time[-1] - each.time[0] for each in segments)),
        "rate_hz": rate_of(segments),
        "device": one.recording.sensors.device or "",
        "body_mass_kg": subject.body_mass,
        "height_m": subject.height,
        "age_years": subject.age,
    }
