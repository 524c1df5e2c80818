"""The last instants of a drop: did the leg come to rest by itself, or did a hand keep it?

A hand that stops a leg softly, near where it would rest, is hardly seen in its motion. But what
drops tell before their last swing, each must follow to its end.
"""

from collections.abc import Callable

import numpy as np

from exoid.fitting.data.movement import Movement, weightless
from exoid.fitting.hands.first_instants import disturbed
from exoid.fitting.multistart.beginning.tethers import LOOKING
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.ask import advance, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.recordings.motion.thresholds import LATE, REST

LOUD = 2.0  # times the noise that a drop misses by, where a hand kept its leg
FOLLOWS = 1.5  # times the noise that a drop may miss where no hand is on it
BY_CHANCE = 4.0  # standard deviations of a sum of squares
ALONE = 1  # drop at least must show how a leg ends by itself, where it hardly swung any more
SOFT = 0.5  # s before a hand is seen in which a soft one may have begun: 0.34 at most
WIDE = np.radians(10.0)  # of a swing that friction does not end: it had lost as much in each before
SWING = 1.0  # s, in which a leg swings to and fro

Fitted = tuple[Problem, SearchResult]


def without_hands(
    whole: Problem, of_whole: SearchResult, fit: Callable[[list[Movement]], Fitted]
) -> list[Movement] | None:
    """The movements without what a hand did at the end of some drops; None where no hand explains
    what a fit of all leaves.

    Ends are taken back one after another, the one that fits best first, each only where all that is
    left is noise.
    """
    movements = whole.movements
    drops = [number for number, each in enumerate(movements) if each.kind == "passive"]
    loud = [n for n in drops if is_loud(whole, of_whole, n) or is_caught(movements[n])]
    if len(drops) < 2 or not loud:
        return None
    kept = [ended(each, sure_until(each)) for each in movements]
    found = fit(kept)[1]
    if disturbed(found):
        return None
    there = simulated(whole, found)
    for number in sorted(drops, key=lambda number: missed_at_end(whole, there, number)):
        trial = [*kept[:number], movements[number], *kept[number + 1 :]]
        more = fit(trial)[1]
        if not disturbed(more):
            kept, found = trial, more
    hands = [number for number in drops if kept[number].kept is not None]
    if not hands or (len(hands) > len(drops) - ALONE and not all(map(swung, kept))):
        return None
    there = simulated(whole, found)
    longer = list(kept)
    for number in hands:
        longer[number] = ended(movements[number], follows_until(whole, there, number))
    return kept if disturbed(fit(longer)[1]) else longer


def sure_until(each: Movement) -> int:
    """How many samples come before the swing that a hand may have ended."""
    if each.extent is None or each.kind != "passive":
        return each.angle.size
    time = each.segment.time
    count = min(max(each.extent.sure - each.extent.start, 1), time.size)
    soft, least = np.searchsorted(time, [time[count - 1] - SOFT, time[0] + SOFT])
    return min(count, max(int(soft), int(least)))


def is_loud(whole: Problem, found: SearchResult, number: int) -> bool:
    """Does a drop miss far more than noise does?"""
    return bool(np.nanmean(misses(whole, found.best, number) ** 2) > LOUD**2)


def is_caught(each: Movement) -> bool:
    """Was a hand seen, which may have begun before?"""
    return each.extent is not None and each.extent.ended == "caught"


def swung(each: Movement) -> bool:
    """Did a drop swing so widely, when it was stopped, that no friction can have done it?"""
    if each.kept is None:
        return True
    time = each.segment.time[: each.kept]
    last = each.angle[np.searchsorted(time, time[-1] - SWING) : each.kept]
    return bool(np.nanmax(last) - np.nanmin(last) > WIDE)


def ended(each: Movement, count: int) -> Movement:
    """What comes after so many samples weighs nothing."""
    if count >= each.angle.size:
        return each
    return weightless(each, np.arange(each.angle.size) >= count, kept=count)


def simulated(whole: Problem, found: SearchResult) -> Solved:
    """How all movements would go on as the fit has them."""
    row = take(found.best.coordinates, [0])
    return advance(whole, row, task(whole, 0.0, whole.steps, LOOKING))


def misses(whole: Problem, there: Solved, number: int) -> np.ndarray:
    """What a simulation misses of the angle, over its noise, where that counts."""
    each, rows = whole.movements[number], whole.own_rows(number)
    missed = (each.angle - there.angle[0, number][rows]) / each.angle_noise
    return np.where(np.asarray(whole.observation.angle_weight)[number, rows] > 0, missed, np.nan)


def missed_at_end(whole: Problem, there: Solved, number: int) -> float:
    end = misses(whole, there, number)[sure_until(whole.movements[number]) :]
    return float(np.nanmean(end**2)) if np.isfinite(end).any() else 0.0


def follows_until(whole: Problem, there: Solved, number: int) -> int:
    """How many samples of a movement a simulation follows."""
    each, miss = whole.movements[number], misses(whole, there, number)
    time, sure = each.segment.time, sure_until(each)
    for first in range(sure, time.size):
        window = miss[first : int(np.searchsorted(time, time[first] + REST))]
        if beyond_noise(window[np.isfinite(window)]):
            return max(int(np.searchsorted(time, time[first] - LATE)), sure)
    return time.size


def beyond_noise(window: np.ndarray) -> bool:
    """Is what is missed more than a drop may miss, and than its few samples do by chance?"""
    count, square = window.size, float(window @ window)
    return square > max(FOLLOWS**2 * count, count + BY_CHANCE * float(np.sqrt(2 * count)))
