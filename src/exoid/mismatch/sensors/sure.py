"""Which errors of the sensors are sure, before any leg model: the fewest that leave only noise.

All are estimated at once. What explains the sensors' disagreement about as well is named, too: a
gain that is off and a magnet off the centre look much alike over a quarter of a turn.
"""

from collections.abc import Callable
from itertools import combinations
from typing import Protocol, runtime_checkable

import numpy as np

from exoid.mismatch.sensors.agreement import Sure, SureError
from exoid.mismatch.sensors.compare import Compared, Measured, compare, inverse
from exoid.mismatch.sensors.faults import BIAS, OTHERS, USUAL, Fault

ASKED = tuple(one for one in (*USUAL, *OTHERS) if one is not BIAS)  # which is free anyway
MOST = 4  # errors at once


@runtime_checkable
class Measure(Protocol):
    """What a difference between sums of squares is worth: `evidence.yardstick.Yardstick`."""

    @property
    def scale(self) -> float: ...

    def price(self, parameters: int) -> float: ...

    def clear(self, worse: float, better: float, parameters: int) -> bool: ...

    def explains(self, square: float) -> bool: ...


Measuring = Callable[[int, float], Measure]  # of a number of samples, and their scale


def surely(
    segments: list[Measured], struck: list[np.ndarray], usual: Compared, measuring: Measuring
) -> Sure:
    """What encoder and gyro surely say of each other; nothing where more is between them."""
    every = compare(segments, struck, (*USUAL, *OTHERS))
    measure = measuring(every.samples, max(1.0, every.misfit))
    sets = [each for count in range(MOST + 1) for each in combinations(ASKED, count)]
    costs = [cost(every, each, measure) for each in sets]
    chosen = needed(every, sets[int(np.argmin(costs))], measure)
    if not chosen or not measure.explains(every.left):
        return Sure()
    least = missed(every, chosen)
    alike = [
        tuple(fault.term for fault in each)
        for each in sets
        if each != chosen
        and not measure.clear(missed(every, each), least, 1)
        and needed(every, each, measure) == each
    ]
    known = set(chosen) <= set(USUAL)
    found = usual if known else compare(segments, struck, (BIAS, *chosen))
    errors = tuple(SureError(one, found.of(one)) for one in chosen)
    return Sure(errors, tuple(alike)) if all(each.possible for each in errors) else Sure()


def cost(every: Compared, some: tuple[Fault, ...], measure: Measure) -> float:
    """What a set of errors leaves, and its price."""
    parameters = sum(one.parameters for one in some)
    return missed(every, some) / measure.scale + measure.price(parameters)


def missed(every: Compared, some: tuple[Fault, ...]) -> float:
    """The sum of squares that the others explain beside a set of errors."""
    out = every.places(tuple(one for one in ASKED if one not in some))
    if not out.size:
        return 0.0
    within = np.setdiff1d(np.arange(every.values.size), out)
    values, normal = every.values[out], every.normal
    cross = normal[np.ix_(out, within)]
    rest = normal[np.ix_(out, out)] - cross @ inverse(normal[np.ix_(within, within)]) @ cross.T
    return float(values @ rest @ values)


def needed(every: Compared, some: tuple[Fault, ...], measure: Measure) -> tuple[Fault, ...]:
    """Those without which clearly more is left, the least needed taken out first."""
    while some:
        fewer = {one: tuple(other for other in some if other is not one) for one in some}
        lost = {one: missed(every, rest) - missed(every, some) for one, rest in fewer.items()}
        weakest = min(some, key=lambda one: lost[one])
        if measure.clear(lost[weakest], 0.0, weakest.parameters):
            return some
        some = fewer[weakest]
    return some
