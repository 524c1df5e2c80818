"""The measures of the Wartenberg pendulum test, which clinicians read off a drop, as formulas.

They are named in the groups of Rahimi et al., BioMedical Engineering OnLine 19:82, 2020,
doi 10.1186/s12938-020-00826-8, which sorts the outcome measures of the test into those of angle,
of angular velocity and of angular acceleration. Of the review only the abstract was at hand, not
its tables of definitions: the formulas below are exoid's, from the sources named with them.

The relaxation index is that of Grippo et al., Europa Medicophysica 33(2), 1997, and Whelan et al.,
J NeuroEngineering Rehabil 15, 2018, doi 10.1186/s12984-018-0411-x: the angle of the first downswing
over the angle from start to rest. Its normalised form divides by 1.6, a convention that is ascribed
to Bajd and Vodovnik, J Biomedical Engineering 6, 1984, which was not read. And by definitions of
exoid's own:

- the expected relaxation index of a leg that was caught before rest, or of a record that was cut,
  takes the angle that its swings shrink to, with the band in which dry friction could hold the leg
  in its error; of others it is the relaxation index: whoever leaves cut records out leaves out the
  least damped legs;
- at rest: within 2 deg of the resting angle, which is the middle of what the leg still swings in
  the last period of the record; where friction has stopped it, where it stands;
- a swing: one that turns back by at least 1 deg (and by 8 times the noise of the angle
  smoothed over 0.1 s);
- an oscillation: a flexion whose peak lies beyond the band of rest;
- period: the mean time between flexion peaks, over the first three oscillations at most;
- logarithmic decrement n: log of the n-th flexion swing over the next, each from the extension peak
  (at first the start) to the flexion peak that follows, so that no resting angle enters;
- peak velocity and acceleration: of the first flexion, and of the extension after it (the
  acceleration towards extension is greatest about the first flexion peak); their sizes.

Amplitudes are differences of knee angles. Angles are exoid's: 0 extended, flexion negative.
Velocity and acceleration are derivatives of the angle, so that a gyro's scale and bias do not
enter. Standard errors hold the white noise of the angle, how a hand that swayed moved the leg
before it let go, and 7 % of the acceleration at the release for what the polynomial there leaves
out; an off-centre magnet, a cuff that slips or what a filter takes from peaks is not in them
(`smoothing.py` says of which angles).
"""

from dataclasses import dataclass, replace
from math import hypot, log

from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.measure import Mark, NotAllowed
from exoid.recordings.landmarks.release import MISSED
from exoid.recordings.landmarks.rest import BAND
from exoid.recordings.landmarks.track import HALF, SURE, Peak

NORM = 1.6  # of the normalised relaxation index
CYCLES = 3  # oscillations, at most, of which a period is the mean and decrements are told


@dataclass(frozen=True)
class DropReading:
    """A value with its error, and where it is seen."""

    value: float
    error: float
    marks: tuple[Mark, ...]


def start_angle(drop: Landmarks) -> DropReading:
    return at(drop.release.start)


def first_flexion_amplitude(drop: Landmarks) -> DropReading:
    """A1 = phi_start - phi_flexion1."""
    return between(drop.release.start, drop.flexion(1))


def plateau_angle(drop: Landmarks) -> DropReading:
    return at(drop.rest.angle)


def plateau_amplitude(drop: Landmarks) -> DropReading:
    """A0 = phi_start - phi_rest."""
    return between(drop.release.start, drop.rest.angle)


def relaxation_index(drop: Landmarks, norm: float = 1.0) -> DropReading:
    """RI = A1 / A0; normalised A1 / (1.6 A0)."""
    rest = drop.rest.angle
    found = index_of(drop, rest, norm)
    return DropReading(found.value, found.error, (*found.marks, rest.mark))


def expected_relaxation_index(drop: Landmarks) -> DropReading:
    """RI, of a leg that was caught or cut before rest by the angle that its swings shrink to."""
    return index_of(drop, drop.expected_rest, 1.0)


def index_of(drop: Landmarks, rest: Peak, norm: float) -> DropReading:
    """(phi_start - phi_flexion1) / (phi_start - phi_rest) over `norm`."""
    start, first = drop.release.start, drop.flexion(1)
    swing, plateau = start.value - first.value, start.value - rest.value
    if plateau < BAND:
        raise NotAllowed("no plateau: the leg starts where it comes to rest")
    index = swing / plateau / norm
    parts = ((1 - swing / plateau) * start.error, first.error, swing / plateau * rest.error)
    return DropReading(index, hypot(*parts) / plateau / norm, (start.mark, first.mark))


def number_of_oscillations(drop: Landmarks) -> DropReading:
    """Its error is 1 where a peak lies so near to the band of rest that noise may decide."""
    drop.check_fall()
    drop.check_counted()
    rest, found = drop.rest.angle, drop.turns[::2]
    for each in found:
        drop.track.check_seen(each.time)
    beyond = [rest.value - each.value - BAND for each in found]
    places = list(zip(found, beyond, strict=True))
    close = any(SURE * hypot(each.error, rest.error) > abs(far) for each, far in places)
    counted = tuple(each.mark for each, far in places if far > 0)
    return DropReading(float(len(counted)), float(close), counted)


def period(drop: Landmarks) -> DropReading:
    count = min(max(len(drop.turns[::2]) - 1, 1), CYCLES)
    first, last = drop.flexion(1), drop.flexion(1 + count)
    error = hypot(first.time_error, last.time_error) / count
    return DropReading((last.time - first.time) / count, error, (first.mark, last.mark))


def logarithmic_decrement(drop: Landmarks, number: int) -> DropReading:
    """D_n = log(F_n / F_(n+1)), F_n = phi_extension(n-1) - phi_flexion(n)."""
    ends = [(drop.extension(each - 1), drop.flexion(each)) for each in (number, number + 1)]
    swings = [high.value - low.value for high, low in ends]
    if min(swings) <= 0:
        raise NotAllowed(f"no swing to flexion: cycle {number} or the one after does not go down")
    parts = [
        hypot(high.error, low.error) / swing
        for (high, low), swing in zip(ends, swings, strict=True)
    ]
    marks = tuple(each.mark for pair in ends for each in pair)
    return DropReading(log(swings[0] / swings[1]), hypot(*parts), marks)


def time_to_rest(drop: Landmarks) -> DropReading:
    start, rest = drop.release.start, drop.rest.since
    drop.track.check_seen(rest.time)
    error = hypot(start.time_error, rest.time_error)
    return DropReading(rest.time - start.time, error, (start.mark, rest.mark))


def peak_flexion_velocity(drop: Landmarks) -> DropReading:
    drop.check_fall()
    found = drop.steepest(1, -1, drop.begin, drop.flexion(1).time)
    if found.time - drop.track.time[0] < HALF:
        raise NotAllowed("begins too late: the first flexion is already at its fastest")
    return size(found)


def peak_extension_velocity(drop: Landmarks) -> DropReading:
    drop.check_fall()
    return size(drop.steepest(1, 1, drop.flexion(1).time, drop.extension(1).time))


def peak_flexion_acceleration(drop: Landmarks) -> DropReading:
    release = drop.release
    after, value, error = release.steepest()
    later = drop.steepest(2, -1, release.start.time + HALF, drop.flexion(1).time)
    if later.value < value:
        return size(replace(later, error=hypot(later.error, MISSED * later.value)))
    start = release.start
    return size(Peak(start.sample, start.time + after, start.time_error, value, error))


def peak_extension_acceleration(drop: Landmarks) -> DropReading:
    drop.check_fall()
    begin, end = drop.begin + HALF, drop.extension(1).time
    smooth, struck = drop.steepest(2, 1, begin, end), drop.struck(begin, end)
    return size(smooth if struck is None or struck.value < smooth.value else struck)


def at(place: Peak) -> DropReading:
    return DropReading(place.value, place.error, (place.mark,))


def between(high: Peak, low: Peak) -> DropReading:
    return DropReading(high.value - low.value, hypot(high.error, low.error), (high.mark, low.mark))


def size(place: Peak) -> DropReading:
    return DropReading(abs(place.value), place.error, (place.mark,))
