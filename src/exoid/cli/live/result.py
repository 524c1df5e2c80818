"""What a person is left with when what was followed has ended."""

from typing import TYPE_CHECKING

import typer

from exoid.cli.live.saying import leaning, words
from exoid.cli.live.saying.changes import last_change
from exoid.cli.live.saying.movements import all_drops, left_out
from exoid.cli.terminal.say import say

if TYPE_CHECKING:
    from exoid.watching.board import Board

NAMES, NUMBERS = 26, 12  # letters of a column


def give(board: "Board", *, err: bool) -> None:
    """The last of it, on stdout, or on stderr where that is another's.

    **Raises** what ended the estimator.
    """
    if board.fault is not None:
        raise board.fault
    say(*lines(board), err=err)
    if board.goals:
        say(verdict(board), err=err)


def judge(board: "Board", *, lost: bool) -> None:
    """**Raises** `typer.Exit` with 1 where goals were not reached, nothing of the stream could be
    believed, or lines that were asked for are `lost`.
    """
    if lost or board.spoiled is not None or (board.goals and not board.reached):
        raise typer.Exit(1)


def lines(board: "Board") -> list[str]:
    """The quantities, and how far to believe them."""
    found = [
        f"{words.title(each.name):{NAMES}}{value:>{NUMBERS}} ± {error:<{NUMBERS}}{each.unit}"
        for each in words.quantities(board)
        for value, error in [words.rounded(each.value, each.error)]
    ]
    seconds = "" if board.moment is None else f"{board.moment.time:.1f} s, {all_drops(board)}; "
    said = [f"{seconds}{words.trust(board)}"]
    said += [*filter(None, [last_change(board)]), *left_out(board), *found]
    of_leg = words.unseen, leaning.unlike, leaning.misplaced
    beside = *of_leg, leaning.allowance, words.batch, leaning.if_slack
    said += filter(None, (each(board) for each in beside))
    if (then := words.advice(board)) != "":
        said.append(f"next: {then}")
    return said


def verdict(board: "Board") -> str:
    """Was it enough?"""
    goals = ", ".join(map(str, board.goals))
    if board.reached:
        return f"enough: {goals} is reached"
    parts = []
    for goal in board.goals:
        share = None if board.moment is None else goal.share(board.moment)
        known = "it is not known" if share is None else f"its error is {share:.2g} times that"
        parts.append(f"{goal}: {known}")
    return f"not enough yet: {'; '.join(parts)}"
