"""What other libraries say of a bad file, kept to one line of our own report."""

import logging
import sys
from contextlib import contextmanager


@contextmanager
def quiet(logger: str):
    """Keep a library from logging what the report tells, and from failing again as it is freed."""
    found = logging.getLogger(logger)
    level, hook = found.level, sys.unraisablehook
    found.setLevel(logging.CRITICAL + 1)
    sys.unraisablehook = lambda unraisable: None
    try:
        yield
    finally:
        found.setLevel(level)
        sys.unraisablehook = hook


def plain(text: str) -> str:
    """What a library says, on one line of plain characters."""
    return " ".join(text.split()).rstrip(".").encode("unicode_escape").decode()
