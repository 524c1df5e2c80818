"""What a worker does with a batch of recordings."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from exoid.files.visible import visible
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.program_cache import with_sound_programs
from exoid.recordings.recording import Recording
from exoid.studies.batch.fit_many import fit_many
from exoid.studies.dataset.entry import Dataset
from exoid.studies.dataset.recording_of import recording_of
from exoid.studies.engine.item import Item
from exoid.studies.engine.plan import Batch
from exoid.studies.engine.quantities import Row, of_diagnosis, of_drops, of_fit
from exoid.studies.engine.reason import reason_of
from exoid.studies.engine.settings import Settings


@dataclass
class Measured:
    """A recording with all that was found; `faults` say which steps failed, and why."""

    item: Item
    recording: Recording | None = None
    rows: list[Row] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)

    def take(self, step: str, work: Callable[[], Iterable[Row]]) -> None:
        """Add the rows of a step, or why it has none."""
        try:
            self.rows += work()
        except Exception as fault:
            self.faults.append(f"{step}: {reason_of(fault)}")


def measure(batch: Batch, dataset: Dataset, settings: Settings) -> list[Measured]:
    """All steps of every recording; one that fails is told among the others."""
    each = [read(item, dataset) for item in batch.items]
    there = [one for one in each if one.recording is not None]
    for step in settings.steps:
        if step == "fit":
            fitted(there, dict(settings.fit))
        for one in there if step != "fit" else ():
            one.take(step, lambda one=one, step=step: of_step(step, one.recording, settings))
    return each


def read(item: Item, dataset: Dataset) -> Measured:
    try:
        return Measured(item, recording_of(item.entry, dataset))
    except Exception as fault:
        said = reason_of(fault).removeprefix(f"{visible(str(item.entry.path))}: ")
        return Measured(item, faults=[said])


def of_step(step: str, recording: Any, settings: Settings) -> Iterable[Row]:
    """The rows of a step that each recording goes through by itself."""
    if step == "drops":
        from exoid.pendulum.drops import measure_drops

        return list(of_drops(measure_drops(recording)))
    from exoid.mismatch.missing_physics import diagnose

    options = dict(settings.diagnose)
    return list(of_diagnosis(with_sound_programs(lambda: diagnose(recording, **options))))


def fitted(each: list[Measured], options: dict[str, Any]) -> None:
    """The rows of all fits."""
    recordings = [one.recording for one in each if one.recording is not None]
    results = with_sound_programs(lambda: fit_many(recordings, **options))
    for one, result in zip(each, results, strict=True):
        one.take("fit", lambda result=result: of_fit(sound(result)))
        if isinstance(result, FitResult) and not result.follows:
            one.faults.append(f"fit: it does not follow the recording: {result.astray}")


def sound(result: FitResult | Exception) -> FitResult:
    if isinstance(result, Exception):
        raise result
    return result


def facts(one: Measured) -> dict[str, Any]:
    """What is known of a recording beside its quantities."""
    if one.recording is None:
        return {}
    subject, segments = one.recording.subject, one.recording.segments
    steps = np.concatenate([np.diff(each.time) for each in segments])
    device = one.recording.sensors.extra_keys.get("device", "")
    return {
        "segments": len(segments),
        "samples": sum(each.time.size for each in segments),
        "duration_s": float(sum(each.time[-1] - each.time[0] for each in segments)),
        "rate_hz": float(1 / np.median(steps)),
        "device": device if isinstance(device, str) else "",
        "body_mass_kg": subject.body_mass,
        "height_m": subject.height,
        "age_years": subject.age,
    }
