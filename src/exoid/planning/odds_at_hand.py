"""Which of several models the recordings at hand favour, and whether they tell already."""

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from exoid.fitting.model.term_parameters import parameters_of
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.mismatch.evidence.measure import long_run
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.planning.expected_odds import DECISIVE


def odds_at_hand(fits: Sequence[FitResult]) -> list[float]:
    """The log odds of each of them against the best, by the recordings at hand, after the price of
    its parameters: one with more of them follows anything better.
    """
    measure = measure_of(fits)
    price = [measure.price(parameters_in(each)) / 2 for each in fits]
    odds = [-each.loss / measure.scale - paid for each, paid in zip(fits, price, strict=True)]
    return [each - max(odds) for each in odds]


def told_already(fits: Sequence[FitResult]) -> bool:
    """Do the recordings at hand tell every two of them apart, with and without that price?"""
    scale, priced = measure_of(fits).scale, odds_at_hand(fits)
    apart = [
        ((other.loss - one.loss) / scale, mine - yours)
        for (one, mine), (other, yours) in combinations(zip(fits, priced, strict=True), 2)
    ]
    return all(min(each) > DECISIVE or max(each) < -DECISIVE for each in apart)


def measure_of(fits: Sequence[FitResult]) -> Yardstick:
    """What even the best leaves, and what is correlated in it, makes few samples of many."""
    best = min(fits, key=lambda each: each.loss)
    left = [one for each in best.segments for one in left_in(each)]
    return Yardstick(len(left), max(1.0, float(np.mean(left))))


def parameters_in(each: FitResult) -> int:
    """How many its terms have."""
    return len(parameters_of([type(term) for term in each.fitted_terms]))


def left_in(segment: SegmentFit) -> list[float]:
    """Of every sample, what is left over the noise: its variance in the long run."""
    step, found = float(np.median(np.diff(segment.time))), []
    for seen, shown, noise in (
        (segment.angle, segment.simulated_angle, segment.angle_noise),
        (segment.angular_velocity, segment.simulated_velocity, segment.velocity_noise),
    ):
        if seen is not None:
            left = (shown - seen)[~np.isnan(seen)] / noise
            found += [long_run(left, step)] * left.size
    return found
