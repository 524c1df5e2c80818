"""A leg that its own reflex turns around in its first swing, and that then swings on freely.

A muscle throws the leg up and lets it fall at once; a hand that lifts it keeps it a moment at the
top. So at the top a thrown leg accelerates as the swings after it tell of a free one, and what a
hand carries does not.
"""

from dataclasses import replace

import numpy as np

from exoid.recordings.motion.acceleration import (
    EVERY,
    STRAIGHT,
    Derivatives,
    Law,
    law_of,
    smoothed_over,
)
from exoid.recordings.motion.signal import Signal, Speed
from exoid.recordings.motion.swings import Swings, outside, swung
from exoid.recordings.motion.thresholds import BLUR, CARRIED, EARLY, ROUGH, SURE, SWUNG_ON


def swung_freely(signal: Signal, speed: Speed, begin: int, free: int) -> Swings:
    """The swings from `begin` on; of a leg that a reflex threw up, those from the last top on."""
    seen = swung(signal, speed, begin, free)
    later, tops = since_thrown(seen)
    if not tops:
        return seen
    place = outside(later)
    last = len(later.at) - 1 if place is None else place - 1
    if last < SWUNG_ON:
        return seen
    # Its reflex may slow down the fall from the top once more.
    alone = slice(later.at[int(last > SWUNG_ON + 1)], later.at[last])
    return later if thrown(signal, alone, tops) else seen


def thrown(signal: Signal, alone: slice, tops: list[int]) -> bool:
    """Did the leg fall from all `tops` as in the samples in which it surely was `alone`?"""
    moves = [smoothed_over(signal.samples, width) for width in BLUR]
    laws = [(each, law_of([(each, alone)], told)) for told in (EVERY, STRAIGHT) for each in moves]
    return all(fallen_from(top, laws) for top in tops)


def fallen_from(top: int, laws: list[tuple[Derivatives, Law | None]]) -> bool:
    """By the shortest window that tells it; small swings tell it of a straight law only."""
    shares = (carried_at(moves, top, law) for moves, law in laws if law is not None)
    told = next((share for share in shares if share is not None), None)
    return told is not None and abs(told) < CARRIED


def since_thrown(seen: Swings) -> tuple[Swings, list[int]]:
    """The swings after the last top to which a reflex may have thrown the leg, and the samples of
    all such tops.
    """
    tops = []
    while (place := outside(seen)) is not None and place <= EARLY:
        top = place if seen.angle[place] > seen.angle[place - 1] else place - 1
        tops.append(seen.at[top])
        seen = since(seen, top)
    return seen, tops


def since(seen: Swings, top: int) -> Swings:
    """Those from a turning point on."""
    free = max(seen.bounds.free, seen.at[top])
    return Swings(seen.at[top:], seen.angle[top:], replace(seen.bounds, free=free))


def carried_at(moves: Derivatives, at: int, law: Law) -> float | None:
    """The share of the fall of this `law` that something keeps the leg from at a sample; None where
    its scatter hides it.
    """
    row = moves.table[at]
    pull = float(row @ law.numbers)
    unsure = SURE * float(np.sqrt(row @ law.scatter @ row)) + ROUGH * law.usual
    return 1 - float(moves.acceleration[at]) / pull if pull < -unsure else None
