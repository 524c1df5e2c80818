"""A candidate from many starts at once, where they lead into different valleys."""

from functools import partial

import numpy as np

from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import ROUNDS, by_encoder, polished, settle_free, strikes
from exoid.mismatch.screen.prepared_recording import PreparedRecording

HEAT, FINALISTS = 10, 2  # rounds in which starts race, and how many of them go on


def raced(prepared: PreparedRecording, starts: list[Hypothesis]) -> Optimum:
    """Running free from the best of several starts: all go a few rounds, the first of them to an
    end, and the winner there on to the best of all.

    What strikes and sticks has many valleys, and a level that is far too low or too high leads into
    a false one.
    """
    for rounds, left in ((HEAT, FINALISTS), (ROUNDS, 1)):
        if len(starts) > left:
            heats = side_by_side(partial(heat, prepared, rounds), starts)
            heats.sort(key=lambda one: one.square if np.isfinite(one.square) else np.inf)
            starts = [one.candidate for one in heats[:left]]
    return polished(prepared, starts[0])


def heat(prepared: PreparedRecording, rounds: int, start: Hypothesis) -> Optimum:
    """A few rounds from a start, led by what leads past walls."""
    led = by_encoder(prepared) if strikes(start) else None
    return settle_free(prepared, start, led, rounds=rounds)
