"""A board as a panel on a terminal; where there is none, a line for whatever is new."""

import time
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from exoid.cli.live.saying import leaning, words
from exoid.cli.live.saying.movements import changed, drops, movement
from exoid.cli.terminal.say import say
from exoid.cli.terminal.screen import NOBODY, Screen
from exoid.files.visible import visible

if TYPE_CHECKING:
    from exoid.watching.board import Board

EVERY = 0.1  # s between two drawings, at least
ROWS = 7  # of the table: a panel that grows and shrinks is not calm
BAR = 8  # letters
CALM = {3: "green", 2: "green", 4: "red", 5: "yellow", 6: "red"}  # by trust


class Panel(Screen):
    """Shows the board on stderr; `name` is what is followed."""

    def __init__(self, board: "Board", name: str):
        super().__init__()
        self.board, self.name = board, name
        self.drawn = 0.0
        self.said: dict[str, str] = {}
        self.told = 0  # movements

    def show(self, line: str) -> None:
        """How the stream is at this moment; the rest is on the board."""
        self.board.stream = line
        now = time.monotonic()
        if now < self.drawn + EVERY:
            return
        self.drawn = now
        with suppress(*NOBODY):
            self.say_movements()
            if self.live is None:
                self.say_news()
            else:
                self.live.update(drawing(self.board, self.name), refresh=True)

    def say_movements(self) -> None:
        """Those that have ended since; a panel shows the numbers, and what has changed stays."""
        movements = self.board.movements
        for each in movements[self.told :]:
            if self.live is None:
                say(f"exoid: {movement(each)}", err=True)
            if (other := changed(each)) != "":
                self.tell(other)
        self.told = len(movements)

    def say_news(self) -> None:
        """What has changed since it was said last."""
        news = {
            "trust": words.trust(self.board)
            if not self.board.silent
            else self.said.get("trust", ""),
            "next": words.advice(self.board),
            "fit": words.batch(self.board),
            "if slack": leaning.settled(self.board),
        }
        for key, line in news.items():
            if line and line != self.said.get(key):
                now = "" if self.board.moment is None else f"{self.board.moment.time:.1f} s, "
                say(f"exoid: {now}{key}: {line}", err=True)
                self.said[key] = line


def drawing(board: "Board", name: str) -> Any:
    """The panel."""
    from rich import box
    from rich.console import Group
    from rich.panel import Panel as Frame
    from rich.text import Text

    color = "dim" if board.moment is None else CALM.get(int(board.moment.trust), "default")
    if board.spoiled is not None or board.fault is not None or board.silent:
        color = "red"
    lines = [
        Text(visible(board.stream), no_wrap=True, overflow="ellipsis"),
        Text.assemble((words.doing(board) or " ", "bold"), "   ", drops(board), weight(board)),
        Text(visible(words.trust(board)), style=color, no_wrap=True, overflow="ellipsis"),
        Text(),
        table(board),
        Text(),
        labelled("next", words.next_movement(board)),
        labelled("", words.gain(board)),
        labelled("check", words.batch(board)),
        labelled("slack", leaning.open_if_slack(board)),
    ]
    where = Text(visible(f"exoid live  {name}"))
    return Frame(
        Group(*lines),
        title=where,
        title_align="left",
        box=box.ROUNDED,
        border_style="dim",
        padding=(0, 1),
        width=WIDTH,
    )


WIDTH = 82  # letters, on a terminal that has them


def weight(board: "Board") -> str:
    said = words.weight(board)
    return f"   {said} (key w)" if said else ""


def labelled(label: str, text: str) -> Any:
    from rich.text import Text

    line = Text(no_wrap=True, overflow="ellipsis")
    line.append(f"{label:7}", style="dim")
    line.append(visible(text) or ("-" if label else ""), style="" if text else "dim")
    return line


def table(board: "Board") -> Any:
    """The quantities, as many as fit, and blank rows where there are fewer."""
    from rich.table import Table

    shown = Table(box=None, padding=(0, 1, 0, 0), pad_edge=False)
    shown.add_column("", min_width=22, no_wrap=True)
    for head in ("value", "± error"):
        shown.add_column(head, justify="right", min_width=9, no_wrap=True)
    shown.add_column("unit", min_width=8, no_wrap=True)
    shown.add_column("of it", justify="right", min_width=8, no_wrap=True)
    shown.add_column("goal" if board.goals else "", min_width=BAR + 6, no_wrap=True)
    missing = words.missing_goals(board)[:ROWS]
    found = words.quantities(board)[: ROWS - len(missing)]
    for each in found:
        value, error = words.rounded(each.value, each.error)
        share = f"{100 * each.error / abs(each.value):.2g} %" if each.value else ""
        shown.add_row(words.title(each.name), value, error, each.unit, share, bar(board, each.name))
    for goal in missing:
        shown.add_row(words.title(goal.name), "-", "-", "", "", bar(board, goal.name))
    for _ in range(ROWS - len(found) - len(missing)):
        shown.add_row("", "", "", "", "", "")
    return shown


def bar(board: "Board", name: str) -> str:
    reached = words.progress(board, name)
    if reached is None:
        return ""
    full = int(BAR * reached)
    return f"{'━' * full}{'╌' * (BAR - full)} {words.wanted(board, name)}"
