"""The movements of a stream in words: drops that count, and what is left out, with the reason."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from exoid.cli.live.saying.words import stated, title

if TYPE_CHECKING:
    from exoid.watching.board import Board, Ended
    from exoid.watching.estimate.left_out import LeftOut


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


def left(each: "LeftOut") -> str:
    return f"{each.time:.1f} s, left out: what began at {each.begun:.1f} s: {each.why}"


def left_out(board: "Board") -> Iterator[str]:
    """A line for every reason, with the movements that it holds for."""
    for why in dict.fromkeys(each.why for each in board.left_out):
        begun = ", ".join(f"{each.begun:.1f} s" for each in board.left_out if each.why == why)
        yield f"left out: what began at {begun}: {why}"
