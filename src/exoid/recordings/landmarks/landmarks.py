"""The places of a drop that its measures are read from, each found or refused with the reason."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.expected_rest import LAST, expected_rest, middles
from exoid.recordings.landmarks.impact.impact import Impact
from exoid.recordings.landmarks.local_polynomial import LocalPolynomials, local
from exoid.recordings.landmarks.measure import NotAllowed, given, ordinal
from exoid.recordings.landmarks.peak import fastest
from exoid.recordings.landmarks.release import Release
from exoid.recordings.landmarks.rest import CutBefore, Rest
from exoid.recordings.landmarks.swing import Curve, back, curve
from exoid.recordings.landmarks.track import DEGREE, HALF, SURE, Peak, Track, nearest
from exoid.recordings.measured.samples import Samples

MISSED_LESS = (
    2**DEGREE - 1
)  # times less of a slope is missed over half the time than both differ by
MISSED_BEND = 0.5  # of what both differ by beside a sharp stop or reflex: 0.2, seldom 0.7
SWINGING = 0.03  # of a velocity, by which both differ at most in a swing of up to 10 rad/s


@dataclass(frozen=True, eq=False)
class Landmarks:
    """Release, turning points and rest of one drop."""

    track: Track
    begin: float  # s, of the first sample of the fall
    turns: list[Peak]  # flexion and extension in turn
    released: Release | NotAllowed
    rested: Rest | NotAllowed
    held: NotAllowed | None  # why it did not fall freely at first
    uncounted: NotAllowed | None = None  # why turns after the last are not counted
    impacts: tuple[Impact, ...] = ()  # that made some of the turns

    @property
    def free_turns(self) -> list[Peak]:
        """The turns after the last that an impact made: those before it say nothing of the next."""
        struck = max((each.time for each in self.impacts), default=-np.inf)
        return [each for each in self.turns if each.time > struck]

    @property
    def release(self) -> Release:
        """The release; refused where there is none, or a hand was still on the leg."""
        self.check_fall()
        found = given(self.released)
        self.track.check_seen(found.start.time, HALF)
        return found

    def check_fall(self) -> None:
        """Refuse what the first swing tells, where it was not a free fall."""
        if self.held is not None:
            raise self.held

    @property
    def rest(self) -> Rest:
        return given(self.rested)

    @property
    def expected_rest(self) -> Peak:
        """The angle of rest; of a leg that was caught before, or whose record was cut, the
        one that its swings shrink to, which the error allows to move on as it last did.
        """
        if not isinstance(self.rested, CutBefore):
            return self.rest.angle
        self.check_counted()
        for each in self.turns:
            self.track.check_seen(each.time)
        found = expected_rest(self.turns)
        start = self.released.start if isinstance(self.released, Release) else None
        ends = self.turns if start is None or self.held else [start, *self.turns]
        moved = float(np.ptp(middles(ends)[-LAST:]))
        return replace(found, error=float(np.hypot(found.error, moved)))

    def flexion(self, number: int) -> Peak:
        """The peak of the number-th flexion, from 1."""
        return self.turn(2 * number - 2, f"{ordinal(number)} flexion")

    def extension(self, number: int) -> Peak:
        """The peak of the number-th extension, from 1; of number 0 the start of the fall."""
        if number == 0:
            return self.release.start
        return self.turn(2 * number - 1, f"{ordinal(number)} extension")

    def check_counted(self) -> None:
        """Refuse what needs every turn of the leg, where a hole hides some."""
        if self.uncounted is not None:
            raise self.uncounted

    def turn(self, number: int, what: str) -> Peak:
        if number >= len(self.turns):
            self.check_counted()
            raise NotAllowed(
                f"too few swings: there is no peak of the {what}, with a swing back of "
                f"{np.degrees(back(self.track)):.2g} deg after it"
            )
        found = self.turns[number]
        self.track.check_seen(found.time)
        return found

    @cached_property
    def curve(self) -> Curve:
        """The whole drop with its derivatives, for pictures: dear, and nothing is read off it."""
        return curve(self.track, self.released if isinstance(self.released, Release) else None)

    @cached_property
    def first_swings(self) -> tuple[Samples, LocalPolynomials, LocalPolynomials]:
        """The samples of the first two swings, and the polynomials around each over the usual time
        and over twice as much.
        """
        time = self.track.time
        end = max((each.time for each in self.turns[:2]), default=self.begin)
        time = time[(time >= self.begin) & (time <= end)]
        sharp, wide = (local(self.track, time, self.begin, half) for half in (HALF, 2 * HALF))
        return time, sharp, wide

    def struck(self, begin: float, end: float) -> Peak | None:
        """Where an impact accelerates most to extension between two times; None without one."""
        hits = [each for each in self.impacts if begin <= each.time <= end and each.gained > 0]
        if not hits:
            return None
        hit = max(hits, key=lambda each: each.acceleration)
        near = nearest(self.track, hit.time)
        return Peak(near, hit.time, HALF, hit.acceleration, hit.acceleration_error)

    def steepest(self, order: int, sign: int, begin: float, end: float) -> Peak:
        """Where a derivative is greatest (sign 1) or least (-1) between two times of the first two
        swings.

        Polynomials over twice the time say near where: the place at which noise lifts it would be
        read too high. A velocity's short peak, as before a reflex, they miss: where the others
        surely find more elsewhere, it is there.
        """
        times, sharp, wide = self.first_swings
        inside = np.flatnonzero((times >= begin) & (times <= end))
        if not inside.size:
            raise NotAllowed("that part of the swing was not recorded")
        at = int(inside[np.argmax(sign * wide.value(order)[inside])])
        self.track.check_seen(float(times[at]), HALF)
        time, place = float(times[at]), sharp.only(at)
        if order == 1:
            return self.fastest_at(self.highest(at, inside, sign), sign)
        value, error = place.derivative(order)
        beside = (np.abs(times - time) <= HALF / 2) & (times > self.begin + HALF)
        apart = np.abs(sharp.value(order) - wide.value(order))
        missed = MISSED_BEND * max(apart[at], float(np.sqrt(np.mean([0.0, *apart[beside] ** 2]))))
        unsure = float(np.hypot(error[0], missed))
        return Peak(nearest(self.track, time), time, HALF, float(value[0]), unsure)

    def highest(self, at: int, inside: NDArray[np.int_], sign: int) -> int:
        """The sample of the first swings among those `inside` where the velocity surely is greater
        than at one, or that one.
        """
        _, sharp, _ = self.first_swings
        other = int(inside[np.argmax(sign * sharp.value(1)[inside])])
        return other if surely_more(sharp.only(other), sharp.only(at), sign) else at

    def fastest_at(self, at: int, sign: int) -> Peak:
        """The extreme of velocity next to a sample of the first swings. Of a peak shorter than a
        swing's both polynomials miss a part.
        """
        times, sharp, wide = self.first_swings
        after, value, error = fastest(sharp.only(at), sign)
        apart = float(sharp.value(1)[at] - wide.value(1)[at])
        short = abs(apart) > SWINGING * abs(value)
        missed = apart * MISSED_BEND if short else apart / MISSED_LESS
        time = float(times[at]) + after
        self.track.check_seen(time, HALF)
        return Peak(nearest(self.track, time), time, HALF, value, float(np.hypot(error, missed)))


def surely_more(one: LocalPolynomials, other: LocalPolynomials, sign: int) -> bool:
    """Is the angular velocity at the centre of `one` surely greater (sign 1) or less (-1)?"""
    (value, error), (before, unsure) = one.derivative(1), other.derivative(1)
    return bool(sign * (value - before)[0] > SURE * np.hypot(error, unsure)[0])
