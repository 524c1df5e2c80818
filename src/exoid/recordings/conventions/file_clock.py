"""The clock of a recording as its file has it: in seconds, from the first sample on."""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.noise import noise_of

SLOWEST = 0.2  # s between samples; a leg's swing takes about a second
UNITS = (  # and the steps [of that unit] up to which a sampled leg has it
    ("milliseconds", 'Then name the column time_ms, or say columns={"time_ms": NAME}', 300.0),
    ("microseconds", 'Then name the column time_us, or say columns={"time_us": NAME}', 3e5),
    ("nanoseconds", 'Then name the column time_ns, or say columns={"time_ns": NAME}', np.inf),
)
BRIEFEST = 6e-4  # s between samples: 30 Hz, told in minutes
LAG = 8  # steps over which a speed is taken there
FASTEST = 40.0  # rad/s; a kick reaches 20
USUAL = 4.0  # rad/s, of a drop at its fastest
LONGER = (("minutes", 60.0), ("hours", 3600.0), ("days", 86400.0))
ALIKE = 0.05  # of a rate: so near it is the declared one
SINCE = 1e8  # s, three years: no node runs so long, so this counts from a date


def wrong_clock(recording: Recording) -> str | None:
    """What to do about the time of a leg, where its motion says that it is not in seconds."""
    if recording.subject.kind == "rig":
        return None
    step = step_of(recording)
    if step >= SLOWEST:
        unit, mend, _ = next(each for each in UNITS if step < each[2])
        return (
            f"time_s steps by {step:.6g} from sample to sample: in seconds no leg can be followed "
            f"like that. Is it in {unit}? {mend}."
        )
    speed = max(map(fastest, recording.segments)) if step < BRIEFEST else 0.0
    if speed < FASTEST:
        return None
    unit, factor = min(LONGER, key=lambda each: abs(np.log(speed / each[1] / USUAL)))
    return (
        f"by time_s the leg turns at {speed:.3g} rad/s, where a kick reaches 20. Is the time in "
        f"{unit}? Multiply it by {factor:g}."
    )


def late_starts(recording: Recording) -> Notes:
    """A clock that runs on from segment to segment: read as it is, and said."""
    late = [n for n, each in enumerate(recording.segments) if 0 != each.time[0] < SINCE]
    if not late:
        return ()
    start = recording.segments[late[0]].time[0]
    return (f"time_s starts at {start:g} s, not at 0, in segment {late[0]}. It is kept as it is.",)


def fastest(segment: Segment) -> float:
    """How fast the leg turns [rad/s] in all but a hundredth of the samples, noise apart."""
    time, angle = measured(segment)
    if time.size < 2 * LAG:
        return 0.0
    noise = 3 * np.sqrt(2) * noise_of([time], [angle], None).level
    moved = np.maximum(np.abs(angle[LAG:] - angle[:-LAG]) - noise, 0.0)
    return float(np.quantile(moved / (time[LAG:] - time[:-LAG]), 0.99))


def measured(segment: Segment) -> tuple[Samples, Samples]:
    """Times and angles of the encoder, or of a filter where there is no other."""
    seen = ~np.isnan(segment.best_angle)
    return segment.time[seen], segment.best_angle[seen]


def unlike_rate(recording: Recording) -> Notes:
    """That the samples come at another rate than the sidecar says."""
    said, step = recording.sensors.sample_rate, step_of(recording)
    if said is None or abs(said * step - 1) < ALIKE:
        return ()
    return (
        f"sample_rate_hz says {said:g}, but by time_s there are {1 / step:.3g} samples a second; "
        "the times count.",
    )


def step_of(recording: Recording) -> float:
    """The median time between samples [s]."""
    return float(np.median(np.concatenate([np.diff(each.time) for each in recording.segments])))


def from_first_sample(recording: Recording) -> Recording:
    """A clock that counts from a date (1970, 1904) begins at 0 instead; its origin is kept."""
    origin = float(recording.segments[0].time[0])
    if origin < SINCE:
        return recording
    segments = tuple(replace(each, time=each.time - each.time[0]) for each in recording.segments)
    protocol = replace(recording.protocol, time_origin=origin)
    return replace(recording, segments=segments, protocol=protocol)
