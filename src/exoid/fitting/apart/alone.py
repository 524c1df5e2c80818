"""One segment fitted by itself."""

from dataclasses import replace

import numpy as np

from exoid.fitting.amount.manageable import TOGETHER, Amount
from exoid.fitting.amount.part import Part
from exoid.fitting.estimate import fit
from exoid.fitting.result.fit_result import FitResult
from exoid.recordings.recording import Recording

SHORT = 1024  # samples of a segment among very many


def of_each(recordings: list[tuple[str, Recording]]) -> Amount:
    """What is read at once: every segment, of many only what moves."""
    count = sum(len(recording.segments) for _, recording in recordings)
    steps = max(TOGETHER.steps, SHORT * count)
    return Amount(count, steps, steps)


def alone(part: Part, options: dict) -> FitResult:
    """The fit of one segment; it and what it owned keep the name they have among the others."""
    try:
        result = fit([(part.name, only(part.recording, part.number))], **options)
    except ValueError as fault:
        raise ValueError(f"segment {part.name} alone: {fault}") from fault
    named = [replace(each, name=part.name + each.name[1:]) for each in result.segments]
    owned = [replace(each, recording=part.name) for each in result.mountings]
    return replace(result, segments=named, mountings=owned)


def only(recording: Recording, number: int) -> Recording:
    """One segment as a recording of its own."""

    def own(value):
        entry = value[number] if isinstance(value, tuple) else value
        return None if isinstance(entry, float) and np.isnan(entry) else entry

    subject, protocol = recording.subject, recording.protocol
    mass = own(subject.added_mass)
    return replace(
        recording,
        segments=(recording.segments[number],),
        subject=replace(
            subject,
            added_mass=mass,
            added_mass_distance=None if mass is None else own(subject.added_mass_distance),
        ),
        protocol=replace(
            protocol,
            kind=own(protocol.kind),
            cycle_period=own(protocol.cycle_period),
            thigh_angle=own(protocol.thigh_angle),
        ),
    )
