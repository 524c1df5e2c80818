"""The places of a drop that its measures are read from, each found or refused with the reason."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.measure import NotAllowed, given, ordinal
from exoid.recordings.landmarks.release import Release
from exoid.recordings.landmarks.rest import Rest
from exoid.recordings.landmarks.swing import Curve, back
from exoid.recordings.landmarks.track import HALF, Peak, Track, nearest


@dataclass(frozen=True, eq=False)
class Landmarks:
    """Release, turning points and rest of one drop."""

    track: Track
    curve: Curve
    turns: list[Peak]  # flexion and extension in turn
    released: Release | NotAllowed
    rested: Rest | NotAllowed
    held: NotAllowed | None  # why it did not fall freely at first

    @property
    def release(self) -> Release:
        """The release; refused where there is none, or a hand was still on the leg."""
        self.check_fall()
        return given(self.released)

    def check_fall(self) -> None:
        """Refuse what the first swing tells, where it was not a free fall."""
        if self.held is not None:
            raise self.held

    @property
    def rest(self) -> Rest:
        return given(self.rested)

    def flexion(self, number: int) -> Peak:
        """The peak of the number-th flexion, from 1."""
        return self.turn(2 * number - 2, f"{ordinal(number)} flexion")

    def extension(self, number: int) -> Peak:
        """The peak of the number-th extension, from 1; of number 0 the start of the fall."""
        if number == 0:
            return self.release.start
        return self.turn(2 * number - 1, f"{ordinal(number)} extension")

    def turn(self, number: int, what: str) -> Peak:
        if number >= len(self.turns):
            raise NotAllowed(
                f"too few swings: there is no peak of the {what}, with a swing back of "
                f"{np.degrees(back(self.track)):.2g} deg after it"
            )
        return self.turns[number]

    def steepest(self, order: int, sign: int, begin: float, end: float) -> Peak:
        """Where a derivative is greatest (sign 1) or least (-1) between two times.

        Polynomials over twice the time say where: the place at which noise lifts it would be read
        too high.
        """
        track, first = self.track, float(self.curve.time[0])
        inside = self.curve.time[(self.curve.time >= begin) & (self.curve.time <= end)]
        if not inside.size:
            raise NotAllowed("that part of the swing was not recorded")
        wide = local(track, inside, first, 2 * HALF).derivative(order)[0]
        at = np.argmax(sign * wide)
        time = float(inside[at])
        value, error = local(track, inside[[at]], first).derivative(order)
        return Peak(nearest(track, time), time, HALF, float(value[0]), float(error[0]))
