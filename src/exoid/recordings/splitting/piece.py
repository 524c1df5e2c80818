"""A movement of a continuous recording, between two rests."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.protocol import Kind
from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.thresholds import SWINGS
from exoid.recordings.signal.condition import RINGING, reversals


@dataclass(frozen=True)
class Piece:
    """A movement between two rests: its samples, and what it is."""

    start: int
    stop: int  # one past its last sample
    kind: Kind | None  # None where a hand moved the leg
    name: str
    lifted: int | None = None  # the sample from which a hand lifted a leg that had swung out

    @property
    def samples(self) -> slice:
        return slice(self.start, self.stop)


def rings(angle: Samples) -> bool:
    """Does a lift end in ever smaller swings? No hand does that: it is a leg that was let go, in a
    file that counts the angle otherwise.
    """
    middle = int(np.argmax(angle > (angle[0] + angle[-1]) / 2))
    turns = angle[middle:][reversals(angle[middle:], RINGING * float(np.ptp(angle)))]
    swings = np.abs(np.diff(turns))
    return swings.size >= SWINGS and bool((np.diff(swings) < 0).all())
