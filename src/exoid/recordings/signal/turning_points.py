"""Where a motion turns around."""

from exoid.recordings.samples import Samples

RINGING = 0.1  # of its travel: the least that a swing goes


def reversals(angle: Samples, least: float) -> list[int]:
    """Where a sequence turns around by at least `least`: the extremes between such turns."""
    found: list[int] = []
    low = high = 0
    falling: bool | None = None
    for at, value in enumerate(angle.tolist()):
        low, high = (at if value < angle[low] else low), (at if value > angle[high] else high)
        if falling is not False and value - angle[low] >= least:
            if falling:
                found.append(low)
            falling, high = False, at
        elif falling is not True and angle[high] - value >= least:
            if falling is False:
                found.append(high)
            falling, low = True, at
    return found
