"""A gyro at the end of its range: it stands at one rate while the encoder turns faster.

A smooth motion leaves the step q of a sensor at its peak by q = a h^2 / 2, and stands there for
2 h. As long again before and after it has fallen by a (3 h)^2 / 2 - q = 8 q. What falls by more was
cut off. The encoder says so as well, whatever the gyro's step is.
"""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import ROUNDING, Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import runs
from exoid.recordings.signal.local_line import interpolated
from exoid.recordings.signal.noise import noise_of

FEWEST = 3  # samples in a row; fewer tell no curve
PLACES = 2  # at which a gyro stands at one limit; a value that is held once may be the greatest,
LONG = 10  # unless it is held for so many samples: no noise does that where the leg turns faster
DECLARED = 0.98, 1.2  # of the declared range, at which a gyro ends: some tell more than is said
SMOOTH = 12.0  # steps that a smooth peak falls by: 8, and rounding and noise of two steps each
SURE = 4.0  # standard deviations of what the encoder turns
GAIN = 0.03  # of a rate, by which gyro and encoder may be apart anyhow


def without_saturated(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with NaN for a gyro's samples at the ends of its range, and how many, said."""
    limits = gyro_limits(recording)
    if not limits:
        return recording, ()
    masks = [np.isin(np.abs(rates_of(each)), limits) for each in recording.segments]
    segments = tuple(map(left_out, recording.segments, masks))
    return replace(recording, segments=segments), (told(limits, masks),)


def gyro_limits(recording: Recording) -> list[float]:
    """The rates [rad/s], either way, at which a gyro's range ends; none where it is not seen."""
    rates = np.concatenate([rates_of(each) for each in recording.segments])
    values = np.unique(rates[~np.isnan(rates)])
    steps = np.diff(values)
    steps = steps[steps > ROUNDING]
    if not steps.size:
        return []
    ends = sorted({float(each) for each in np.abs(values[[0, -1]])})
    return [end for end in ends if stands_at(recording, end, float(steps.min()))]


def stands_at(recording: Recording, end: float, step: float) -> bool:
    """Does the gyro, of this step, stand at an end [rad/s] of its range: at more than one place, at
    one for long, or at one where the range is declared to end?
    """
    each = [samples for one in recording.segments for samples in places(one, end, step)]
    known = recording.sensors.gyro_range
    ratio = 0.0 if known is None else float(np.degrees(end)) / known
    at_range = DECLARED[0] <= ratio <= DECLARED[1]
    return len(each) >= PLACES or max(each, default=0) >= (FEWEST if at_range else LONG)


def places(segment: Segment, end: float, step: float) -> list[int]:
    """For how many samples the gyro, of this step, stands at an end [rad/s] of its range, at every
    place where it does.
    """
    rates = rates_of(segment)
    known = ~np.isnan(rates)
    rates = rates[known]
    found = [each for way in (end, -end) for each in runs(rates == way)]
    long = [(first, last) for first, last in found if last - first + 1 >= FEWEST]
    if not long or np.isnan(segment.best_angle).all():
        return []
    time, angle = segment.time[known], interpolated(segment.time, segment.best_angle)[known]
    error = SURE * 2**0.5 * noise_of([time], [angle], None).level
    return [
        last - first + 1
        for first, last in long
        if cut_off(rates, first, last, step)
        and turns_faster(time[[first, last]], angle[[first, last]], float(rates[first]), error)
    ]


def cut_off(rates: Samples, first: int, last: int, step: float) -> bool:
    """Do rates fall on either side, in the time for which they stand or sooner, by more than a
    smooth peak?
    """
    count = last - first + 1
    beside = rates[[max(first - count, 0), min(last + count, rates.size - 1)]]
    return bool(np.abs(beside - rates[first]).min() > SMOOTH * step)


def turns_faster(time: Samples, angle: Samples, rate: float, error: float) -> bool:
    """Does an angle [rad] go farther from the first time to the last than at a rate [rad/s], by
    more than an error [rad]?
    """
    turned = abs(rate) * (time[-1] - time[0])
    beyond = np.sign(rate) * (angle[-1] - angle[0]) - turned
    return bool(beyond > max(error, GAIN * turned))


def rates_of(segment: Segment) -> Samples:
    """What the gyro says [rad/s]; nan without one."""
    rates = segment.raw_angular_velocity
    return np.full(segment.time.size, np.nan) if rates is None else rates


def left_out(segment: Segment, these: np.ndarray) -> Segment:
    if not these.any():
        return segment
    return replace(segment, raw_angular_velocity=np.where(these, np.nan, rates_of(segment)))


def told(limits: list[float], masks: list[np.ndarray]) -> str:
    """At which rates, and in how many samples."""
    rates = " and ".join(f"{each:.4g}" for each in np.degrees(limits))
    return (
        f"the gyro stands at {rates} deg/s while the leg turns faster, as at the end of its range: "
        f"{sum(int(each.sum()) for each in masks)} such samples are left out. Record with a "
        "greater range of the gyro."
    )
