"""The free movements of all drops of a recording: what one tells shows a hand in another.

By itself a drop that was caught in its first swings hardly tells where the leg would have come to
rest.
"""

from dataclasses import dataclass, replace
from functools import lru_cache

from exoid.recordings.motion.acceleration import Law, derivatives, law_of
from exoid.recordings.motion.extent import Extent, Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.free_end import free_end
from exoid.recordings.motion.own_reversal import swung_freely
from exoid.recordings.motion.signal import Signal, signal_of, speed_of
from exoid.recordings.motion.swings import Swings
from exoid.recordings.motion.thresholds import MARKED, SHORTEST
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import classify

Setup = tuple[float, float | None, float]  # added mass [kg], its distance [m], thigh's angle [rad]


def find_drop(recording: Recording, number: int) -> Extent:
    """The free movement of one segment, in view of the others of its kind.

    **Raises** `Motionless` where nothing moves in it.
    """
    found = find_drops(recording)[number]
    if isinstance(found, Motionless):
        raise found
    return found


def find_drops(recording: Recording) -> dict[int, Extent | Motionless]:
    """Of every passive segment, by its number."""
    return compared(recording).found


def law_for(recording: Recording, number: int) -> Law | None:
    """What all drops like this segment tell of the leg; None where it is the only one."""
    return compared(recording).laws.get(number)


@dataclass(frozen=True, eq=False)
class ComparedDrops:
    """Movements of passive segments, and the laws that showed where they end, by number."""

    found: dict[int, Extent | Motionless]
    laws: dict[int, Law]


@lru_cache(maxsize=8)  # every segment of a recording asks for it
def compared(recording: Recording) -> ComparedDrops:
    passive = [n for n in range(len(recording.segments)) if passively(recording, n)]
    signals = {n: signal_of(recording.segments[n], recording.sensors) for n in passive}
    handled = recording.subject.kind != "rig"
    found = {n: free_or_not(signal, handled, MARKED) for n, signal in signals.items()}
    moved = {n: each for n, each in found.items() if isinstance(each, Extent)}
    if not handled:
        return ComparedDrops(found, {})
    at_once = [n for n, each in moved.items() if each.held_until is None]
    if len(at_once) < len(moved) / 2:  # nobody marked this recording at its releases
        again = {n: free_or_not(signals[n], handled, SHORTEST) for n in at_once}
        moved |= {n: each for n, each in again.items() if isinstance(each, Extent)}
    laws: dict[int, Law] = {}
    for setup in dict.fromkeys(setup_of(recording, n) for n in moved):
        alike = [n for n in moved if setup_of(recording, n) == setup]
        law = law_of([(derivatives(signals[n]), sure(signals[n], moved[n])) for n in alike])
        if len(alike) > 1 and law is not None:
            laws |= dict.fromkeys(alike, law)
    ends = {n: ended(signals[n], moved[n], law) for n, law in laws.items()}
    return ComparedDrops(found | moved | ends, laws)


def passively(recording: Recording, number: int) -> bool:
    said = recording.kind(number) or classify(recording.segments[number]) or "passive"
    return said == "passive"


def setup_of(recording: Recording, number: int) -> Setup:
    return (
        recording.added_mass(number),
        recording.added_mass_distance(number),
        recording.thigh_angle(number),
    )


def free_or_not(signal: Signal, handled: bool, shortest: float) -> Extent | Motionless:
    try:
        return find_free(signal, handled=handled, shortest=shortest)
    except Motionless as fault:
        return fault


def seen_in(signal: Signal, extent: Extent) -> Swings:
    return swung_freely(signal, speed_of(signal), extent.start, extent.free)


def sure(signal: Signal, extent: Extent) -> slice:
    """The samples in which no hand can have been on the leg."""
    free = seen_in(signal, extent).sure
    return slice(free.start, max(min(free.stop, extent.stop), free.start + 1))


def ended(signal: Signal, extent: Extent, law: Law) -> Extent:
    """The same movement with its end by a law that all drops have told."""
    seen = seen_in(signal, extent)
    return replace(extent, **vars(free_end(signal, speed_of(signal), seen, handled=True, law=law)))
