"""Whether the gyro is late by one time in all segments of a recording, or by another in each."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from exoid.mismatch.sensors.agreement import OwnValue
from exoid.mismatch.sensors.compare import Measured, compare
from exoid.mismatch.sensors.faults import SKEW, USUAL

CLEAR = 5.0  # standard deviations by which two delays differ; 2.7 where all segments have one
LEAST = 5e-4  # s, of such a difference: a filter that is no delay makes 2.5e-4


def own_delays(
    segments: list[Measured], struck: list[np.ndarray], owners: Sequence[int]
) -> list[OwnValue]:
    """How late the gyro is [s] in every segment that shows it, where two of one recording clearly
    differ; else none.
    """
    seen = [number for number, (_, _, weights) in enumerate(segments) if weights[:, 1].any()]
    each = [own_delay(number, segments[number], struck[number]) for number in seen]
    pairs = combinations(each, 2)
    unequal = any(owners[a.number] == owners[b.number] and differ(a, b) for a, b in pairs)
    return each if unequal else []


def own_delay(number: int, segment: Measured, struck: np.ndarray) -> OwnValue:
    """Of one segment by itself, with an error by the noise and by what else remains of it."""
    found = compare([segment], [struck], USUAL)
    (place,) = found.places((SKEW,))
    error = float(np.sqrt(found.covariance[place, place] * max(1.0, found.misfit)))
    return OwnValue(number, float(found.values[place]), error)


def differ(one: OwnValue, other: OwnValue) -> bool:
    """Do two delays clearly differ, by a time that matters? One without an error is not told."""
    apart, error = abs(one.value - other.value), np.hypot(one.standard_error, other.standard_error)
    told = one.standard_error > 0 and other.standard_error > 0
    return bool(told and apart > max(CLEAR * error, LEAST))
