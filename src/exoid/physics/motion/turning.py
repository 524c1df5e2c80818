"""How finely dry friction turns over with the leg."""

from math import ceil

LONGEST = 5e-3  # s, of a part in which it turns over: the angle is then off by 1e-4 deg
MOST = 16  # parts of a step


def parts_to_turn(step: float) -> int:
    """Into how many parts a step [s] is cut, within which dry friction turns over."""
    return min(ceil(step / LONGEST - 1e-6), MOST)
