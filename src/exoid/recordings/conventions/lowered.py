"""Which passive segments are no drops, for a hand lowered the leg: told beside those that swing.

A leg that is let go gains the speed that its fall gives it, v^2 = 2 pull (cos(phi - angle) -
cos(phi_0 - angle)) less what damping takes, and friction. One that a hand lowers, half-way or until
it hangs, gains a small part of that, and does not swing.
"""

import numpy as np

from exoid.files.counted import some_of
from exoid.files.text_file import Notes
from exoid.recordings.conventions.balance import Balance, balance, middle, swings
from exoid.recordings.conventions.file_clock import measured
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.selection import selection
from exoid.recordings.signal.condition import SMOOTHING, classify
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.splitting.split import SHOWN, Split

LEAST = 0.6  # of what the swinging ones gain: of 650 drops in 128 logs, 91 of them caught in their
# first swing, none gains less than 0.7; of 230 lowerings in 0.6 to 2.2 s 99 in 100 do
WHY = "as by a hand that lowers the leg"


def lowered(recording: Recording) -> tuple[int, ...]:
    """The numbers of those segments; none where nothing swings, or of a rig."""
    if recording.subject.kind == "rig":
        return ()
    alike: dict[float, list[int]] = {}
    for number, segment in enumerate(recording.segments):
        passive = (recording.kind(number) or classify(segment)) == "passive"
        if passive and balance(segment) is not None:
            alike.setdefault(recording.added_mass(number), []).append(number)
    return tuple(sorted(each for some in alike.values() for each in among(recording, some)))


def among(recording: Recording, numbers: list[int]) -> list[int]:
    """Those of some drops of one leg with one load."""
    segments = {number: recording.segments[number] for number in numbers}
    swung = [each for each in segments.values() if swings(each)]
    if not swung:
        return []
    usual = middle([found for each in swung if (found := balance(each)) is not None])
    # One that a hand or a muscle pushes gains more than its fall gives.
    least = LEAST * min(float(np.median([gained(each, usual) for each in swung])), 1.0)
    return [
        number
        for number, each in segments.items()
        if not swings(each) and gained(each, usual) < least
    ]


def gained(segment: Segment, usual: Balance) -> float:
    """The square of the greatest speed, over that of an undamped fall to where it is reached."""
    time, angle = measured(segment)
    smooth, speed = local_line(time, angle, 2 * SMOOTHING)
    fastest = 1 + int(np.argmax(np.abs(speed[1:-1])))
    height = np.cos(smooth[[fastest, 0]] - usual.angle)
    fall = 2 * usual.pull * float(height[0] - height[1])
    return float(speed[fastest] ** 2) / fall if fall > 0 else np.inf


def without_lowered(found: Split) -> Split:
    """What a log was cut into, less what a hand lowered, which is said."""
    left = lowered(found.recording)
    if not left:
        return found
    segments = found.recording.segments
    kept = [number for number in range(len(segments)) if number not in left]
    times = [
        f"{each.begins:.1f} to {each.begins + each.time[-1]:.1f} s"
        for each in (segments[number] for number in left)
    ]
    where = some_of(times, SHOWN, "more times")
    said = f"left out, for the leg moves slower than it falls, {WHY}: from {where}"
    return Split(selection(found.recording, kept), (*found.notes, said))


def told_lowered(recording: Recording) -> Notes:
    """What to say of segments that were not cut out of a log, and stay with their numbers."""
    return tuple(
        f"segment {number} moves slower than this leg falls, {WHY}: it is no drop. Leave it out."
        for number in lowered(recording)
    )
