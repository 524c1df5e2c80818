"""Is a movement the same forwards and backwards in time?

Damping is the only term of Eq. 9 that tells the two apart: where neither the motion nor the torque
that is assumed does, the fit must book no damping, whatever the leg has.
"""

import numpy as np

from exoid.fitting.data.movement import Movement, smoothed_motion
from exoid.trust.identifiability import Reversal

SMOOTHING = 0.06  # s
CENTRES = (0.35, 0.65)  # of the duration, between which the middle of the movement is looked for
STEPS = 61  # tried middles


def reversals(movements: list[Movement]) -> list[Reversal]:
    """Every segment against its mirror image, from the data alone, whatever its kind is called.

    Where the torque was measured nothing follows from it, and it is not asked.
    """
    asked = [each for each in movements if each.kind != "measured"]
    return [Reversal(each.name, each.voluntary, odd_part(each)) for each in asked]


def odd_part(each: Movement) -> float:
    """The smallest odd part, over the middles that a mirror could stand in."""
    angle, _ = smoothed_motion(each, SMOOTHING)
    time, last = each.segment.time, float(each.segment.time[-1])
    found = []
    for centre in np.linspace(*CENTRES, STEPS) * last:
        reach = np.linspace(0.0, min(centre, last - centre), time.size // 2)
        before, after = (np.interp(centre + sign * reach, time, angle) for sign in (-1, 1))
        whole = np.std(np.concatenate([before, after]))
        found.append(np.sqrt(np.mean((before - after) ** 2)) / 2 / whole)
    return float(min(found))
