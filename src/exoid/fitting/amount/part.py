"""A segment among all that are fitted together."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from exoid.fitting.data.pace import LONGEST_STEP
from exoid.recordings.declared.protocol import Kind
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.selection import selection
from exoid.recordings.signal.condition import classify


@dataclass(frozen=True, eq=False)
class Part:
    """A segment of a recording, or a stretch of one, under its name among the others."""

    name: str
    recording: Recording
    number: int  # of the segment there
    belongs: int  # the number of the recording

    @property
    def segment(self) -> Segment:
        return self.recording.segments[self.number]

    @property
    def kind(self) -> Kind:
        """As said, or by its shape."""
        return self.recording.kind(self.number) or classify(self.segment) or "passive"

    @property
    def steps(self) -> int:
        """How many a simulation makes of it: gaps are bridged."""
        wanted = np.ceil(np.diff(self.segment.time) / LONGEST_STEP - 1e-6)
        return 1 + int(np.maximum(wanted, 1).sum())


def parts_of(named: Sequence[tuple[str, Recording]]) -> list[Part]:
    """Every segment of every recording."""
    several = len(named) > 1
    return [
        Part(f"{name} {number}" if several else str(number), recording, number, belongs)
        for belongs, (name, recording) in enumerate(named)
        for number in range(len(recording.segments))
    ]


def apart(parts: list[Part]) -> list[Part]:
    """The same without the segments beside them: what is asked of all of those is asked no more."""
    return together(parts, [[part.segment] for part in parts])


def together(parts: list[Part], segments: list[list[Segment]]) -> list[Part]:
    """The same with other segments in their place, those of each recording in one recording; where
    several are made of one, its name says when each begins.
    """
    found: list[Part] = []
    for belongs in dict.fromkeys(part.belongs for part in parts):
        own = [(p, s) for p, s in zip(parts, segments, strict=True) if p.belongs == belongs]
        numbers = [part.number for part, made in own for _ in made]
        flat = [one for _, made in own for one in made]
        recording = selection(own[0][0].recording, numbers, flat)
        names = [
            part.name if len(made) == 1 else f"{part.name}@{one.begins:.0f}s"
            for part, made in own
            for one in made
        ]
        found += [Part(name, recording, at, belongs) for at, name in enumerate(names)]
    return found


def with_sensors(parts: list[Part], change) -> list[Part]:
    """The same, what `change` gives for the sensors of each recording in their place."""
    made = {id(part.recording): part.recording for part in parts}
    made = {key: replace(one, sensors=change(one)) for key, one in made.items()}
    return [replace(part, recording=made[id(part.recording)]) for part in parts]
