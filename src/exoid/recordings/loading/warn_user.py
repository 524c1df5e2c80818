"""What the owner of data should know, where no command prints it: as warnings of Python."""

import sys
import warnings
from collections.abc import Iterable

from exoid.files.visible import visible


def tell(notes: Iterable[str]) -> None:
    """A warning for each, at the line that called exoid."""
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and str(frame.f_globals.get("__name__")).startswith("exoid."):
        frame, level = frame.f_back, level + 1
    for note in notes:
        warnings.warn(visible(note), stacklevel=level)
