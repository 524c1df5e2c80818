"""A leg that does not fall from rest, but pushed, or led: what is told without a model."""

from math import degrees, hypot, log, pi, radians

import numpy as np

from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.measure import Measure, NotAllowed
from exoid.recordings.landmarks.release import Release
from exoid.recordings.landmarks.track import Peak

SURE = 2.0  # errors beyond what a leg does from rest, which does 0.75 of it on average, seldom 0.95
SWINGS = 4  # half swings, at most, that tell how fast a leg swings
LED = radians(1.5)  # by which it moves before it is let go: of 300 legs that a hand let go at most
# 1.0, of 11 on a support that sinks under them ever faster, and is left late, at least 2.6
AGO, ABOUT = 0.2, 0.05  # s before the release, and around that


def of_lead(drop: Landmarks) -> str | None:
    """That a leg has already gone far where it begins to fall freely; None of one that has not."""
    if not isinstance(drop.released, Release):
        return None
    start, track = drop.released.start, drop.track
    before = track.angle[np.abs(track.time - (start.time - AGO)) <= ABOUT]
    if not before.size:
        return None
    gone = float(before.mean()) - start.value
    if gone - SURE * hypot(start.error, track.noise / before.size**0.5) < LED:
        return None
    return (
        f"it goes down by {degrees(gone):.1f} deg in the {AGO:g} s before it falls freely, as "
        "where a hand or a support goes along with it: start angle, A1 and indices are of there, "
        "not of where it was held. Let go at once"
    )


def of_push(drop: Landmarks, measures: dict[str, Measure]) -> str | None:
    """What to say of a leg that falls faster than from rest; None of one that may fall so.

    What swings a leg, gravity and springs, pulls in proportion to how far it is from its rest, or
    less: gravity bends. So a leg that is let go at rest accelerates by what its swings tell, at
    most: (omega^2 + lambda^2) (phi_start - phi_rest), and damping only takes from that.
    """
    found = measures["peak_flexion_acceleration"]
    most = greatest(drop)
    if most is None or found.value is None or found.standard_error is None:
        return None
    value, error = most
    if found.value - value < SURE * hypot(found.standard_error, error):
        return None
    return (
        f"in its first flexion the leg accelerates by {degrees(found.value):.0f} deg/s^2, and one "
        f"of its period that is let go at rest from there by {degrees(value):.0f} at most: it was "
        "pushed, a muscle or tight tissue draws it down there, or a filter makes its angle "
        "overshoot. ± does not hold what that adds to the first flexion, the relaxation index, "
        "peak velocities and accelerations. See that it is let go without a push"
    )


def greatest(drop: Landmarks) -> tuple[float, float] | None:
    """What a leg that swings so accelerates by at most from rest, and its error [rad/s^2]; None
    where too few swings tell, or a stop shortened them.
    """
    try:
        start, rest = drop.release.start, drop.expected_rest
    except NotAllowed:
        return None
    turns = drop.turns[: SWINGS + 1]
    count = len(turns) - 1
    if count < 1 or len(drop.free_turns) < len(drop.turns) or start.value <= rest.value:
        return None
    lasting = (turns[-1].time - turns[0].time) / count
    late = hypot(turns[-1].time_error, turns[0].time_error) / count
    stiffness = (pi**2 + lost(start, turns) ** 2) / lasting**2
    apart = start.value - rest.value
    unsure = hypot(2 * late / lasting * apart, start.error, rest.error)
    return stiffness * apart, stiffness * unsure


def lost(start: Peak, turns: list[Peak]) -> float:
    """Of the log of a swing from each to the next, on average over them."""
    first, last = start.value - turns[0].value, abs(turns[-1].value - turns[-2].value)
    return log(first / last) / (len(turns) - 1)
