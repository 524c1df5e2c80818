"""Where the movement of a segment begins and ends: one answer for everyone who asks."""

from dataclasses import replace

import numpy as np

from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.acceleration import Law
from exoid.recordings.motion.extent import Extent, Motionless
from exoid.recordings.motion.free_end import free_end
from exoid.recordings.motion.letting_go import LettingGo, ReleaseWindow, begun_free, let_go
from exoid.recordings.motion.own_reversal import swung_freely
from exoid.recordings.motion.signal import Signal, Speed, smoothed, speed_of
from exoid.recordings.motion.swings import before_fall, great_swing, slowed, swung
from exoid.recordings.motion.thresholds import (
    BLOCK,
    CLEAR,
    CONTRARY,
    FALL,
    HELD,
    HOLD,
    MARKED,
    MINOR,
    ODD,
    ODDS,
    REST,
    SINCE,
    SOUND,
    SWAY,
    SWAYED,
    SWAYING,
    TRAVEL,
)
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.condition import runs


def find_free(
    signal: Signal, *, handled: bool = True, shortest: float = MARKED, law: Law | None = None
) -> Extent:
    """The free movement of a drop. `handled`: by a person, whose hand may catch or lift the leg.

    What was held for less than `shortest` s is said to begin free. A `law` is what other drops of
    this leg have told. **Raises** `Motionless` where nothing moves.
    """
    speed = speed_of(signal)
    first, _ = first_movement(signal, speed)
    fell, swayed = fallen_since(signal, speed, first)
    found = released(signal, speed, fell, swayed=swayed)
    gone = 0 if found is None else int(np.searchsorted(signal.time, found.gone))
    held = None if found is None or found.release - signal.time[0] < shortest else found
    start, free = (0, 0) if held is None else (nearest(signal.time, held.release), gone)
    seen = (swung_freely if handled else swung)(signal, speed, start, free)
    end = vars(free_end(signal, speed, seen, handled=handled, law=law)) | {"sure": seen.sure.stop}
    if held is None:
        return Extent(None, float(signal.time[0]), 0.0, 0, 0, **end, doubted=gone)
    last = int(np.searchsorted(signal.time, held.begin, side="right")) - 1
    return Extent(max(last, 0), held.release, held.error, start, free, **end)


def first_movement(signal: Signal, speed: Speed) -> tuple[int, int]:
    """The first and last sample of the first stretch that moves.

    What moves less before a fall is a hand that sways; what moves less before a lift is the drop.

    **Raises** `Motionless`.
    """
    smooth, noise = smoothed(signal, speed.width)
    sway, least = min(SWAY, MINOR * float(np.ptp(smooth))), max(TRAVEL, CLEAR * noise)
    first, last = first_beyond(speed, signal.samples, max(least, sway))
    if smooth[last] < smooth[first]:
        return first, last
    return first_beyond(speed, signal.samples, least)


@remembered  # the same where the noise of the same samples is another
def first_beyond(speed: Speed, signal: Signal, least: float) -> tuple[int, int]:
    """The first stretch that moves by more than `least` rad."""
    smooth, noise = smoothed(signal, speed.width)
    for first, last in moving(signal.time, speed):
        if np.ptp(smooth[max(first - 1, 0) : last + 2]) > least:
            # What moves at once, and faster than a hand sways, is free: it turns around, too.
            held = first > 0 or abs(speed.velocity[0]) < SWAYING
            far = least if held else max(TRAVEL, CLEAR * noise)
            return departure(smooth[: last + 1], speed, first, far), last
    raise Motionless(
        f"nothing moves: no movement goes farther than {np.degrees(least):.2g} deg at more than "
        f"{np.degrees(speed.still):.2g} deg/s, which the noise allows to tell."
    )


def departure(smooth: Samples, speed: Speed, first: int, least: float) -> int:
    """From when on it moves one way until it is gone; a hand that trembles goes both ways."""
    gone = np.abs(smooth[first:] - smooth[first]) > least
    if not gone.any():
        return first
    there = first + int(np.argmax(gone))
    ahead = np.sign(smooth[there] - smooth[first]) * speed.velocity[first : there + 1]
    back = np.flatnonzero(ahead < speed.still)
    return first + int(back[-1]) + 1 if back.size else first


def fallen_since(signal: Signal, speed: Speed, first: int) -> tuple[int, bool]:
    """The sample about which it fell: of a leg that a hand's sway moved from `first` on, later.

    And whether a hand moved it, and slower again, before.
    """
    begin, end = great_swing(signal, speed)
    falls = speed.velocity[begin : end + 1].mean() < 0  # a leg that a hand lifts does not
    about = before_fall(signal.time, -speed.velocity, begin, end) if falls else None
    if about is not None and end > first:
        at = int(np.searchsorted(signal.time, about))
        since = int(np.searchsorted(signal.time, about - SWAYED))
        if slowed(speed, slice(since, max(begin, at))):
            return at, True
    return fallen_after(signal, speed, first), False


def fallen_after(signal: Signal, speed: Speed, first: int) -> int:
    """The same of a leg that a hand moved one way from `first` on."""
    smooth, _ = smoothed(signal, speed.width)
    gone = np.abs(smooth[first:] - smooth[first]) > SWAY
    if not gone.any():
        return first
    there = first + int(np.argmax(gone))
    if smooth[there] > smooth[first]:
        return first  # lifted
    since = SINCE * SWAY / max(abs(speed.velocity[there]), speed.still)
    about = signal.time[there] - since
    if about - signal.time[first] <= max(HOLD, speed.width):
        return first
    before = int(np.searchsorted(signal.time, about - speed.width))
    fastest = float(np.abs(speed.velocity[first:before]).max())
    swayed = fastest < max(SWAYING, speed.still)
    return int(np.searchsorted(signal.time, about)) if swayed else first


def moving(time: Samples, speed: Speed) -> list[tuple[int, int]]:
    """The stretches between rests; a rest lasts, or is at an end of the record."""
    moves = np.ones(time.size, dtype=bool)
    for first, last in runs(np.abs(speed.velocity) < speed.still):
        lasts = time[last] - time[first]
        if lasts >= REST or (first == 0 or last == time.size - 1):
            moves[first : last + 1] = False
    return runs(moves)


def released(
    signal: Signal, speed: Speed, first: int, room: tuple[float, ...] = ODD, *, swayed: bool = False
) -> LettingGo | None:
    """How the leg that first moves at `first` was let go; None where it begins in motion."""
    both = signal.samples
    speed = speed if both is signal else speed_of(both)
    found = looked_into(both, speed, first, room, swayed)
    if found is None or both.velocity is None or found.misfit < CONTRARY:
        return found
    alone = looked_into(replace(both, velocity=None), speed, first, room, swayed)
    return found if alone is None or alone.misfit > SOUND else alone


@remembered  # by far the most of the search, and the same of every drop whoever asks
def looked_into(
    signal: Signal, speed: Speed, first: int, room: tuple[float, ...], swayed: bool
) -> LettingGo | None:
    time = signal.time
    # Within half a window from the first sample nobody sees whether it moves.
    seen = first > 0
    about = float(time[first]) if seen else float(time[0]) + speed.width / 2
    early = HOLD + speed.width
    last = min(int(np.searchsorted(time, about + FALL)), time.size - 1)
    pull = abs(float(speed.velocity[last])) / FALL
    sway = 0.0 if swayed else swaying(signal, speed, about - early)
    held, late = (0.0, HOLD) if swayed or sway else (HELD, speed.width / 2)
    sooner = HOLD / 2 if swayed else early  # one acceleration of a hand looks like another's begin
    inside = (time >= about - early - held) & (time <= about + FALL)
    case = ReleaseWindow(beside(signal.part(inside), sway).averaged(BLOCK), pull, room, swayed)
    found = let_go(case, max(about - sooner, float(time[0])), about + late)
    if not seen and begun_free(case) < found.chi_square + ODDS * max(1.0, found.misfit):
        return None
    return found


def swaying(signal: Signal, speed: Speed, at: float) -> float:
    """How fast a hand moves the leg that it keeps, at a time [rad/s]; 0 where it keeps it still."""
    if at - signal.time[0] < speed.width / 2:
        return 0.0
    moved = float(speed.velocity[np.searchsorted(signal.time, at)])
    return moved if abs(moved) > speed.still else 0.0


def beside(signal: Signal, speed: float) -> Signal:
    """As one sees it who moves as a swaying hand did [rad/s]: there too a leg falls from rest."""
    velocity = None if signal.velocity is None else signal.velocity - speed
    return replace(signal, angle=signal.angle - speed * signal.time, velocity=velocity)


def nearest(time: Samples, at: float) -> int:
    return int(np.argmin(np.abs(time - at)))
