"""A halt in the first swing, as a stretch reflex makes one, and a stop that a leg meets, amplitude
and index hang on both; and a rig's first swing that goes up, on which nothing hangs.
"""

import numpy as np

from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.track import HALF, SURE, Track
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.condition import MOTION_SPEED

SLOW = 0.1  # of the fastest flexion before and after it, of a leg that halts
FARTHER = np.radians(2.0)  # rad by which a second flexion goes beyond the first
# In no more time [s], and by no less [rad/s], something hard turns a leg around: reflexes of 330
# legs did by 0.6 rad/s at most.
HARD, STRUCK = 0.05, 2.0


def of_stop(drop: Landmarks) -> str | None:
    """That the leg meets something hard in flexion, where first and in how much time; None of one
    that turns as muscles and gravity turn it.
    """
    hard = (each for each in drop.impacts if each.lasting <= HARD and each.gained >= STRUCK)
    found = next(hard, None)
    if found is None:
        return None
    return (
        f"the leg turns around at {np.degrees(found.value):.0f} deg within "
        f"{max(found.lasting, 0.01):.2f} s, by {np.degrees(found.gained):.0f} deg/s, as only "
        "something hard turns it, a stop or the end of its range: amplitudes, indices and "
        "decrements of swings that end there are of that. Let it swing clear"
    )


def of_rise(given: Track, drop: Landmarks) -> str | None:
    """That a rig which was let go below its rest is read from where it first turns back."""
    first, top = (float(each.time[0]) for each in (given, drop.track))
    if top == first:
        return None
    return (
        f"it was let go where it swings up, to {np.degrees(drop.track.angle[0]):.1f} deg at "
        f"{top:.2f} s: that half swing is passed over, and all is read from its top on"
    )


def of_halt(drop: Landmarks) -> str | None:
    """Where the leg halts or turns back on its way to its lowest, by how much it turns, and
    whether A1 is counted to there; None of a leg that falls at once.
    """
    flexions = drop.turns[::2]
    if len(flexions) > 1 and flexions[0].value - flexions[1].value > FARTHER:
        halt, top, lowest = drop.turns[:3]
        return words(halt.value, top.value - halt.value, halt.time - drop.begin, lowest.value, True)
    if not flexions:
        return None
    times, polynomials, _ = drop.first_swings
    falling = np.flatnonzero((times > drop.begin + HALF / 2) & (times < flexions[0].time))
    angle = polynomials.value(0)[falling]
    at = slowest_between(*(each[falling] for each in polynomials.derivative(1)))
    if at is None:
        return None
    low, high = angle[: at + 1].min(), angle[at:].max()
    error = SURE * drop.track.smoothed_noise(2 * HALF)
    back = float(high - low) if high - low > error else 0.0
    return words(
        float(low if back else angle[at]),
        back,
        float(times[falling[at]]) - drop.begin,
        flexions[0].value,
        False,
    )


def slowest_between(velocity: Samples, error: Samples) -> int | None:
    """The sample at which a flexion [rad/s] is slowest between two in which it surely is fast; None
    where it hardly slows down there.
    """
    if velocity.size < 3:
        return None
    surely = velocity + SURE * error
    before = np.minimum.accumulate(surely)
    after = np.minimum.accumulate(surely[::-1])[::-1]
    least = np.maximum(before, after)  # the slower of the two
    halted = np.flatnonzero((least < -MOTION_SPEED) & (velocity > SLOW * least))
    return int(halted[np.argmax(velocity[halted])]) if halted.size else None


def words(angle: float, back: float, after: float, lowest: float, counted: bool) -> str:
    """In degrees, for the reader."""
    halt, turned, low = (f"{np.degrees(each):.1f}" for each in (angle, back, lowest))
    turns = f", turns back by {turned} deg" if back else ""
    which = "to there" if counted else f"beyond it, to {low} deg"
    beyond = f" and then falls to {low} deg" if counted else ""
    return (
        f"the leg halts at {halt} deg, {after:.2f} s after it began to fall{turns}{beyond}, as by "
        f"a stretch reflex: A1 and the relaxation index are counted {which}"
    )
