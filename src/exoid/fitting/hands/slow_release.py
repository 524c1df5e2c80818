"""A drop that something keeps back in its first swing: from when on did the leg swing by itself?

In its fall alone such a leg is hardly told from another leg. But no hand that lets go turns a leg
around at the bottom: from there on it swings freely, and often since it was fastest. A muscle that
only a fast leg trips pulls on behind the bottom, by less than a noisy angle shows, and is slack as
the leg has swung back.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.hands.first_instants import differ, disturbed
from exoid.fitting.hands.first_swing import bottom, fastest, kept_back_by, swung_back
from exoid.fitting.hands.kept_back import KEEPING, NEXT, names, unlike, what
from exoid.fitting.hands.last_instants import LOUD, Fitted, misses
from exoid.fitting.misfit.missed import NOISY, Disturbance, Missed
from exoid.recordings.motion.acceleration import derivatives, free_until, own_law
from exoid.recordings.motion.signal import Signal
from exoid.recordings.signal.condition import cut

NONE = "No leg falls like this that swings as it does afterwards. "
TRIPPED = {"speed", "unknown"}  # what keeps a leg back by a muscle that may pull on for a while


def without_slow_release(
    whole: Fitted,
    fit: Callable[[list[Movement]], Fitted],
    follows: Callable[[Fitted], bool],
    *,
    bent: bool,
) -> list[Movement] | None:
    """The drops from when on they were free; None where what is left does not fit either, or no
    fall needs a hand.

    `follows` says whether a fit follows its recording. Where the fit of all does, or is refused
    though it misses nothing, a hand may have `bent` the leg that it found: then the falls must miss
    more than the swings do.
    """
    movements = whole[0].movements
    bent = bent or not disturbed(whole[1])
    if (bent and missed(whole).cause != "torque") or not any(map(bottom, movements)):
        return None
    free = None
    for instant in (fastest, bottom, swung_back):
        later = [begun(each, instant(each)) for each in movements]
        found = fit(later)
        if not swings_freely(found) or not follows(found):
            continue
        if not bent or differ(movements, whole[1], later, found[1]):
            by = kept_back_by(movements, *found)
            free = [
                replace(each, kept_back=own) if each.slow else each
                for each, own in zip(later, by, strict=True)
            ]
            if found[0].terms or not TRIPPED & {*by}:  # beside terms nothing tells what it was
                break
    return free


def missed(found: Fitted) -> Missed:
    """What a fit misses of the drops."""
    return found[1].disturbance.like("passive")


def is_held(found: Disturbance) -> bool:
    """Is there a torque in what is missed of the drops, or more than noise?"""
    left = found.like("passive")
    return left.cause == "torque" or left.noise >= NOISY


def swings_freely(found: Fitted) -> bool:
    """Is there no torque in what is left of the drops, and hardly more than noise?"""
    problem, ended = found
    drops = [number for number, each in enumerate(problem.movements) if each.kind == "passive"]
    loud = any(np.nanmean(misses(problem, ended.best, n) ** 2) > LOUD**2 for n in drops)
    return not is_held(ended.disturbance) and not loud


def begun(each: Movement, count: int) -> Movement:
    """The same from this sample on, which finds the leg in motion, until a hand is on it again."""
    if count == 0 or each.extent is None:
        return each
    rate, at = each.angular_velocity, float(each.segment.time[count])
    first, free = each.extent.start + count, slice(count, free_until_hand(each, count))
    return replace(
        each,
        segment=cut(each.segment, free),
        angle=each.angle[free],
        angular_velocity=None if rate is None else rate[free],
        onset=each.onset - at,
        extent=replace(each.extent, held_until=None, start=first, free=first, doubted=0),
        late=0,
        kept=None if each.kept is None else each.kept - count,
        slow=at,
    )


def free_until_hand(each: Movement, count: int) -> int:
    """One past its last sample that is as free as those since `count`: beside a fall in a hand, the
    lift that follows the swings looked free as well. All, where those are too few to tell.
    """
    assert each.extent is not None  # only a drop has turned around
    sure = each.extent.sure - each.extent.start
    size = each.angle.size
    if not count < sure < size:
        return size
    gyro = each.angular_velocity
    signal = Signal(each.segment.time, each.angle, each.angle_noise, gyro, each.velocity_noise)
    seen = derivatives(signal)
    law = own_law(seen, count, sure)
    return size if law is None else free_until(seen, slice(count, sure), size, law)


def of_slow(movements: list[Movement]) -> list[str]:
    """A note of the drops that begin behind their release; `slow` of each says how far."""
    slow = [each for each in movements if each.slow]
    if not slow:
        return []
    since = [f"{each.name} from {each.segment.begins:.2f} s" for each in slow]
    longest, odd = max(each.slow for each in slow), unlike(slow)
    by, where = odd[0].kept_back, "its first swing"
    if len(odd) < len(slow):
        where = f"the first swing of segment {names(odd)}"
    return [
        f"the first {longest:.2f} s behind the release were left out: in {where} "
        f"{what(by)}. {NONE if by in KEEPING else ''}The numbers come from the swings behind it "
        f"alone: segment {', '.join(since)} on. {NEXT[by]}"
    ]
