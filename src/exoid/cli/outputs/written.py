"""Files that a command was asked for: each written by itself, so that none is lost with another."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import typer

from exoid.cli.terminal.faults import explain
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

Result = TypeVar("Result")


class Outputs:
    """Writes what was asked for, tells every failure at once, and ends the command by them."""

    def __init__(self) -> None:
        self.failed = False
        self.ours: Exception | None = None  # a fault of exoid, to be raised when all is written

    def put(self, path: Path | None, write: Callable[[Path], Any], what: str = "writing") -> None:
        """Write a file that was asked for, and say so, with what `write` says of it."""
        if path is None:
            return
        with_words = self.attempt(lambda: (write(path),), what, default=None)
        if with_words is not None:
            (said,) = with_words
            more = f": {said}" if isinstance(said, str) else ""
            say(f"wrote {path}{more}", err=True)

    def put_document(self, path: Path | None, document: Callable[[], Mapping]) -> None:
        """Write a document for machines that was asked for, and say so."""
        from exoid.report.document.plain_json import write_json

        self.put(path, lambda path: write_json(document(), path))

    def attempt(self, work: Callable[[], Result], what: str, default: Result) -> Result:
        """What `work` gives; where it fails, why is told, and the rest is written without it."""
        try:
            return patiently(work, what)
        except BrokenPipeError:  # the reader of our output has seen enough
            return default
        except Exception as fault:
            self.failed = True
            try:
                explain(fault)
            except Exception:
                self.ours = self.ours or fault
            return default

    def end(self, follows: bool = True) -> None:
        """Leave with exit code 1 where a file was not written, or nothing is told: no simulation
        follows, no drop is read.
        """
        if self.ours is not None:
            raise self.ours
        if self.failed or not follows:
            raise typer.Exit(1)
