"""Play between a leg and its encoder, told by the gyro without any leg model.

Where the leg turns back the encoder stands, until the play is passed. What it shows follows the
angle that the gyro turned through like a block that is pushed from either side (Prandtl's play
operator): by half the play behind, whichever way the leg goes.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.noise import Play

WIDTHS = np.radians(np.geomspace(0.05, 6.0, 21))  # rad, of the play, to choose from
BEGINS = np.linspace(-1.0, 1.0, 9)  # halves of it, by which an encoder is ahead at first
KNOT = 1.0  # s between which a gyro's zero may change
FINE = 0.02  # of a width, to which it is sought
FEWEST = 100  # samples beyond what is free
LONGEST, MANY = 30.0, 20  # s of a part, and parts that tell the play
ROUNDS = 3  # a late gyro is moved by what the last has found
SMALL = 1.3  # mean square over the noise, that nothing is looked for in
FALLS = 0.7  # times what is left without play: sensors without any leave above 0.95 of it
EXPLAINED = 2.0  # mean square over the noise, that it may leave: else the mismatch is another,
ALL = 0.005  # unless no more of it is left: an encoder that stands in its play shows less noise

Table = NDArray[np.float64]
Pair = tuple[Samples, Samples, Samples]  # of a segment: times, angle, rate


@dataclass(frozen=True, eq=False)
class Turned:
    """What a segment shows where both sensors measured."""

    time: Samples
    apart: Samples  # rad, the encoder's angle less the gyro's
    angle: Samples  # rad, that the gyro turned through, its zero's part taken out
    free: Table  # orthonormal: what other errors of sensors may add, last what a late gyro does
    moves: float  # rad/s, how much of the gyro's rate is along the last


@dataclass(frozen=True)
class Found:
    """What one round finds."""

    play: Play
    later: float  # s, by which the gyro is later than was taken
    left: float  # mean square over the noise
    share: float  # of what there is without play


def find_play(pairs: list[Pair], noise: float) -> tuple[Play, list[Samples]] | None:
    """The play, and by how much the encoder is ahead of the leg for it at every sample [rad]; None
    where there is none. `noise` is that of an angle.
    """
    parts = [parts_of(*pair) for pair in pairs]
    some = [part for own in parts for part in own]
    some, late, found = some[:: -(-len(some) // MANY)], 0.0, None
    for _ in range(ROUNDS):
        found = in_one_round([turned(*part, late) for part in some], noise)
        if found is None:
            return None
        late += found.later
    if found is None or (found.left > EXPLAINED and found.share > ALL):
        return None
    width = found.play.width
    return found.play, [np.concatenate([ahead(one, late, width) for one in own]) for own in parts]


def in_one_round(pieces: list[Turned], noise: float) -> Found | None:
    """The play beside a gyro that may be later yet; None where hardly anything goes with it."""
    freedom = sum(each.free.shape[0] - each.free.shape[1] for each in pieces)
    if freedom < FEWEST:
        return None
    without = squares_without(pieces)
    if without < SMALL * freedom * noise**2:
        return None
    near, squares = finest(pieces)
    bend = 2 * float(np.polyfit(near - near[1], squares, 2)[0])
    if squares[1] > FALLS * without or bend <= 0:
        return None
    play = Play(float(near[1]), float(np.sqrt(2 * squares[1] / freedom / bend)))
    left = float(squares[1] / freedom / noise**2)
    return Found(play, lateness(pieces, play.width), left, float(squares[1]) / without)


def parts_of(time: Samples, angle: Samples, rate: Samples) -> list[Pair]:
    """A segment in parts of half a minute."""
    count = int((time[-1] - time[0]) / LONGEST) + 1
    each = [np.array_split(one, count) for one in (time, angle, rate)]
    return list(zip(*each, strict=True))


def squares_without(pieces: list[Turned]) -> float:
    """What is left where there is no play."""
    return sum(float(np.sum(left(each, each.apart[:, None]) ** 2)) for each in pieces)


def finest(pieces: list[Turned]) -> tuple[Samples, Samples]:
    """The best width between its neighbours [rad], and the sum of squares that each leaves."""
    widths = WIDTHS
    while True:
        squares = np.sum([squares_of(each, widths).min(axis=1) for each in pieces], axis=0)
        best = int(np.clip(np.argmin(squares), 1, widths.size - 2))
        near = slice(best - 1, best + 2)
        if widths[best + 1] - widths[best - 1] < FINE * widths[best]:
            return widths[near], squares[near]
        widths = np.linspace(widths[best - 1], widths[best + 1], 9)


def turned(time: Samples, angle: Samples, rate: Samples, late: float) -> Turned:
    """What both sensors show of a segment, whose gyro is so `late` [s]."""
    known = ~np.isnan(angle) & ~np.isnan(rate)
    time, angle, rate = time[known], angle[known], rate[known]
    if time.size < 2:
        return Turned(time, angle, angle, np.empty((time.size, 0)), 0.0)
    rate = np.interp(time + late, time, rate)
    steps = np.diff(time) * (rate[1:] + rate[:-1]) / 2
    gyro = np.concatenate([np.zeros(1), np.cumsum(steps)])
    line = np.stack([np.ones_like(time), time], axis=1)
    gyro = gyro + line @ np.linalg.lstsq(line, angle - gyro, rcond=None)[0]
    waves = [wave(order * gyro) for order in (1, 2) for wave in (np.sin, np.cos)]
    knots = np.linspace(time[0], time[-1], int((time[-1] - time[0]) / KNOT) + 2)
    hats = [np.interp(time, knots, one) for one in np.eye(knots.size)]
    free, sizes = np.linalg.qr(np.stack([*hats, gyro, *waves, rate], axis=1))
    return Turned(time, angle - gyro, gyro, free, float(sizes[-1, -1]))


def lateness(pieces: list[Turned], width: float) -> float:
    """By how much later still the gyro is [s], where there is so much play."""
    found = 0.0
    for each in pieces:
        if each.time.size:
            missed = each.apart - lag_of(each, width)
            found += each.moves * float(each.free[:, -1] @ missed)
    return found / sum(each.moves**2 for each in pieces)


def left(piece: Turned, each: Table) -> Table:
    """Of some signals (sample, signal) what no other error of the sensors explains."""
    return each - piece.free @ (piece.free.T @ each)


def squares_of(piece: Turned, widths: Samples) -> Table:
    """The sum of squares that a play leaves: (width, how far it was passed at first)."""
    lag = lags(piece.angle, widths)
    missed = left(piece, piece.apart[:, None] - lag.reshape(lag.shape[0], -1))
    return np.sum(missed**2, axis=0).reshape(lag.shape[1:])


def lags(angle: Samples, widths: Samples) -> Table:
    """By how much an encoder is ahead: (sample, width, how far the play was passed at first)."""
    half = np.broadcast_to(widths[:, None] / 2, (widths.size, BEGINS.size))
    shown = np.empty((angle.size, *half.shape))
    now = angle[:1, None] + half * BEGINS
    for number, here in enumerate(angle):
        now = np.minimum(np.maximum(now, here - half), here + half)
        shown[number] = now
    return shown - angle[:, None, None]


def lag_of(piece: Turned, width: float) -> Samples:
    """The same of one width, and of how far it most likely was passed at first."""
    widths = np.array([width])
    begins = int(np.argmin(squares_of(piece, widths)))
    return lags(piece.angle, widths)[:, 0, begins]


def ahead(part: Pair, late: float, width: float) -> Samples:
    """By how much an encoder with such play is ahead of the leg, at every sample [rad]."""
    piece = turned(*part, late)
    if piece.time.size < 2:
        return np.zeros_like(part[0])
    return np.interp(part[0], piece.time, lag_of(piece, width))
