"""The movements of a continuous recording: drops, cycles, and what a hand did between them."""

from dataclasses import replace

import numpy as np

from exoid.recordings.declared.protocol import Kind
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.find_free import moving
from exoid.recordings.motion.signal import Speed, signal_of, smoothed, speed_of
from exoid.recordings.motion.thresholds import ABOVE, CHANGE, CLEAR, LOST, MINOR, SWAYING, TRAVEL
from exoid.recordings.signal.condition import RINGING, classify, cut, reversals, swings_out
from exoid.recordings.splitting.piece import Piece, rings
from exoid.recordings.splitting.small_lifts import with_small_lifts


def find_pieces(log: Segment, sensors: Sensors, told: Kind | tuple | None) -> list[Piece]:
    """The movements that go far, in turn. `told` is what the sidecar says of all of them.

    A hand that sways as it keeps the leg joins a lift and a drop: where a leg swings out in such a
    movement, slow swaying parts it.
    """
    signal = signal_of(log, sensors)
    speed = speed_of(signal)
    smooth, noise = smoothed(signal, speed.width)
    patient = replace(speed, still=max(speed.still, SWAYING))
    least, finest = (max(each, CLEAR * noise) for each in (TRAVEL, CHANGE))

    def pieces_in(part: slice, speed: Speed) -> list[Piece]:
        parts = far_ones(log.time, smooth, part, speed, least)
        return [with_lift(piece(log, smooth, each, told), smooth, least, finest) for each in parts]

    pieces = []
    for whole in pieces_in(slice(0, log.time.size), speed):
        parts = [] if swing_out(log, smooth, [whole]) else pieces_in(whole.samples, patient)
        pieces += parts if swing_out(log, smooth, parts) else [whole]
    return with_small_lifts(log.time, smooth, pieces)


def far_ones(
    time: Samples, smooth: Samples, part: slice, speed: Speed, least: float
) -> list[slice]:
    """The samples of the movements in a part that go far, between rests."""
    begin, last = part.start, time.size - 1
    moves = moving(time[part], replace(speed, velocity=speed.velocity[part]))
    found = [slice(max(begin + a - 1, 0), min(begin + b + 1, last) + 1) for a, b in moves]
    travel = [float(np.ptp(smooth[each])) for each in found]
    least = max([least, *(MINOR * each for each in travel)])
    return [each for each, far in zip(found, travel, strict=True) if far > least]


def swing_out(log: Segment, smooth: Samples, pieces: list[Piece]) -> bool:
    """Does a leg swing out in some of them, and in all that would be drops?"""
    drops = [each.samples for each in pieces if each.kind == "passive"]
    return bool(drops) and all(swings_free(log, smooth, each) for each in drops)


def swings_free(log: Segment, smooth: Samples, part: slice) -> bool:
    seen = ~np.isnan(log.best_angle[part])
    return swings_out(log.time[part], smooth[part], seen)


def piece(log: Segment, smooth: Samples, part: slice, told: Kind | tuple | None) -> Piece:
    """What a movement is, by where it ends and whether it rises above where it began.

    A leg that swung out was free, however far the hand that takes it in its swings lifts it then.
    What is told to be drops, and falls and comes back, was caught as it did.
    """
    kind, angle = classify(cut(log, part)), smooth[part]
    name = {"passive": "a drop", "active": "a movement to and fro", None: "a lift"}[kind]
    if kind is None and rings(angle):
        kind, name = "passive", "a drop upwards"  # for the check of signs to see
    above = float(angle.max() - angle[0]) > ABOVE * float(np.ptp(angle))
    if kind == "active" and above:
        kind, name = None, "shaking"
    if name == "a drop" and above and not swings_free(log, smooth, part):
        kind, name = None, "a push"
    if told == "passive" and kind == "active" and caught(angle):
        kind, name = "passive", "a drop"
    if told in ("passive", "active") and kind != told:
        kind = None
    return Piece(part.start, part.stop, kind, name)


def with_lift(piece: Piece, smooth: Samples, least: float, finest: float) -> Piece:
    """A drop with where a hand lifts the leg at its end, if one does: farther up, by `least` rad,
    than the leg swung before, and up to where it stays. It begins where the leg last turned around,
    by the `finest` rad that tells a turn from noise.
    """
    if piece.name != "a drop":
        return piece
    angle = smooth[piece.samples]
    ends = [0, *reversals(angle, least), angle.size - 1]
    lows = [
        low
        for before, low, top in zip(ends, ends[1:], ends[2:], strict=False)
        if min(angle[top], angle[-1]) > max(angle[before], angle[low]) + least
    ]
    if not lows:
        return piece
    rise = angle[lows[-1] :][: int(np.argmax(angle[lows[-1] :])) + 1]
    turns = [0, *reversals(rise, finest)]
    return replace(piece, lifted=piece.start + lows[-1] + turns[-1])


def caught(angle: Samples) -> bool:
    """Does a movement fall first, and come back by less? So does a leg that is caught in its first
    swing; a hand that moves it to and fro brings it back.
    """
    turns = reversals(angle, RINGING * float(np.ptp(angle)))
    lost = float(angle[0] - angle[-1]) / float(np.ptp(angle))
    return bool(turns) and bool(angle[turns[0]] < angle[0]) and lost > LOST
