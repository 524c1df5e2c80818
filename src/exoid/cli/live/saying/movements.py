"""The movements of a stream in words: drops that count, and what is left out, with the reason."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from exoid.cli.live.saying.changes import change
from exoid.cli.live.saying.words import MOVING, stated, title

if TYPE_CHECKING:
    from exoid.watching.board import Board, Ended
    from exoid.watching.estimate.left_out import LeftOut

MOST = 6  # movements that are named in a line


def movement(each: "Ended | LeftOut") -> str:
    """As it became clear what it was."""
    from exoid.watching.board import Ended

    return drop(each) if isinstance(each, Ended) else left(each)


def drop(ended: "Ended") -> str:
    """A drop that has ended, and what was known then, or why no number was."""
    moment = ended.moment
    loaded = f" with {ended.weight:g} kg" if ended.weight else ""
    head = f"{moment.time:.1f} s, drop {moment.drops}{loaded}"
    known = "; ".join(f"{title(each.name)} {stated(each)}" for each in moment.quantities.values())
    part = f"{moment.begun:.1f} to {ended.until:.1f} s"
    return f"{head}: {known}" if known else f"{head} counts from {part}; then {moment.trust.words}"


def changed(each: "Ended | LeftOut") -> str:
    """That the numbers are others from this drop on."""
    from exoid.watching.board import Ended

    if not isinstance(each, Ended):
        return ""
    said = change(each.moment, each.moment.drops)
    return said and f"{each.moment.time:.1f} s, {said}"


def left(each: "LeftOut") -> str:
    return f"{each.time:.1f} s, left out: what began at {each.begun:.1f} s: {each.why}"


def ended(board: "Board") -> str:
    """On how many drops that have ended the numbers rest."""
    return f"{len(board.ended)} drop{'' if len(board.ended) == 1 else 's'}"


def others(board: "Board") -> str:
    """How many movements beside those do not count."""
    count = len({each.begun for each in board.left_out})
    return f", {count} left out" if count else ""


def drops(board: "Board") -> str:
    return f"{ended(board)} so far{others(board)}"


def all_drops(board: "Board") -> str:
    """The drops of a stream that is over: one that still moves then is in the numbers, too."""
    if board.moment is None or int(board.moment.phase) != MOVING:
        return drops(board)
    return f"{ended(board)}{others(board)}, and one that still moved at the end"


def left_out(board: "Board") -> Iterator[str]:
    """A line for every reason, with the movements that it holds for."""
    for why in dict.fromkeys(each.why for each in board.left_out):
        begun = [f"{each.begun:.1f} s" for each in board.left_out if each.why == why]
        more = [f"{len(begun) - MOST} more"] if len(begun) > MOST else []
        yield f"left out: what began at {', '.join(begun[:MOST] + more)}: {why}"
