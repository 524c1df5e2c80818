"""The segments of recordings as they enter a fit."""

from dataclasses import replace

from exoid.fitting.amount.part import Part, parts_of
from exoid.fitting.data.fitted_samples import Clip
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.segment import movement
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.recording import Recording


def movements_of(named: list[tuple[str, Recording]], *, clip: Clip = "free") -> list[Movement]:
    """Every segment of every recording that moves, as it enters a fit.

    **Raises** `ValueError` where none moves, or one cannot be fitted.
    """
    return movements_in(parts_of(named), clip=clip)


def movements_in(parts: list[Part], *, clip: Clip = "free") -> list[Movement]:
    """The same of these segments."""
    found, still = [], []
    for part in parts:
        try:
            found.append(movement(part.recording, part.number, part.name, part.belongs, clip=clip))
        except Motionless as fault:
            still.append(fault)
    if not found:
        raise still[0]
    least = min(each.added_mass for each in found)
    return [replace(each, least_mass=least) for each in found]


def left_out(parts: list[Part], movements: list[Movement]) -> list[str]:
    """A note of the segments in which nothing moves that could be fitted."""
    moved = {each.name for each in movements}
    still = [part.name for part in parts if part.name not in moved]
    if not still:
        return []
    which = f"segment {still[0]} was" if len(still) == 1 else f"segments {', '.join(still)} were"
    return [f"{which} left out: nothing moves freely in there, or hardly ever"]
