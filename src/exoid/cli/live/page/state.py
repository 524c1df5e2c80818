"""A board as the page gets it: all of it when it is opened, then what has changed."""

from typing import Any

from exoid.cli.live.saying import leaning, words
from exoid.cli.live.saying.changes import last_change
from exoid.cli.live.saying.json_lines import document, number
from exoid.cli.live.saying.movements import drops
from exoid.files.visible import visible
from exoid.watching.board import Board
from exoid.watching.estimate.known import ABSOLUTE, RATIOS
from exoid.watching.estimate.moment import Moment

CURVES = (*RATIOS, ABSOLUTE[0])  # in the order of the page's figures


def now(board: Board) -> dict[str, Any]:
    """This moment, in words and numbers."""
    moment = board.moment
    return {
        "moment": None if moment is None else document(moment),
        "swing": None if moment is None or not moment.believed else swing(moment),
        "trust": visible(words.trust(board)),
        "level": level(board),
        "doing": words.doing(board),
        "over": board.over,
        "stream": visible(board.stream),
        "drops": drops(board),
        "weight": words.weight(board),
        "next": raised(visible(words.advice(board))),
        "fit": checks(board),
        "rows": [
            *(row(board, each) for each in words.quantities(board)),
            *(unknown(board, each.name) for each in words.missing_goals(board)),
        ],
        "reached": board.reached,
        "ended": board.state in ("ended", "failed"),
    }


def checks(board: Board) -> str:
    """What holds of the numbers: since when they are others, and what a fit says."""
    fit = "; ".join(filter(None, [visible(words.batch(board)), leaning.if_slack(board)]))
    of_mass = leaning.misplaced(board)
    return ". ".join(filter(None, [raised(last_change(board)), of_mass, fit]))


def raised(words: str) -> str:
    """With powers as a page can write them."""
    return words.replace("^2", "²").replace("^3", "³")


def level(board: Board) -> str:
    """How to colour what is said of trust."""
    if board.spoiled or board.fault or board.silent:
        return "bad"
    if board.moment is None:
        return "none"
    return ("none", "none", "good", "good", "bad", "care", "bad")[int(board.moment.trust)]


def swing(moment: Moment) -> list[float | None]:
    """The ratios by which the leg swings that is seen, with what is on it."""
    return [number(each.value) for each in moment.as_loaded]


def row(board: Board, each) -> dict[str, Any]:
    value, error = words.rounded(each.value, each.error)
    return {
        "name": words.title(each.name),
        "value": value,
        "error": error,
        "unit": raised(each.unit),
        "goal": words.progress(board, each.name),
        "wanted": words.wanted(board, each.name),
    }


def unknown(board: Board, name: str) -> dict[str, Any]:
    """A goal that nobody knows yet."""
    said = {"name": words.title(name), "value": "-", "error": "-", "unit": ""}
    return {**said, "goal": words.progress(board, name), "wanted": words.wanted(board, name)}


def past(board: Board) -> list[list[Any]]:
    """Time, then value and error of each curve, of moments in which they could be believed."""
    return [point(each) for each in board.history if each.believed]


def point(moment: Moment) -> list[Any]:
    """Null where nothing tells a quantity yet."""
    found: list[Any] = [round(moment.time, 2)]
    for name in CURVES:
        known = moment.quantities.get(name)
        found += [None, None] if known is None else [number(known.value), number(known.error)]
    return found
