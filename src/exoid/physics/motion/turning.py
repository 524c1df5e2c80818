"""How often dry friction may turn over with the leg."""

from math import ceil

LATEST = 1.25e-3  # s, by which it may turn over too late
MOST = 16  # parts of a step


def parts_to_turn(step: float) -> int:
    """Into how many parts a step [s] is cut, at whose ends dry friction turns over."""
    return min(ceil(step / LATEST - 1e-6), MOST)
