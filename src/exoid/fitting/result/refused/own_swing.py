"""What a swing shows of itself, without a fit and its limits: what draws a leg that was let go.

The equation of motion in its weak form over short windows (`balance`) is linear in what draws the
leg, phi'' = -a cos(phi) - b sin(phi) - k phi - t - d phi', so that least squares tell whether these
explain all of it. Where they do not, as with dry friction, a hand or a sensor that drifts, nothing
follows.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.recordings.conventions.balance import weak_form

LEVEL = 1e-4  # of the squares of the acceleration that a spring leaves: beside gravity it is 5e-4
SMOOTH = 3e-3  # the same of all three: noise of an encoder, and a hand that was slow to let go
ROUGH = 0.1  # the same of what tells at least how fast it is
ALONE = 1e-3  # the same of a single drop
FEWEST = 12  # windows
UP = np.radians(20.0)  # a muscle, or a zero that is off, holds a leg as high as level at most
PENDULUM = [1, 2, 3]  # columns: gravity, from wherever it comes, and damping
SPRING = [4, 5, 3]  # a spring, wherever it is slack, and damping
BOTH = [1, 2, 4, 5, 3]


@dataclass(frozen=True)
class OwnSwing:
    """How a leg is drawn that was let go."""

    pull: float  # 1/s^2, by which it is drawn back: of Eq. 9 about (m l g + c) / J
    smooth: bool  # do gravity, a spring and damping explain all of it?
    rough: bool  # do they explain most of it?
    level: bool  # does a spring alone, so that gravity does not turn the leg?


def own_swing(movements: Sequence[Movement]) -> OwnSwing | None:
    """By regression over all that were let go without a load; None where they tell too little."""
    rows = [free_rows(each) for each in movements if each.kind == "passive" and not each.added_mass]
    found = np.concatenate(rows) if rows else np.empty((0, len(BOTH) + 1))
    if found.shape[0] < FEWEST:
        return None
    (_, (a, b, _)), (spring, _), (both, _) = (left_by(found, of) for of in (PENDULUM, SPRING, BOTH))
    return OwnSwing(
        float(np.hypot(a, b)), smooth=both < SMOOTH, rough=both < ROUGH, level=spring < LEVEL
    )


def rests(movements: Sequence[Movement]) -> dict[str, float]:
    """About which angle [rad] each swings that was let go without a load, where its swing tells it:
    by its name.
    """
    found = {}
    for each in movements:
        rows = free_rows(each) if each.kind == "passive" and not each.added_mass else np.empty((0,))
        if rows.shape[0] >= FEWEST and left_by(rows, BOTH)[0] < ALONE:
            a, b, _ = left_by(rows, PENDULUM)[1]
            found[each.name] = float(np.arctan2(-a, b))
    return found


def hangs_up(movements: Sequence[Movement]) -> bool:
    """Does a leg that was let go swing about a place above the level of its knee?"""
    found = rests(movements)
    return bool(found) and all(angle > UP for angle in found.values())


def free_rows(each: Movement) -> np.ndarray:
    """The weak form of what counts of a movement."""
    counts = slice(each.late, each.kept)
    time, angle = each.segment.time[counts], each.angle[counts]
    seen = np.isfinite(angle)
    return weak_form(time[seen], angle[seen])


def left_by(rows: np.ndarray, columns: Sequence[int]) -> tuple[float, np.ndarray]:
    """What share of the acceleration's squares these leave, and what they are."""
    wanted = rows[:, 0]
    found = np.linalg.lstsq(rows[:, columns], wanted)[0]
    missed = wanted - rows[:, columns] @ found
    return float(missed @ missed / (wanted @ wanted)), found
