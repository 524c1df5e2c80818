"""Ctrl-C as a wish: what runs ends by itself, with everything in order; a terminal that goes away
wishes nothing, but where it is said to. What nobody asks to wish ends a command, in order as well.
"""

import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

SIGNALS = ("SIGINT", "SIGTERM")
GONE = "SIGHUP"  # the terminal was closed, or the connection to it dropped; Windows lacks it


@contextmanager
def stoppable(*, hangs_up: bool = False) -> Iterator[Callable[[], bool]]:
    """A function that says whether to stop. A second Ctrl-C interrupts at once. A terminal that
    goes away wishes that, too, where it `hangs_up` what nobody needs then.
    """
    wished = []

    def wish(number: int, _frame) -> None:
        wished.append(number)
        signal.signal(number, before[number])

    names = (*SIGNALS, GONE) if hangs_up and hasattr(signal, GONE) else SIGNALS
    numbers = [getattr(signal, name) for name in names]
    before = {number: signal.signal(number, wish) for number in numbers}
    if not hangs_up and hasattr(signal, GONE):
        before[signal.SIGHUP] = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        yield lambda: bool(wished)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def end_in_order() -> None:
    """SIGTERM, which batch systems send before they kill, ends a command as Ctrl-C does: processes
    beside it end, and leave nothing behind. A second one ends it at once.
    """
    signal.signal(signal.SIGTERM, interrupt)


def interrupt(number: int, _frame) -> None:
    """**Raises** `KeyboardInterrupt`, the first time."""
    signal.signal(number, signal.SIG_DFL)
    raise KeyboardInterrupt


def end_beside() -> None:
    """What a thread that nobody waits for any more has begun beside it ends, and leaves no
    semaphores of which Python would warn.
    """
    ahead = sys.modules.get("exoid.fitting.solve.cores.ahead")  # else there is none
    if ahead is not None:
        ahead.end_all()
