"""A rig's log: what surely swung freely in it, for nobody says who moves a rig, and where to."""

from dataclasses import replace

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from exoid.recordings.motion.thresholds import ROCKING
from exoid.recordings.signal.condition import cut, swings_out
from exoid.recordings.splitting.piece import Piece, rings

LAST = 1.0  # s before a rest, the swing of a rig as long as a leg
NO_SWING = "a movement that does not swing"


def free_alone(log: Segment, pieces: list[Piece]) -> list[Piece]:
    """The movements, of which those that swing, either way first, are free: no hand does that, but
    it may lower a rig as well as lift it.
    """
    angle = log.best_angle
    return [
        each
        if each.kind is None or swings(log.time[each.samples], angle[each.samples])
        else replace(each, kind=None, name=NO_SWING)
        for each in pieces
    ]


def swings(time: Samples, angle: Samples) -> bool:
    known = ~np.isnan(angle)
    time, angle, seen = time[known], angle[known], np.ones(int(known.sum()), dtype=bool)
    return swings_out(time, angle, seen) or rings(angle)


def free_part(log: Segment, sensors: Sensors, part: slice, swung: Piece) -> slice:
    """Up to where a hand took the rig: in a rig's segment nobody looks for one. Where its swings
    end at once, none of the rest behind them is the rig's own.
    """
    part = slice(part.start, part.stop if settled(log, swung) else swung.stop)
    try:
        extent = find_free(signal_of(cut(log, part), sensors))
    except Motionless:
        return part
    return slice(part.start, part.start + extent.stop) if extent.ended == "caught" else part


def settled(log: Segment, swung: Piece) -> bool:
    """Did it hardly move any more before it was at rest?"""
    since = int(np.searchsorted(log.time, log.time[swung.stop - 1] - LAST))
    last = log.best_angle[max(since, swung.start) : swung.stop]
    return bool(np.nanmax(last) - np.nanmin(last) < ROCKING[0])
