"""What other libraries say of a bad file, kept to one line of our own report."""

import logging
from contextlib import contextmanager


@contextmanager
def quiet(logger: str):
    """Keep a library from logging what the report tells."""
    found = logging.getLogger(logger)
    level = found.level
    found.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        found.setLevel(level)


def plain(text: str) -> str:
    """What a library says, on one line of plain characters."""
    return " ".join(text.split()).rstrip(".").encode("unicode_escape").decode()


def is_ours(fault: BaseException) -> bool:
    """Was this raised by a module of exoid?"""
    frame = fault.__traceback__
    while frame is not None and frame.tb_next is not None:
        frame = frame.tb_next
    return frame is not None and str(frame.tb_frame.f_globals.get("__name__")).startswith("exoid.")
