"""The keyboard while something else goes on: what was typed, key by key."""

import os
import select
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from importlib.util import find_spec

LONGEST = 64  # bytes looked at in one go


def check_keyboard() -> None:
    """Refuse to wait for keys where nobody can press one."""
    if find_spec("termios") is None:
        raise ValueError("--segment needs a Unix terminal. Mark the segments in the sidecar.")
    if not sys.stdin.isatty():
        raise ValueError(
            "--segment marks by keys, and the standard input is no terminal. Leave it out, or mark "
            "the segments in the sidecar."
        )


def has_keyboard() -> bool:
    return find_spec("termios") is not None and sys.stdin.isatty()


@contextmanager
def keyboard(wanted: bool) -> Iterator[Callable[[], str]]:
    """A function that gives the keys pressed since its last call; the terminal echoes none."""
    if not wanted:
        yield str
        return
    import termios
    import tty

    terminal = sys.stdin.fileno()
    before = termios.tcgetattr(terminal)
    tty.setcbreak(terminal)
    try:
        yield lambda: pressed(terminal)
    finally:
        with suppress(termios.error):  # it may be gone
            termios.tcsetattr(terminal, termios.TCSADRAIN, before)


def pressed(terminal: int) -> str:
    with suppress(OSError):  # a terminal that is gone
        ready, _, _ = select.select([terminal], [], [], 0)
        return os.read(terminal, LONGEST).decode(errors="replace") if ready else ""
    return ""
