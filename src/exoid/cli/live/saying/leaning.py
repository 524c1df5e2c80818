"""What the numbers of a board lean on, in words: whose leg it is, and what no drop tells."""

from math import isfinite
from typing import TYPE_CHECKING

from exoid.cli.live.saying.words import quantities

if TYPE_CHECKING:
    from exoid.watching.board import Board

UNLIKE = (
    "by its motion this leg has J / (m l) = {:.3f} m, and {:.3f} ± {:.3f} m is expected: fewer "
    "than one in a thousand are as far off, so it is followed as any limb is, be it a stump, and "
    "no table counts. Check body mass, height and age, unit, zero and scale of the angle, the "
    "times, and that every mass on the leg is declared; a spring that is slack in a bent position "
    "looks like a shorter leg, too"
)
FOOT = (
    "± holds what no drop tells: where a foot puts the centre of mass (give "
    "thigh_angle_uncertainty_deg with it)"
)
BY_BOTH = f"{FOOT}, and a clock that may be what encoder and gyro disagree by (clock_uncertainty)"
BY_ANGLE = (
    f"{FOOT}; it takes times as true to 0.01 %, where no clock_uncertainty says more: a camera's "
    "may be percents off"
)


def unlike(board: "Board") -> str:
    """That it is none of its body's."""
    found = board.moment and board.moment.unlike
    if not found or not quantities(board):
        return ""
    return UNLIKE.format(found.length, found.expected, found.scatter)


def allowance(board: "Board") -> str:
    """What is in the errors beside what drops tell."""
    if not (quantities(board) and board.ended):
        return ""
    turning = any(isfinite(each.angular_velocity) for each in board.history)
    return BY_BOTH if turning else BY_ANGLE
