"""The recording itself: what there is of it, and what was lost."""

from collections.abc import Iterator
from dataclasses import fields
from math import isnan

from markupsafe import escape

from exoid.fitting.result.segment_fit import SegmentFit
from exoid.recordings.declared.subject import Subject
from exoid.report.parts.appraisal import Appraisal, appraise
from exoid.report.parts.case import Case, Source
from exoid.report.sections.blocks import Block, element
from exoid.report.sections.section import section
from exoid.report.tables.table import Table
from exoid.report.words.text import in_degrees

HANDLED = ("kind", "added_mass", "added_mass_distance", "notes", "extra_keys")  # told elsewhere


@section("quality", "The recording")
def quality(case: Case) -> Iterator[Block]:
    """Segments with their samples, gaps, saturations and noise; what the readers noticed."""
    if case.sources:
        yield segments_of(appraisals(case), case.fit.segments)
    for source in case.sources:
        yield from noticed(source)


def appraisals(case: Case) -> list[Appraisal]:
    """Of every segment, in the order of the fit."""
    return [
        appraise(segment, source.recording.sensors)
        for source in case.sources
        for segment in source.recording.segments
    ]


def segments_of(each: list[Appraisal], fitted: list[SegmentFit]) -> Table:
    """One row per segment."""
    noise = [one.velocity_noise for one in fitted]
    columns = {
        "segment": [one.name for one in fitted],
        "kind": [one.kind for one in fitted],
        "duration [s]": [f"{one.duration:.2f}" for one in each],
        "samples": [f"{one.samples}" for one in each],
        "rate [Hz]": [f"{one.rate:.4g}" for one in each],
        "gaps": [gaps(one) for one in each],
        "missing": [f"{one.missing}" for one in each],
        "gyro at its limit": ["" if one.saturated is None else f"{one.saturated}" for one in each],
        "noise of the angle [deg]": [in_degrees(one.angle_noise) for one in fitted],
        "of the gyro [deg/s]": ["" if one is None else in_degrees(one) for one in noise],
    }
    return Table("The segments as they were recorded", columns)


def gaps(each: Appraisal) -> str:
    """How many, and how long the longest is."""
    return f"{each.gaps}, up to {each.longest:.2f} s" if each.gaps else "0"


def noticed(source: Source) -> Iterator[Block]:
    """What is known of one file."""
    subject = source.recording.subject
    notes = {"notes": subject.notes} if subject.notes else {}
    yield element("h3", source.name)
    yield {name: escape(said) for name, said in {**described(subject), **notes}.items()}
    yield source.notes
    if source.quality is not None:
        yield element("h4", "What the CAN log says of itself")
        yield source.quality.lines()


def described(subject: Subject) -> dict[str, str]:
    """What the sidecar or the command line says of the body."""
    numbers = [each for each in fields(subject) if each.name not in HANDLED]
    known = {each.name: getattr(subject, each.name) for each in numbers}
    units = {each.name: each.metadata.get("unit") for each in numbers}
    said = {
        name.replace("_", " "): f"{value:g} {units[name]}" if units[name] else value
        for name, value in known.items()
        if value is not None
    }
    if subject.added_mass is not None:
        said["added mass"] = f"{listed(subject.added_mass)} kg"
        if subject.added_mass_distance is not None:
            said["added mass"] += f" at {listed(subject.added_mass_distance)} m from the knee"
    return {"kind": subject.kind or "unknown", **said}


def listed(each: float | tuple[float, ...]) -> str:
    """One for all segments, or that of each; a distance may be unknown."""
    values = each if isinstance(each, tuple) else (each,)
    return ", ".join("?" if isnan(one) else f"{one:g}" for one in values)
