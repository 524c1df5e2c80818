"""The samples of a table as the segments of a recording; a bad one is named by its line as well."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.columns import CHANNELS, NUMERIC
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.bad_sample import BadSample
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.selection import entries
from exoid.recordings.tables.assemble import Named
from exoid.recordings.tables.mending.mend import mended, without_doubled
from exoid.recordings.tables.sheet import Cells, Place
from exoid.recordings.tables.sound_segments import Sound, sound

FROM_ONE = "segments count from 1 in this file, and from 0 in what is said of them."


def segment_starts(columns: Mapping[str, Cells], place: Place) -> np.ndarray:
    """The row at which each segment begins; without a column `segment` there is one."""
    if "segment" not in columns:
        return np.zeros(1, int)
    said = np.asarray(columns["segment"])
    number = said - from_one(columns)
    starts = np.concatenate([[0], np.flatnonzero(np.diff(number) != 0) + 1])
    wrong = np.flatnonzero(number[starts] != np.arange(starts.size))
    if wrong.size:
        at, after = int(starts[wrong[0]]), wrong[0] + from_one(columns)
        value = "empty" if np.isnan(number[at]) else f"{said[at]:g}"
        raise ValueError(
            f"{place(at)}, column segment: {value}, where {after}"
            f"{f' or {after - 1}' if wrong[0] else ''} is expected. Segments count 0, 1, 2, ... "
            "and the rows of each stand together: renumber or sort them."
        )
    return starts


def from_one(columns: Mapping[str, Cells]) -> bool:
    """Do its segments count from 1?"""
    return "segment" in columns and bool(np.asarray(columns["segment"])[0] == 1)


@dataclass(frozen=True, eq=False)
class Built:
    """The samples of a table as a recording, and which of its segments they are."""

    samples: Recording
    kept: Sound
    from_one: bool  # do segments of the table count from 1
    mending: Notes  # what was mended in its cells

    @property
    def notes(self) -> Notes:
        return (*self.mending, *((FROM_ONE,) if self.from_one else ()), *self.kept.notes)

    def described(self, told: Mapping[str, Any]) -> Recording:
        """With what is told of it; of lists with an entry for each segment, those of the kept."""
        tables = dict(told)
        for name in {"subject", "protocol"} & tables.keys():
            tables[name] = entries(tables[name], self.kept.numbers, self.kept.count)
        return replace(self.samples, **tables)


def judging(subject: Subject | None) -> Subject:
    """What of a subject says which samples can be true."""
    if subject is None or subject.kind != "rig":
        return Subject(kind=subject and subject.kind)
    return Subject(kind="rig", spring=subject.spring)


def build(named: Named, subject: Subject) -> Built:
    """The samples, checked by the recording's own rules; a bad one is named by its line as well."""
    rows, columns, doubled = without_doubled(named.columns)
    place = replace(named.place, rows=rows)
    starts = segment_starts(columns, place)
    columns, notes = mended(columns, starts)
    stops = [*starts[1:], len(columns["time_s"])]
    segments = [cut(columns, slice(*rows)) for rows in zip(starts, stops, strict=True)]
    kept = sound(segments)
    try:
        samples = Recording(tuple(segments[n] for n in kept.numbers), subject)
        return Built(samples, kept, from_one(columns), (*doubled, *notes))
    except BadSample as error:
        where = place(int(starts[kept.numbers[error.segment]]) + error.sample)
        words = [source for own, source in named.sources.items() if str(error).startswith(own)]
        hint = f" ({', '.join(words)}.)" if words else ""
        raise ValueError(f"{where}: {error}{hint}") from error


def cut(columns: Mapping[str, Cells], rows: slice) -> Segment:
    """One segment. A channel that is empty throughout it was not measured in it."""
    cells = {name: each[rows] for name, each in columns.items()}
    channels: dict[str, Any] = {
        field: np.array(cells[name])
        for name, field in CHANNELS.items()
        if name in cells and (name == "time_s" or not np.isnan(np.asarray(cells[name])).all())
    }
    extra = {name: tuple(each) for name, each in cells.items() if name not in NUMERIC}
    return Segment(**channels, extra_columns=extra)
