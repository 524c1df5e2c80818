"""What the numbers of a board lean on, in words: whose leg it is, and what no drop tells."""

from math import isfinite
from typing import TYPE_CHECKING

from exoid.cli.live.saying.words import MOVING, quantities, title
from exoid.fitting.model.systematics import DAMPING_UNDER_LOAD, STIFFNESS_UNDER_LOAD

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
MISPLACED = (
    "the declared distance of the added mass {} how the leg moves: it acts as one at {:.3g} m from "
    "the knee, where {:.3g} m is declared. Measure from the axis of the knee to the middle of the "
    "mass. The ratios to J hold; {}"
)
AGREES = {True: "does not agree with", False: "hardly agrees with"}
TELLS = {
    False: "J, and what goes with it, is not told",
    True: "± of J, and of what goes with it, holds that the distance may be centimetres off",
}
IF_SLACK = "{}, where the knee's spring is slack elsewhere than at full extension"
UNDER_LOAD = (
    ", and how much damping and stiffness change under the added mass, "
    f"{100 * DAMPING_UNDER_LOAD:.0f} and {100 * STIFFNESS_UNDER_LOAD:.0f} % where no "
    "damping_under_load_uncertainty or stiffness_under_load_uncertainty says more"
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


def misplaced(board: "Board") -> str:
    """That what is on it does not hang where it is declared."""
    found = board.moment and board.moment.misplaced
    if not found or not quantities(board):
        return ""
    told = any(each.name == "inertia" for each in quantities(board))
    return MISPLACED.format(AGREES[found.strange], found.acts, found.declared, TELLS[told])


def allowance(board: "Board") -> str:
    """What is in the errors beside what drops tell."""
    if not (quantities(board) and board.ended):
        return ""
    turning = any(isfinite(each.angular_velocity) for each in board.history)
    of_drops = BY_BOTH if turning else BY_ANGLE
    return f"{of_drops}{UNDER_LOAD}" if any(each.weight for each in board.ended) else of_drops


def open_if_slack(board: "Board") -> str:
    """What errors the knee's spring adds where it is slack elsewhere: what the stream leaves open,
    or the batch fit where that tells it.
    """
    if board.moment is None or not (board.moment.drops or moving(board)):
        return ""
    fitted = {} if board.refined is None else board.refined.if_slack
    each = ((one, fitted.get(one.name, one.if_slack)) for one in quantities(board))
    return ", ".join(
        f"± {more:.2g} {one.unit} more of {title(one.name)}"
        for one, more in each
        if more is not None
    )


def moving(board: "Board") -> bool:
    return board.moment is not None and int(board.moment.phase) == MOVING


def settled(board: "Board") -> str:
    """The same between movements: amid one, every sample changes it."""
    return "" if moving(board) else open_if_slack(board)


def if_slack(board: "Board") -> str:
    """The same in a sentence."""
    found = open_if_slack(board)
    return found and IF_SLACK.format(found)
