"""Memory that programs took, given back to the system; only glibc keeps it else, and is asked."""

import ctypes
import sys
from functools import cache

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD = -1, -3  # of mallopt
LARGE = 2**20  # bytes


def give_back() -> None:
    """What is free goes back now, and from now on what is large as soon as it is free."""
    if sys.platform != "linux":
        return
    give_back_large()
    getattr(ctypes.CDLL(None), "malloc_trim", lambda _: 0)(0)


@cache
def give_back_large() -> None:
    """glibc learns to keep what is asked for again and again: of programs that run side by side
    that is several times what they need.
    """
    choose = getattr(ctypes.CDLL(None), "mallopt", lambda *_: 0)
    for threshold in (M_MMAP_THRESHOLD, M_TRIM_THRESHOLD):
        choose(threshold, LARGE)
