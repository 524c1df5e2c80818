"""What a person sees while something is recorded: a live line on a terminal, and sentences."""

import sys
from typing import Any

from exoid.cli.terminal.say import say
from exoid.files.visible import visible


class Screen:
    """Writes to stderr; the line is only there, and only moves, where that is a terminal."""

    def __init__(self):
        self.live: Any = None

    def __enter__(self) -> "Screen":
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.live import Live

            self.live = Live(console=Console(stderr=True), auto_refresh=False, transient=True)
            self.live.start()
        return self

    def __exit__(self, *_) -> None:
        if self.live is not None:
            self.live.stop()

    def tell(self, sentence: str) -> None:
        """Say something that stays."""
        if self.live is None:
            say(f"exoid: {sentence}", err=True)
        else:
            self.live.console.print(visible(f"exoid: {sentence}"), markup=False, highlight=False)

    def show(self, line: str) -> None:
        """Replace the live line."""
        if self.live is not None:
            from rich.text import Text

            self.live.update(Text(visible(line), no_wrap=True, overflow="ellipsis"), refresh=True)
