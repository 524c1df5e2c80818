"""What holds a leg at rest, again from where others of its kind came to."""

from dataclasses import replace

import numpy as np

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FLOOR, LOWER, settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found, best_of
from exoid.mismatch.search.race import left_of
from exoid.mismatch.search.rank import by_evidence
from exoid.physics.parameter import declarations
from exoid.physics.term import holds

TIMES = 4  # rounds at most


def exchanged(found: Found) -> Found:
    """The same with every single cause that holds the leg begun again from the best other one's
    leg, until none falls further.

    A leg that sticks a step later jumps: a search stops in one of many creases, and in which hangs
    on rounding. A law of friction that holds all of another one's then ends far above it.
    """
    prepared, singles = found.prepared, found.singles
    for _ in range(TIMES):
        held = sorted((one for one in singles if holds_alone(prepared, one)), key=left_of)
        if len(held) < 2 or held[0].square <= FLOOR * prepared.samples:
            break
        begun = [(held[0], held[1]), *((one, held[0]) for one in held[1:])]
        ended = side_by_side(lambda both: begun_again(prepared, *both), begun)
        singles = best_of([*singles, *ended])
        if not any(
            new.square < LOWER * old.square for new, (old, _) in zip(ended, begun, strict=True)
        ):
            break
    measure = yardstick(prepared, min((found.base, *singles), key=left_of))
    return replace(found, singles=by_evidence(singles, found.base, measure), yardstick=measure)


def holds_alone(prepared: PreparedRecording, one: Optimum) -> bool:
    """Is it a single cause, and holds the leg?"""
    added = one.candidate.terms[len(prepared.common) :]
    return len(added) == 1 and holds(added[0])


def begun_again(prepared: PreparedRecording, one: Optimum, other: Optimum) -> Optimum:
    """From the other's leg, with its own values and with the other's of what both declare."""
    mine, theirs = (
        dict(
            zip(
                dict(declarations(each.candidate.terms[-1])), each.candidate.values[-1], strict=True
            )
        )
        for each in (one, other)
    )
    shared = {name: theirs.get(name, value) for name, value in mine.items()}
    starts = [with_leg(one.candidate, other.candidate, values) for values in (mine, shared)]
    return min((settle_free(prepared, start) for start in starts), key=left_of)


def with_leg(one: Hypothesis, other: Hypothesis, values: dict[str, float]) -> Hypothesis:
    """The candidate on the other's leg, its last term with these values."""
    moved = (*one.values[:-1], np.array([*values.values()]))
    return replace(one, point=other.point, zero=other.zero, values=moved, linear=None)
