"""That something strikes, which nothing of an explanation does: it stands in for what does."""

import numpy as np

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import strikes
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found
from exoid.mismatch.sensors.strikes import times_struck

OFTEN = 3  # strikes of a recording, from which on they are no accident


def struck(found: Found, best: Optimum) -> tuple[list[str], list[str]]:
    """Why nothing can be claimed where the gyro shows strikes, more than noise remains, and the
    best explanation has nothing that strikes, in a sentence; and what to record.
    """
    prepared = found.prepared
    often = strikes_of(prepared)
    if often < OFTEN or found.yardstick.explains(best.square) or strikes(best.candidate):
        return [], []
    each = [term for term in prepared.library if term.jumps]
    then = [f"To tell {term.title} apart: {term.isolated_by(prepared.moved)}." for term in each]
    return [of_strikes(often)], then


def strikes_of(prepared: PreparedRecording) -> int:
    """How often something strikes in all segments, by the gyro alone."""
    seen = prepared.seen
    each = map(np.asarray, (seen.time, seen.angular_velocity, seen.velocity_weight))
    return sum(times_struck(*rows) for rows in zip(*each, strict=True))


def of_strikes(often: int) -> str:
    """What was seen, and what that may be."""
    return (
        f"something strikes: {often} times the gyro's rate jumps within one sample, as where the "
        "play between leg and frame ends, or at a stop; what explains most has neither. What else "
        "is missing cannot be told beside that"
    )
