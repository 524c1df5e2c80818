"""Where a board is shown: the page, the panel or its lines, and a file of JSON lines."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from exoid.cli.live.panel import Panel
from exoid.cli.live.saying.json_lines import STDOUT, JsonLines
from exoid.watching.board import Board
from exoid.watching.estimate.moment import Sink


@dataclass(frozen=True)
class Views:
    """What was asked for."""

    json_lines: Path | None
    serve: bool
    host: str
    port: int

    @property
    def err(self) -> bool:
        """Does stdout belong to another program?"""
        return self.json_lines == STDOUT


@dataclass(frozen=True)
class Viewer:
    """The panel, and who gets every moment."""

    panel: Panel
    lines: JsonLines | None

    @property
    def sinks(self) -> tuple[Sink, ...]:
        return () if self.lines is None else (self.lines,)

    @property
    def lost(self) -> bool:
        """Is anything that was to be written not there?"""
        return self.lines is not None and self.lines.lost


@contextmanager
def paged(board: Board, name: str, views: Views) -> Iterator[str | None]:
    """The address of the page, as long as it is there; None where none was asked for.

    **Raises** `ValueError` where it cannot be served.
    """
    if not views.serve:
        yield None
        return
    from exoid.cli.live.page.serve import listening_on, serving

    with serving(board, name, listening_on(views.host, views.port), views.host) as address:
        yield address


@contextmanager
def viewing(board: Board, name: str, views: Views, address: str | None) -> Iterator[Viewer]:
    """Panel and lines until the end, and the address of the page."""
    with ExitStack() as inside:
        lines = None
        panel = Panel(board, name)
        if views.json_lines is not None:
            lines = JsonLines(views.json_lines, panel.tell)
            inside.callback(lines.close)
        inside.enter_context(panel)
        if address is not None:
            panel.tell(f"the page: {address}")
        yield Viewer(panel, lines)
