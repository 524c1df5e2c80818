"""That something strikes, which nothing of an explanation does: it stands in for what does."""

from exoid.mismatch.flight.accelerations import strikes_of
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import strikes
from exoid.mismatch.search.found import Found

OFTEN = 3  # strikes of a recording, from which on they are no accident


def struck(found: Found, best: Optimum) -> tuple[list[str], list[str]]:
    """Why nothing can be claimed where the gyro shows strikes, more than noise remains, and the
    best explanation has nothing that strikes, in a sentence; and what to record.
    """
    prepared = found.prepared
    often = sum(each.size for each in strikes_of(prepared))
    if often < OFTEN or found.yardstick.explains(best.square) or strikes(best.candidate):
        return [], []
    each = [term for term in prepared.library if term.jumps]
    then = [f"To tell {term.title} apart: {term.isolated_by(prepared.moved)}." for term in each]
    return [of_strikes(often)], then


def of_strikes(often: int) -> str:
    """What was seen, and what that may be."""
    return (
        f"something strikes: {often} times the gyro's rate jumps within one sample, as where the "
        "play between leg and frame ends, or at a stop; what explains most has neither. What else "
        "is missing cannot be told beside that"
    )
