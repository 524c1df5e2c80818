"""The swings of a drop: where the leg turned around, and how fast it moved and accelerated."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.landmarks.impact.impact import Impact, impact_at
from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.peak import peaks
from exoid.recordings.landmarks.release import Release
from exoid.recordings.landmarks.track import HALF, Peak, Track, nearest
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.condition import reversals
from exoid.recordings.signal.local_line import local_line

SMALLEST = np.radians(1.0)  # rad, of a swing that counts as one
CLEAR = 8.0  # times the noise of the smoothed angle, which at rest spans six


@dataclass(frozen=True, eq=False)
class Curve:
    """Angle, angular velocity and acceleration from the release to the end."""

    time: Samples  # s
    angle: Samples  # rad
    velocity: Samples  # rad/s
    acceleration: Samples  # rad/s^2


def turns(track: Track, begin: float) -> list[Peak]:
    """The turning points after `begin` [s], flexion and extension in turn.

    One counts once the leg has swung back from it by a degree. The first may be an extension,
    where the leg did not fall at first.
    """
    first = int(np.searchsorted(track.time, begin))
    return peaks(track, [first + at for at in turned(track, first)], begin)


def with_impacts(track: Track, found: list[Peak], begin: float) -> tuple[list[Peak], list[Impact]]:
    """The turns, flexion and extension in turn, with those that an impact makes as that tells, and
    these impacts.
    """
    after = track.part(slice(int(np.searchsorted(track.time, begin)), None))
    each = [
        impact_at(after.time, after.angle, track.noise, turn.time, 1 - number % 2 * 2)
        for number, turn in enumerate(found)
    ]
    told = [
        turn if hit is None else struck(track, hit) for turn, hit in zip(found, each, strict=True)
    ]
    return told, [hit for hit in each if hit is not None]


def struck(track: Track, hit: Impact) -> Peak:
    """The turn that an impact makes."""
    near = nearest(track, hit.time)
    return Peak(near, hit.time, hit.time_error, hit.value, hit.error)


def turned(track: Track, first: int = 0) -> list[int]:
    """The samples from `first` on at which the smoothed angle turns around."""
    return reversals(local_line(track.time, track.angle, HALF)[0][first:], back(track))


def back(track: Track) -> float:
    """By how much a leg must swing back [rad]."""
    return max(SMALLEST, CLEAR * track.smoothed_noise(HALF))


def curve(track: Track, release: Release | None) -> Curve:
    """The drop and its derivatives; right after a release, those of the fall from rest."""
    begin = track.time[0] if release is None else release.start.time
    time = track.time[track.time >= begin]
    each = local(track, time, begin)
    orders = [each.derivative(order)[0] for order in range(3)]
    if release is not None:
        fresh = np.flatnonzero(time < begin + HALF)
        for order, values in enumerate(orders):
            after = time[fresh] - begin
            values[fresh] = release.derivative(order, after)[0]
    return Curve(time, *orders)
