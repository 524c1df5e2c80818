"""An angle at the end of its sensor's range: it stands there while the leg swings beyond, and back.

What stops a leg takes its speed, and nothing gives it back. Where a range ends the angle comes to
stand at once and leaves as fast, after the time in which gravity and springs turn a leg around. One
that is let go beyond the end is first seen when it falls already, which nothing at rest does at
once. What nobody measured leaves by a jump: see `lost_samples`.
"""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.conventions.left_out.interpolated import written_step
from exoid.recordings.measured.samples import Samples, usual_step
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import runs

CHANNELS = "raw_angle", "angle"
FEWEST = 4  # samples that stand; fewer tell no time in which a leg turns around
STEPS = 3.0  # of the sensor, by which it may scatter where it stands
CLEAR = 12.0  # steps that a leg goes beyond at the least; where it turns smoothly it goes STEPS
BESIDE = 0.02  # s, and two samples at the least, over which a speed is told
MOVES = 0.5  # rad/s, at which the angle comes to stand and leaves
BACK = 0.5, 1.2  # times the speed at which it came, of a swing; behind play it leaves faster
TURNED = 100.0  # rad/s^2, by which a leg is turned around at the most; a stop does it by more
HELD = 0.1  # s, for which a leg is held that is let go
FALLS = 50.0  # rad/s^2, by which a leg is drawn that is let go, at the most
FALLING = 1.0  # rad/s, beyond what that makes of it meanwhile
EVEN = 2.0  # times what the speed makes of a step, that the angle leaves by; more is a jump


@dataclass(frozen=True)
class Stand:
    """Where an angle stands at one value, and how fast it comes and leaves; nan at an end."""

    lasting: float  # s
    came: float  # rad/s, positive outwards
    left: float  # rad/s, positive inwards
    since: float  # s, from where it stands to where that is told

    def swings(self, step: float) -> bool:
        """Does the leg go on beyond and come back, by more than its sensor's step [rad] hides?"""
        beyond = (self.came + self.left) * self.lasting / 8  # where it turns evenly
        back = BACK[0] * self.came <= self.left <= BACK[1] * self.came
        evenly = self.came + self.left <= TURNED * self.lasting
        return bool(back and evenly and self.left > MOVES and beyond > CLEAR * step)

    def falls(self, step: float) -> bool:
        """Does it fall as one that was let go beyond, by coarse steps [rad] too?"""
        hidden = (2 * FALLS * (STEPS + 1) * step) ** 0.5  # rad/s, at which it leaves such steps
        return self.lasting > HELD and self.left > FALLING + hidden + FALLS * self.since


def without_clipped(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with NaN for an angle's samples at the ends of its range, said."""
    notes: Notes = ()
    for name, way in product(CHANNELS, (-1.0, 1.0)):
        recording, more = without_end(recording, name, way)
        notes += more
    return recording, notes


def without_end(recording: Recording, name: str, way: float) -> tuple[Recording, Notes]:
    """The same of one channel at its lowest end, way -1, or its highest, 1."""
    signals = [getattr(each, name) for each in recording.segments]
    if any(each is None or np.isnan(each).all() for each in signals):
        return recording, ()
    outwards = [way * each for each in signals]
    step, end = written_step(outwards), max(map(np.nanmax, outwards))
    masks = [each >= end - STEPS * step for each in outwards]
    each = zip(recording.segments, outwards, masks, strict=True)
    found = [stand for one, samples, mask in each for stand in stands(one.time, samples, mask)]
    free = recording.subject.kind != "rig"  # which may be struck, and leave at any speed
    if not any(one.swings(step) or (free and one.falls(step)) for one in found):
        return recording, ()
    left = [np.where(*each) for each in zip(masks, [np.nan] * len(masks), signals, strict=True)]
    segments = [
        replace(one, **{name: own}) for one, own in zip(recording.segments, left, strict=True)
    ]
    return replace(recording, segments=tuple(segments)), (told(way * end, masks),)


def stands(time: Samples, outwards: Samples, mask: NDArray[np.bool_]) -> list[Stand]:
    """Where the known samples of an angle [rad] are at its end, as long as tells anything."""
    known = ~np.isnan(outwards)
    time, outwards = time[known], outwards[known]
    if time.size <= FEWEST:
        return []
    usual = usual_step(time)
    count = max(2, round(BESIDE / usual))
    return [
        Stand(
            float(time[last] - time[first]),
            leaving(time[first] - time[first::-1], outwards[first::-1], count),
            leaving(time[last:], outwards[last:], count),
            (1 + count / 2) * usual,
        )
        for first, last in runs(mask[known])
        if last - first + 1 >= FEWEST
    ]


def leaving(time: Samples, outwards: Samples, count: int) -> float:
    """How fast an angle leaves the first of some samples inwards [rad/s], by so many steps; nan
    where they are too few, or where it jumps.
    """
    if time.size < count + 2:
        return np.nan
    speed = (outwards[1] - outwards[1 + count]) / (time[1 + count] - time[1])
    jumps = outwards[0] - outwards[1] > EVEN * speed * (time[1] - time[0])
    return np.nan if jumps else float(speed)


def told(end: float, masks: list[NDArray[np.bool_]]) -> str:
    """Where the range ends, and how many samples are there."""
    count = sum(int(each.sum()) for each in masks)
    return (
        f"the angle stands at {np.degrees(end):.4g} deg while the leg moves on beyond it, as at "
        f"the end of its sensor's range: {count} such samples are left out. Mount the sensor so "
        "that its range holds the whole swing."
    )
