"""Candidates against each other: many of them, or many starts of one, where valleys differ."""

from functools import partial

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.cores.ahead import beside
from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.fitting.solve.program_cache import leave
from exoid.mismatch.evidence.measure import misfits
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.optimise import by_encoder, polished, settle_free, strikes
from exoid.mismatch.screen.prepared_recording import PreparedRecording

EARLY = 1.2  # s of every segment, in which starts race: later on valleys are narrower
HEAT, FINALISTS = 12, 2  # rounds of a race, and how many go on from the first instants


def raced(prepared: PreparedRecording, starts: list[Hypothesis], rival: Optimum) -> Optimum:
    """Running free from the best of several starts: all race along the first instants, the first of
    them along all that was seen, and the winner there goes on to the best of all.

    What strikes and sticks has many valleys, and a level that is far too low or too high leads into
    a false one. With every strike that went before, they grow narrower. What strikes is led by the
    encoder, and where it does no better by that than a `rival`, not far.
    """
    striking = any(map(strikes, starts))
    led = by_encoder(prepared) if striking else prepared.seen
    for seen, left in ((early(led), FINALISTS), (led, 1)):
        if len(starts) > left:
            known = left_by(rival, seen)
            heat = partial(settle_free, prepared, observation=seen, rounds=HEAT, rival=known)
            heats = sorted(side_by_side(heat, starts), key=left_of)
            starts = [one.candidate for one in heats[:left]]
            if striking and left == 1 and heats[0].square > known:
                return settle_free(prepared, starts[0], rounds=HEAT, rival=rival.square)
    return polished(prepared, starts[0], rival.square)


def left_by(one: Optimum, seen: Observation) -> float:
    """What its motion leaves of this observation."""
    return sum(float(left @ left) for channels in misfits(seen, one.motion) for left in channels)


def simulated(prepared: PreparedRecording, starts: list[Hypothesis], rival: float) -> list[Optimum]:
    """Running free, each from one start, as far as they come near what a rival leaves."""
    for one in reversed(starts):
        beside(leave, release, prepared, one)
    each = side_by_side(lambda start: polished(prepared, start, rival), starts)
    return [one for one in each if one.sound]


def left_of(one: Optimum) -> float:
    """Its sum of squares, of no use where it is not finite."""
    return one.square if np.isfinite(one.square) else np.inf


def early(seen: Observation) -> Observation:
    """Its first instants."""
    return seen.weighed(seen.time < seen.time[:, :1] + EARLY)
