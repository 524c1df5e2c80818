"""Whether the gyro is late by one time in all segments of a recording, or by another in each.

A clock that lies elsewhere in a segment does so from its begin to its end. A thigh that sinks or
rocks under an encoder of the knee looks like a gyro that is late while it moves, by another time as
the swing becomes smaller, or no longer.
"""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from exoid.mismatch.sensors.agreement import OwnValue
from exoid.mismatch.sensors.compare import Compared, Measured, compare
from exoid.mismatch.sensors.faults import SKEW, USUAL

CLEAR = 5.0  # standard deviations by which two delays differ; 2.7 where all segments have one
# Of a delay, by which it differs from larger to smaller swings: of one 0.03 at most, of a thigh
# that rocks on as the swing becomes smaller 0.24 and more.
UNSTEADY = 0.25
LEAST = 5e-4  # s, of such a difference: a filter that is no delay makes 2.5e-4


def own_delays(
    segments: list[Measured], struck: list[np.ndarray], owners: Sequence[int]
) -> list[OwnValue]:
    """How late the gyro is [s] in every segment that shows it, where two of one recording clearly
    differ, by their smaller swings too, and each is as late in its larger ones; else none.
    """
    seen = [number for number, (_, _, weights) in enumerate(segments) if weights[:, 1].any()]
    each = [own_delay(number, segments[number], struck[number]) for number in seen]
    if not unequal(each, owners):
        return []
    halves = [in_halves(number, segments[number], struck[number]) for number in seen]
    steady = not any(differ(larger, smaller) for larger, smaller in halves)
    return each if steady and unequal([smaller for _, smaller in halves], owners) else []


def unequal(each: list[OwnValue], owners: Sequence[int]) -> bool:
    """Do two of one recording clearly differ?"""
    pairs = combinations(each, 2)
    return any(owners[a.number] == owners[b.number] and differ(a, b) for a, b in pairs)


def own_delay(number: int, segment: Measured, struck: np.ndarray) -> OwnValue:
    """Of one segment by itself, with an error by the noise and by what else remains of it."""
    return delay_of(number, compare([segment], [struck], USUAL))


def delay_of(number: int, found: Compared) -> OwnValue:
    """That of a comparison."""
    (place,) = found.places((SKEW,))
    error = float(np.sqrt(found.covariance[place, place] * max(1.0, found.misfit)))
    return OwnValue(number, float(found.values[place]), error)


def in_halves(number: int, segment: Measured, struck: np.ndarray) -> tuple[OwnValue, OwnValue]:
    """The same by the gyro in its larger and in its smaller swings."""
    larger, smaller = (own_delay(number, one, struck) for one in by_size(segment, struck))
    return larger, smaller


def by_size(segment: Measured, struck: np.ndarray) -> tuple[Measured, Measured]:
    """With the gyro of its larger and of its smaller swings; each tell half of a delay."""
    time, data, weights = segment
    (motion,) = compare([segment], [struck], USUAL).motions
    told = np.cumsum(motion.angular_velocity**2 * (weights[:, 1] > 0))
    first = told < told[-1] / 2
    larger, smaller = (
        (time, data, np.stack([weights[:, 0], gyro], axis=1))
        for gyro in (weights[:, 1] * first, weights[:, 1] * ~first)
    )
    return larger, smaller


def unsteady(segments: list[Measured], struck: list[np.ndarray]) -> list[float]:
    """How late the gyro seems [s] in the larger and in the smaller swings of all segments, where
    these differ as no delay does; else none.
    """
    parts = [by_size(*each) for each in zip(segments, struck, strict=True)]
    larger, smaller = (
        delay_of(0, compare([each[part] for each in parts], struck, USUAL)) for part in (0, 1)
    )
    values = larger.value, smaller.value
    most = UNSTEADY * max(map(abs, values))
    return list(values) if differ(larger, smaller) and abs(np.subtract(*values)) > most else []


def differ(one: OwnValue, other: OwnValue) -> bool:
    """Do two delays clearly differ, by a time that matters? One without an error is not told."""
    between = abs(one.value - other.value)
    error = np.hypot(one.standard_error, other.standard_error)
    told = one.standard_error > 0 and other.standard_error > 0
    return bool(told and between > max(CLEAR * error, LEAST))
