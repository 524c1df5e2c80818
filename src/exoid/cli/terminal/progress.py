"""How far a long work is: rate and time left, on stderr where that is a terminal."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

SELDOM = 0.2  # a second, below which one counts seconds


@contextmanager
def progress(what: str) -> Iterator[Callable[[str, int, int], None]]:
    """A function that hears with how many a step is done, of how many; of none as it begins."""
    if not sys.stderr.isatty():
        yield lambda step, done, of: None
        return
    from rich.console import Console

    with Console(stderr=True).status("starting") as shown:
        began = [time.monotonic()]

        def told(step: str, done: int, of: int) -> None:
            if not done:
                began[0] = time.monotonic()
            shown.update(f"{step}: {line(what, done, of, time.monotonic() - began[0])}")

        yield told


def line(what: str, done: int, of: int, seconds: float) -> str:
    """Such as "120 of 1000 recordings, 12.5 a second, 1 min 10 s left"."""
    if not done or seconds <= 0:
        return f"{done} of {of} {what}"
    rate = done / seconds
    return f"{done} of {of} {what}, {pace(rate)}, {lasting((of - done) / rate)} left"


def pace(rate: float) -> str:
    """So many a second, or how long each takes where that is long."""
    return f"{rate:.3g} a second" if rate > SELDOM else f"{lasting(1 / rate)} each"


def lasting(seconds: float) -> str:
    """A time as one says it."""
    whole = round(seconds)
    hours, minutes = whole // 3600, whole // 60 % 60
    if hours:
        return f"{hours} h {minutes} min"
    return f"{minutes} min {whole % 60} s" if minutes else f"{whole} s"
