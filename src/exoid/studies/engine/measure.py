"""What a worker does with a batch of recordings."""

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

from exoid.files.visible import visible
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.program_cache import with_sound_programs
from exoid.physics.anatomy.body.doubt import doubts
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import classify
from exoid.studies.batch.fit_many import fit_many
from exoid.studies.dataset.cause import for_all
from exoid.studies.dataset.entry import Dataset
from exoid.studies.dataset.recording_of import recording_of
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.measured import Measured
from exoid.studies.engine.kept.quantities import WHOLE, Row, of_diagnosis, of_drops, of_fit
from exoid.studies.engine.outcome import UNLIKE
from exoid.studies.engine.plan import Batch
from exoid.studies.engine.reason import reason_of
from exoid.studies.engine.settings import Settings

DROPPED = ("passive", None)  # kinds of segments that may be drops


def measure(batch: Batch, dataset: Dataset, step: str, settings: Settings) -> list[Measured]:
    """A step of every recording; one that fails is told among the others."""
    each = [read(item, dataset) for item in batch.items]
    there = [one for one in each if one.recording is not None]
    if step == "fit":
        fitted(there, dict(settings.fit))
        return each
    for one in there:
        take(one, lambda one=one: of_step(step, one.recording, settings))
        if step == "drops" and one.fault is None and (why := why_no_drop(one)):
            one.fault = for_all(why, one.item.entry.name)
    return each


def why_no_drop(one: Measured) -> str:
    """Why nothing was read off any segment: the reason that most of them have. Empty where
    something was, and where none of them is a drop, as declared or by its shape.
    """
    recording = one.recording
    if recording is None or any(row.value is not None for row in one.rows):
        return ""
    segments = enumerate(recording.segments)
    if not any((recording.kind(n) or classify(each)) in DROPPED for n, each in segments):
        return ""
    said = Counter(row.note for row in one.rows if row.note)
    return said.most_common(1)[0][0] if said else "no drop is in it."


def read(item: Item, dataset: Dataset) -> Measured:
    try:
        return Measured(item, recording_of(item.entry, dataset))
    except Exception as fault:
        said = reason_of(fault).removeprefix(f"{visible(str(item.entry.path))}: ")
        return Measured(item, fault=for_all(said, item.entry.name))


def take(one: Measured, work: Callable[[], Iterable[Row]]) -> None:
    """Add the rows of a step, or why it has none."""
    try:
        one.rows += work()
    except Exception as fault:
        one.fault = for_all(reason_of(fault), one.item.entry.name)


def of_step(step: str, recording: Any, settings: Settings) -> Iterable[Row]:
    """The rows of a step that each recording goes through by itself."""
    if step == "drops":
        from exoid.pendulum.drops import measure_drops

        return list(of_drops(measure_drops(recording)))
    from exoid.mismatch.missing_physics import diagnose

    options = dict(settings.diagnose)
    known = believed(recording)
    return list(of_diagnosis(with_sound_programs(lambda: diagnose(known, **options))))


def fitted(each: list[Measured], options: dict[str, Any]) -> None:
    """The rows of all fits."""
    recordings = [believed(one.recording) for one in each if one.recording is not None]
    results = with_sound_programs(lambda: fit_many(recordings, **options))
    for one, result in zip(each, results, strict=True):
        take(one, lambda result=result: of_fit(sound(result)))
        if one.recording is not None and (why := disbelieved(one.recording)):
            one.rows.append(Row(WHOLE, "fit", "note", note=why))
        if isinstance(result, FitResult) and not result.follows:
            one.fault = f"{UNLIKE}: {result.astray}"


def believed(recording: Recording) -> Recording:
    """Without the sizes of a body that nobody has: what they are not needed for is told then."""
    if not disbelieved(recording):
        return recording
    return replace(recording, subject=replace(recording.subject, body_mass=None, height=None))


def disbelieved(recording: Recording) -> str:
    """Why its body is taken for unknown; nothing where it is somebody's."""
    subject = recording.subject
    found = doubts(subject.body_mass, subject.height, subject.age)
    said = [says for says, impossible in found if impossible]
    return f"the person {said[0]} Both are taken for unknown: ratios alone count." if said else ""


def sound(result: FitResult | Exception) -> FitResult:
    if isinstance(result, Exception):
        raise result
    return result
