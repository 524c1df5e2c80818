"""The pendulum test: every passive drop of one leg with its measures, and their averages."""

import numpy as np

from exoid.files.counted import counted
from exoid.pendulum.catalogue import MEASURES
from exoid.pendulum.drift import read_off
from exoid.pendulum.drop import Average, Drop, PendulumTest
from exoid.pendulum.halt import of_halt, of_rise, of_stop
from exoid.pendulum.off_body import with_doubted_times
from exoid.pendulum.off_clock import with_doubted_scales
from exoid.pendulum.push import of_lead, of_push
from exoid.pendulum.smoothing import as_smoothed, of_play
from exoid.recordings.conventions.jumps import AGAIN, jumps_of, told_jumps
from exoid.recordings.conventions.lowered import WHY, lowered
from exoid.recordings.landmarks.find_landmarks import find_landmarks
from exoid.recordings.landmarks.measure import Measure, NotAllowed
from exoid.recordings.landmarks.track import track_of
from exoid.recordings.loading.named import RecordingsLike, named_recordings
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import law_for
from exoid.recordings.motion.signal import signal_of
from exoid.recordings.recording import Recording
from exoid.recordings.selection import alike, selection
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.condition import classify, stays

REFUSED = {
    "active": "a voluntary movement: only a relaxed leg that was let go is read",
    "measured": "driven by a torque: only a leg that was let go is read",
    None: (
        "no drop: it does not end lower than it begins (extension is positive, hanging is -90 deg)"
    ),
}

LOWERED = f"no drop: it moves slower than the others fall, {WHY}, and does not swing"
OTHER = "not of the same channels as the other segments"


def measure_drops(recordings: RecordingsLike) -> PendulumTest:
    """Read the pendulum-test measures off every passive segment, and average them.

    `recordings` are of one leg, given as to `fit`. The definitions are in
    `exoid.pendulum.definitions`. What a recording does not allow has no value, and a
    reason. Nothing here is a diagnosis.

    >>> test = exoid.measure_drops("drops.csv")
    >>> len(test.drops)
    2
    """
    named = named_recordings(recordings, alone="")
    drops = [
        each
        for name, recording in named
        for each in drops_of(recording, f"{name} " if len(named) > 1 else "")
    ]
    seen = [each for each in drops if each.reason is None]
    least = min((each.added_mass for each in seen), default=0.0)
    alike = [each for each in seen if each.added_mass == least]
    left_out = [each.name for each in seen if each.added_mass != least]
    return PendulumTest(drops, averages(alike), left_out)


def drops_of(recording: Recording, before: str) -> list[Drop]:
    """Every segment of one recording, `before` its number in its name."""
    numbers = alike(recording)
    same = recording
    if len(numbers) < len(recording.segments):
        same = selection(recording, numbers)
    refused = dict.fromkeys(lowered(recording), LOWERED)
    refused |= {n: OTHER for n in range(len(recording.segments)) if n not in numbers}
    return [
        Drop(f"{before}{number}", segment, recording.added_mass(number), {}, None, refused[number])
        if number in refused
        else drop(same, numbers.index(number), f"{before}{number}")
        for number, segment in enumerate(recording.segments)
    ]


def drop(recording: Recording, number: int, name: str) -> Drop:
    """One segment, read as far as it allows."""
    cleaned = clean(recording)
    segment, mass = cleaned.recording.segments[number], recording.added_mass(number)
    kind = recording.kind(number) or classify(segment)
    try:
        if kind in ("active", "measured"):
            raise NotAllowed(REFUSED[kind])
        track = track_of(segment, cleaned.angle.level)
        if kind is None and not stays(segment):
            raise NotAllowed(REFUSED[kind])
        if said := told_jumps(jumps_of(segment, cleaned.angle.level)):
            raise NotAllowed(f"{said}. {AGAIN}")
        law = law_for(cleaned.recording, number)
        seen = signal_of(segment, cleaned.recording.sensors)
        handled = recording.subject.kind != "rig"
        drifting = read_off(track, lambda each: find_landmarks(each, handled, law, seen))
        found = drifting.landmarks
        stop = of_stop(found)
        halt = of_halt(found) if handled and not stop else None
        read, smoothed = as_smoothed(drifting.measures, cleaned.angle, recording)
        read, scales = with_doubted_scales(read, cleaned.recording)
        read, times = with_doubted_times(read, cleaned.recording, number)
        push = of_push(found, drifting.measures) if handled else of_rise(track, found)
        lead = of_lead(found) if handled else None
        wild = of_wild_samples(recording.segments[number], segment)
        play = of_play(cleaned)
        notes = stop, drifting.note, smoothed, scales, times, lead, push, play, wild
        note = "; ".join(filter(None, notes)) or None
        if halt is None:
            check_motion(read)
    except NotAllowed as why:
        return Drop(name, segment, mass, {}, None, str(why))
    thigh = recording.thigh_angle(number)
    return Drop(name, segment, mass, read, found, None, note, halt, drifting.drift, thigh)


def of_wild_samples(given: Segment, cleaned: Segment) -> str | None:
    """That samples of the angle are left out, for no leg moves like them; None where none are."""
    before, after = (int(np.isnan(each.best_angle).sum()) for each in (given, cleaned))
    count = after - before
    if not count:
        return None
    return f"{counted(count, 'sample')} of the angle, apart from those around, left out"


def check_motion(read: dict[str, Measure]) -> None:
    """**Raises** `NotAllowed` where nothing is told of a drop but where it begins, as of a record
    that ends in the fall.
    """
    if all(each.value is None for name, each in read.items() if name != "start_angle"):
        raise NotAllowed(f"nothing to read: {read['first_flexion_amplitude'].reason}")


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
