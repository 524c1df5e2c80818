"""What a person sees while something is recorded: a live line on a terminal, and sentences.

Where nobody can be told any more, because the terminal or the pipe is gone, what runs goes on.
"""

import sys
from contextlib import suppress
from typing import Any, Self

from exoid.cli.terminal.say import say
from exoid.files.visible import visible

NOBODY = (OSError, SystemExit)  # how streams, and rich, say that a terminal or a pipe is gone


class Screen:
    """Writes to stderr; the line is only there, and only moves, where that is a terminal."""

    def __init__(self):
        self.live: Any = None

    def __enter__(self) -> Self:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.live import Live

            self.live = Live(console=Console(stderr=True), auto_refresh=False, transient=True)
            self.live.start()
        return self

    def __exit__(self, *_) -> None:
        if self.live is not None:
            with suppress(*NOBODY):
                self.live.stop()

    def tell(self, sentence: str) -> None:
        """Say something that stays."""
        with suppress(*NOBODY):
            if self.live is None:
                say(f"exoid: {sentence}", err=True)
            else:
                self.live.console.print(
                    visible(f"exoid: {sentence}"), markup=False, highlight=False
                )

    def show(self, line: str) -> None:
        """Replace the live line."""
        if self.live is not None:
            from rich.text import Text

            with suppress(*NOBODY):
                self.live.update(
                    Text(visible(line), no_wrap=True, overflow="ellipsis"), refresh=True
                )
