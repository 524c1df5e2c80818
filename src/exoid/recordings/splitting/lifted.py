"""Drops without the lift that ends them."""

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from exoid.recordings.signal.condition import cut
from exoid.recordings.splitting.piece import Piece


def without_lifts(
    log: Segment, sensors: Sensors, parts: list[slice], pieces: list[Piece]
) -> list[slice]:
    """The parts of these pieces, of what no hand moved; each up to where one may be on the leg that
    it then lifts.
    """
    kept = [each for each in pieces if each.kind is not None]
    return [
        part if piece.lifted is None else before_hand(log, sensors, part, piece.lifted)
        for part, piece in zip(parts, kept, strict=True)
    ]


def before_hand(log: Segment, sensors: Sensors, part: slice, lifted: int) -> slice:
    """The part up to where a hand is first seen, which is at the sample `lifted` at the latest."""
    try:
        hand = find_free(signal_of(cut(log, part), sensors)).hand
    except Motionless:
        hand = None
    stop = lifted if hand is None else min(part.start + hand, lifted)
    return slice(part.start, stop)
