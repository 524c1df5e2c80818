"""What is left on data that the fit has not seen."""

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.physics.library import library
from exoid.physics.term import name_of
from exoid.report.words.text import causes_in_words, in_degrees

MOVING = {name_of(term) for term in library() if term.moves_zero}


def remains(found: Diagnosis) -> str:
    """What is left on data that the fit has not seen, beside what was there before."""
    shown = found.proof
    before, after = in_degrees(shown.before.total), in_degrees(shown.after.total)
    times = f"{shown.after.total / shown.noise_floor:.1f} times the noise floor"
    if not found.changed:
        return f"held-out angle RMSE {after} deg, {times}."
    parts = "quarters of the recording" if shown.in_time else "segments"
    return (
        f"held-out angle RMSE {before} -> {after} deg{by_what(found)}, {left_over(found)}{times} "
        f"({shown.better} of {shown.after.squares.size} {parts} better, {from_what(found)})."
    )


def from_what(found: Diagnosis) -> str:
    """What is held out was predicted from what, and what of it was not."""
    shown = found.proof
    if shown.in_time or shown.after.squares.size > 2 or MOVING.isdisjoint(found.best.terms):
        return "each from the others"
    return (
        "each from the other but for its own zero: by how much that moves between two segments, "
        "one alone does not tell"
    )


def by_what(found: Diagnosis) -> str:
    """Which explanation leaves it, where the answer names none."""
    if found.verdict == "mismatch" or not found.changed:
        return ""
    return f" with {causes_in_words(found.best.terms)}"


def left_over(found: Diagnosis) -> str:
    share = share_left(found)
    if share is not None and share > 1:
        return "worse than without it; "
    return "" if share is None else f"{share:.0%} of the squares that were missing; "


def share_left(found: Diagnosis) -> float | None:
    """The share of what was missing over the noise, in squares, that still is."""
    shown = found.proof
    missing = shown.before.total**2 - shown.noise_floor**2
    if missing <= 0:
        return None
    return max(shown.after.total**2 - shown.noise_floor**2, 0.0) / missing
