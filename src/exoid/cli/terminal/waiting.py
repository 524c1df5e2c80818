"""Patience: what takes long shows that it lives, and can be interrupted."""

import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from typing import Any, TypeVar

from exoid.files.visible import visible

SLOW = 2.0  # s, after which a person wants to see that something happens

Result = TypeVar("Result")


def patiently(task: Callable[[], Result], what: str) -> Result:
    """The result of `task`; once it is slow, a spinner on stderr where that is a terminal."""
    return in_phases(lambda told: task(), what)


def in_phases(task: Callable[[Callable[[str], None]], Result], what: str = "starting") -> Result:
    """The result of `task`, which names its phases; a spinner shows them, as in `patiently`.

    It runs in a thread, because XLA does not hear Ctrl-C while it compiles.
    """
    phase = [what]
    status: list[Any] = []

    def told(name: str) -> None:
        phase[:] = [name]
        if status:
            from rich.text import Text

            status[0].update(Text(visible(name)))

    running = ThreadPoolExecutor(1).submit(lambda: task(told))
    wait([running], SLOW)
    if not running.done() and sys.stderr.isatty():
        from rich.console import Console

        with Console(stderr=True).status("") as shown:
            status.append(shown)
            told(phase[0])
            wait([running])
    return running.result()
