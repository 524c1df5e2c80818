"""What is on a board, in words and numbers as people read them; nothing here loads JAX."""

from math import floor, isfinite, log10
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from exoid.watching.beside.goals import Goal
    from exoid.watching.beside.next_movement import Advice
    from exoid.watching.board import Board
    from exoid.watching.estimate.gyro_off import GyroOff
    from exoid.watching.estimate.moment import Quantity

DOING = ("held, or nobody knows", "at rest", "moving freely", "at rest, or caught")
LET_GO = "at rest: let it drop"
STARTING = "the estimator is loading; what moves meanwhile is kept and taken in afterwards"
AS_FAR = "learned as far as drops tell: the errors are still large, and no drop narrows them"
WAITING, LEARNING, ENOUGH, UNEXPLAINED = 0, 1, 3, 4  # trust
AT_REST, MOVING = 1, 2  # phases
UNSEEN = (
    "no drop was seen: a leg is seen to be let go where it was still for half a second, above "
    "where it hangs, or where a segment of a file begins"
)
LED = (
    "no drop counted: what began last at {:.1f} s was soon no free movement, as where a hand or a "
    "muscle leads the leg: let go of it at once, and have it relaxed"
)
DIAGNOSE = (
    "something is missing in the model: exoid diagnose tells what, of a recording of it (-o); then "
    "exoid live --with TERM"
)
BY_HAND = (
    "{} strayed in the first fall, as where a hand lets go slowly or a muscle leads the leg, be it "
    "through cycles: let go of it at once, and have it relaxed. exoid fit of a recording (-o) "
    "leaves such a fall out; exoid diagnose tells any other cause"
)
COUNTED = "; {} told {}"  # drops, and their numbers
BY_GYRO = (
    "gyro and encoder do not show one movement: the gyro shows {}. Check gain and filter of the "
    "gyro, and gain and times of the encoder; exoid fit of a recording (-o) tells what still holds"
)
OPEN = (2, ENOUGH)  # trusts that would say good, or enough, while a goal is open
DIGITS = 2  # of an error


def title(name: str) -> str:
    return name.replace("_", " ").replace(".", ": ")


def rounded(value: float, error: float) -> tuple[str, str]:
    """Both to two digits of the error."""
    if not error > 0:
        return f"{value:.4g}", f"{error:.2g}"
    places = max(0, DIGITS - 1 - floor(log10(error)))
    return f"{value:.{places}f}", f"{error:.{places}f}"


def stated(each: "Quantity") -> str:
    """As 27.32 ± 0.02 1/s^2."""
    return "{} ± {} ".format(*rounded(each.value, each.error)) + each.unit


def trust(board: "Board") -> str:
    """How far to believe it, in a sentence."""
    if board.spoiled is not None:
        return board.spoiled
    if board.fault is not None:
        return f"the estimator has failed: {' '.join(str(board.fault).split())}"
    if board.moment is None:
        return STARTING if board.state == "starting" else "waiting for the first sample"
    if board.silent:
        return f"nothing has come for {board.silent:.0f} s"
    if board.moment.trust in OPEN and (left := open_goals(board)):
        return f"not enough yet: {', '.join(map(str, left))} is still open"
    if int(board.moment.trust) == LEARNING and not narrows(board):
        return AS_FAR
    return board.moment.trust.words


def open_goals(board: "Board") -> list["Goal"]:
    """Those that are not reached."""
    each = ((goal, board.moment and goal.share(board.moment)) for goal in board.goals)
    return [goal for goal, share in each if share is None or share > 1.0]


def missing_goals(board: "Board") -> list["Goal"]:
    """Those of quantities that nobody knows yet, or that cannot be believed."""
    known = {each.name for each in quantities(board)}
    return [goal for goal in board.goals if goal.name not in known]


def unexplained(board: "Board") -> bool:
    """Does the model fail? Then no drop tells a number, and what agrees tells nothing."""
    return board.moment is not None and int(board.moment.trust) == UNEXPLAINED


def weight(board: "Board") -> str:
    """What is on the shank, where that can be told while it is followed."""
    found = board.weight
    return "" if found is None else f"{found.words} {'on' if found.on() else 'off'}"


def doing(board: "Board") -> str:
    """What the leg does, or that nothing more of it comes."""
    if board.over or board.moment is None:
        return board.over
    asks = int(board.moment.phase) == AT_REST and not enough(board) and not unexplained(board)
    return LET_GO if asks else DOING[int(board.moment.phase)]


def quantities(board: "Board") -> list["Quantity"]:
    """Those that can be believed."""
    if board.moment is None or board.spoiled is not None:
        return []
    return list(board.moment.quantities.values())


def progress(board: "Board", name: str) -> float | None:
    """How much of a goal is reached, 1 being all; None where the quantity is no goal."""
    goals = [goal for goal in board.goals if goal.name == name]
    if not goals or board.moment is None:
        return None
    share = goals[0].share(board.moment)
    return 0.0 if share is None else min(1.0, 1.0 / share) if share > 0 else 1.0


def wanted(board: "Board", name: str) -> str:
    """The error of a quantity that is a goal."""
    return next((f"± {goal.error}" for goal in board.goals if goal.name == name), "")


def enough(board: "Board") -> bool:
    """Is nothing left to do?"""
    sure = board.moment is not None and int(board.moment.trust) == ENOUGH
    return board.reached or (sure and not open_goals(board))


def next_movement(board: "Board") -> str:
    """What to do, while there is something left to do."""
    if unexplained(board):
        if board.gyro is not None:
            return by_gyro(board.gyro)
        return by_hand(board) if board.falls_astray else DIAGNOSE
    found = standing(board)
    if found is None or enough(board) or trust(board) == AS_FAR:
        return ""
    return found.words


def by_hand(board: "Board") -> str:
    """How many movements strayed, and what the drops that count had told before."""
    strayed, drops = len(board.left_out), board.ended
    if not drops:
        return BY_HAND.format("every movement")
    told = drops[-1].moment.quantities.values()
    counted = "the drop that counts" if len(drops) == 1 else f"the {len(drops)} drops that count"
    numbers = ", ".join(f"{title(each.name)} {stated(each)}" for each in told)
    said = BY_HAND.format(f"{strayed} of {strayed + len(drops)} movements")
    return said + (COUNTED.format(counted, numbers) if numbers else "")


def by_gyro(off: "GyroOff") -> str:
    """How it differs from the encoder."""
    percent = 100 * (off.scale - 1)
    more = "more" if percent > 0 else "less"
    scaled = f"a rate {abs(percent):.2g} % {more} than the encoder's" if percent else ""
    when = "later" if off.late > 0 else "earlier"
    late = f"the leg {1000 * abs(off.late):.2g} ms {when}" if off.late else ""
    return BY_GYRO.format(" and ".join(filter(None, [scaled, late])))


def standing(board: "Board") -> "Advice | None":
    """The advice, as long as the error that it begins from is the one that is shown."""
    found, moment = board.advice, board.moment
    return found if found is not None and (moment is None or found.holds(moment)) else None


def narrows(board: "Board") -> bool:
    """May another drop narrow the errors noticeably, as far as is known?"""
    found = standing(board)
    return found is None or found.movement is not None


def gain(board: "Board") -> str:
    """What that would bring."""
    found = standing(board)
    if found is None or found.movement is None or enough(board) or unexplained(board):
        return ""
    before, after = (f"{each:.2g}" for each in (found.before, found.after))
    return f"error of {title(found.name)} {before} → {after} {found.unit}"


def advice(board: "Board") -> str:
    """Both."""
    return ": ".join(filter(None, [next_movement(board), gain(board)]))


def batch(board: "Board") -> str:
    """What the fit of the finished drops says beside it."""
    if unexplained(board):
        return ""
    if board.unrefined is not None:
        return f"no fit of these drops: {board.unrefined}"
    found = board.refined
    if found is None:
        return ""
    far = max(map(abs, found.apart.values()))
    verdict = "agrees" if found.agrees else "DISAGREES"
    drops = "the drop" if found.drops == 1 else f"{found.drops} drops"
    return f"the fit of {drops} {verdict}: {far:.1f} standard errors apart at most"


def unseen(board: "Board") -> str:
    """Why there may be no drop, of a stream that is over and only waited for one."""
    if board.ended or board.moment is None or int(board.moment.trust) != WAITING:
        return ""
    return LED.format(board.moment.begun) if isfinite(board.moment.begun) else UNSEEN
