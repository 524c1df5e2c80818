"""How far a long work is: rate and time left, on stderr; now and then where it is no terminal."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from exoid.cli.terminal.say import say

SELDOM = 60.0  # s between two lines of a log


@contextmanager
def progress(what: str) -> Iterator[Callable[[int, int], None]]:
    """A function that hears how many are done, of how many."""
    if not sys.stderr.isatty():
        yield in_lines(what)
        return
    from rich.console import Console

    with Console(stderr=True).status("starting") as shown:
        began: list[float] = []

        def told(done: int, of: int) -> None:
            began[:] = began or [time.monotonic()]
            shown.update(line(what, done, of, time.monotonic() - began[0]))

        yield told


def in_lines(what: str) -> Callable[[int, int], None]:
    """The same for a file: a line at the start, at most one a minute, and the end."""
    began: list[float] = []
    spoken: list[float] = []

    def told(done: int, of: int) -> None:
        now = time.monotonic()
        began[:] = began or [now]
        if not spoken or done == of or now - spoken[0] >= SELDOM:
            spoken[:] = [now]
            say(f"exoid: {line(what, done, of, now - began[0])}", err=True)

    return told


def line(what: str, done: int, of: int, seconds: float) -> str:
    """Such as "120 of 1000 recordings, 12.5 a second, 1 min 10 s left"."""
    if not done or seconds <= 0:
        return f"{done} of {of} {what}"
    rate = done / seconds
    return f"{done} of {of} {what}, {rate:.3g} a second, {lasting((of - done) / rate)} left"


def lasting(seconds: float) -> str:
    """A time as one says it."""
    whole = round(seconds)
    hours, minutes = whole // 3600, whole // 60 % 60
    if hours:
        return f"{hours} h {minutes} min"
    return f"{minutes} min {whole % 60} s" if minutes else f"{whole} s"
