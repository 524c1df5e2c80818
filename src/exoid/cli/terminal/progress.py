"""How far a long work is: rate and time left, on stderr. That is a line that moves where it is a
terminal, else lines of a log.
"""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer

from exoid.cli.terminal.screen import Screen

SELDOM = 0.2  # a second, below which one counts seconds
SHORT = 10.0  # s of a work that a log says nothing of
SILENCE = 300.0  # s, after which a log tells more than tenths


@contextmanager
def progress(what: str) -> Iterator[Callable[[str, int, int], None]]:
    """A function that hears with how many a step is done, of how many; of none as it begins."""
    began = [time.monotonic()]

    def line_of(step: str, done: int, of: int) -> str:
        if not done:
            began[0] = time.monotonic()
        return f"{step}: {line(what, done, of, time.monotonic() - began[0])}"

    if not sys.stderr.isatty():
        with Log() as log:
            yield lambda step, done, of: log.hear(line_of(step, done, of), done, of)
        return
    from rich.console import Console

    with Console(stderr=True).status("starting") as shown:
        yield lambda step, done, of: shown.update(line_of(step, done, of))


class Log:
    """Lines of how far a work is, from when it is no short one: then, as a step begins, at each
    tenth of it, and where that takes minutes.
    """

    def __init__(self):
        self.began = self.told = time.monotonic()
        self.line, self.tenth = "starting", 0
        self.first = Timer(SHORT, self.tell)
        self.first.daemon = True

    def __enter__(self) -> "Log":
        self.first.start()
        return self

    def __exit__(self, *_) -> None:
        self.first.cancel()

    def hear(self, line: str, done: int, of: int) -> None:
        """Tell the line where it is time."""
        now, before = time.monotonic(), self.tenth
        self.line, self.tenth = line, 10 * done // of
        new = not done or self.tenth > before or now - self.told >= SILENCE
        if new and now - self.began >= SHORT:
            self.tell()

    def tell(self) -> None:
        self.told = time.monotonic()
        Screen().tell(self.line)


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
