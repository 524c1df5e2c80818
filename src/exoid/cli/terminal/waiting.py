"""Patience: what takes long shows that it lives, and can be interrupted."""

import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from typing import TypeVar

from exoid.cli.terminal.progress import lasting
from exoid.files.visible import visible

SLOW = 2.0  # s, after which a person wants to see that something happens
TICK = 1.0  # s between two looks at how long it takes already

Result = TypeVar("Result")


def patiently(task: Callable[[], Result], what: str) -> Result:
    """The result of `task`; once it is slow, a spinner on stderr where that is a terminal."""
    return in_phases(lambda told: task(), what)


def in_phases(task: Callable[[Callable[[str], None]], Result], what: str = "starting") -> Result:
    """The result of `task`, which names its phases; a spinner shows them and how long it takes
    already, as in `patiently`.

    It runs in a thread, because XLA does not hear Ctrl-C while it compiles.
    """
    phase, began = [what], time.monotonic()

    def told(name: str) -> None:
        phase[:] = [name]

    running = ThreadPoolExecutor(1).submit(lambda: task(told))
    wait([running], SLOW)
    if not running.done() and sys.stderr.isatty():
        from rich.console import Console
        from rich.text import Text

        with Console(stderr=True).status("") as shown:
            while not running.done():
                spent = lasting(time.monotonic() - began)
                shown.update(Text(visible(f"{phase[0]} ({spent})")))
                wait([running], TICK)
    return running.result()
