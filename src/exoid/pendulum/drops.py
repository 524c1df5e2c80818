"""The pendulum test: every passive drop of one leg with its measures, and their averages."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from exoid.pendulum import summary
from exoid.pendulum.catalogue import MEASURES, measures
from exoid.recordings.landmarks.landmarks import find_landmarks
from exoid.recordings.landmarks.measure import Measure, NotAllowed
from exoid.recordings.landmarks.swing import Curve
from exoid.recordings.landmarks.track import track_of
from exoid.recordings.loading.named import Given, named_recordings
from exoid.recordings.motion.drops import law_for
from exoid.recordings.recording import Recording, Segment
from exoid.recordings.signal.clean import clean
from exoid.recordings.signal.condition import classify

REFUSED = {
    "active": "a voluntary movement: only a relaxed leg that was let go is read",
    "measured": "driven by a torque: only a leg that was let go is read",
    None: (
        "no drop: it does not end lower than it begins (extension is positive, hanging is -90 deg)"
    ),
}


@dataclass(frozen=True, eq=False)
class Drop:
    """A segment with what could be read off it; without measures where it is refused whole."""

    name: str  # of the recording, where there are several, and the segment's number in it
    segment: Segment
    added_mass: float  # kg
    measures: dict[str, Measure]
    curve: Curve | None  # None where it is refused whole
    reason: str | None = None


@dataclass(frozen=True)
class Average:
    """The mean over drops, and their scatter."""

    name: str
    title: str
    symbol: str
    unit: str
    mean: float
    standard_deviation: float | None  # None of a single drop
    drops: tuple[str, ...]  # that it was read off


@dataclass(frozen=True, eq=False, repr=False)
class PendulumTest:
    """The drops of one leg. `average` is over those with the least added mass."""

    drops: list[Drop]
    average: dict[str, Average]
    left_out: list[str]  # drops with another added mass

    def __repr__(self) -> str:
        return summary.lines(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    def to_dataframe(self) -> Any:
        """Every measure of every drop for pandas: a row each, with error, unit and reason."""
        return summary.frame(self)


def measure_drops(recordings: Given) -> PendulumTest:
    """Read the pendulum-test measures off every passive segment, and average them.

    `recordings` are of one leg, given as to `fit`. The definitions are in
    `exoid.pendulum.definitions`. What a recording does not allow has no value, and a
    reason. Nothing here is a diagnosis.
    """
    named = named_recordings(recordings, alone="")
    drops = [
        drop(recording, number, f"{name} {number}" if len(named) > 1 else str(number))
        for name, recording in named
        for number in range(len(recording.segments))
    ]
    seen = [each for each in drops if each.reason is None]
    least = min((each.added_mass for each in seen), default=0.0)
    alike = [each for each in seen if each.added_mass == least]
    left_out = [each.name for each in seen if each.added_mass != least]
    return PendulumTest(drops, averages(alike), left_out)


def drop(recording: Recording, number: int, name: str) -> Drop:
    """One segment, read as far as it allows."""
    cleaned = clean(recording)
    segment, mass = cleaned.recording.segments[number], recording.added_mass(number)
    kind = recording.kind(number) or classify(segment)
    try:
        if kind != "passive":
            raise NotAllowed(REFUSED[kind])
        track = track_of(segment, cleaned.angle.level)
        law = law_for(cleaned.recording, number)
        found = find_landmarks(track, recording.subject.kind != "rig", law)
    except NotAllowed as why:
        return Drop(name, segment, mass, {}, None, str(why))
    return Drop(name, segment, mass, measures(found), found.curve)


def averages(drops: list[Drop]) -> dict[str, Average]:
    """Of every measure that at least one drop allows."""
    found = {}
    for name, declared in MEASURES.items():
        read = [each for each in drops if each.measures[name].value is not None]
        if read:
            values = np.array([each.measures[name].value for each in read], dtype=float)
            found[name] = Average(
                name,
                declared.title,
                declared.symbol,
                declared.unit,
                float(values.mean()),
                float(values.std(ddof=1)) if values.size > 1 else None,
                tuple(each.name for each in read),
            )
    return found
