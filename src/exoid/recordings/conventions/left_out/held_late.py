"""How late values are that come evenly, and are written at the next time of a faster logger.

A value that was measured at t_k = t_0 + k T stands first at the next sample, up to a logger's step
later: evenly spread between none and a step where T is no multiple of it. What is late by that,
times how fast the leg moves, looks like a tone where the two rates beat.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples, usual_step

NEAR = 0.05  # relative, of the mean distance of values, that their period is sought within
FINER = 8  # times as fine as a recording's duration tells frequencies apart
EVENLY = 12**-0.5  # standard deviation of what is evenly spread over 1
SPREAD = (0.5, 1.2)  # times that, between which the values are as late as that
FEWEST = 30  # values that tell it

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Beat:
    """When values come, and how late they are at most."""

    period: float  # s
    centre: float  # s, a time at which one stands first that is as late as usual
    step: float  # s, of the logger

    def late(self, first: Samples) -> Samples:
        """How long before these times the values were measured [s]."""
        return np.clip(self.apart(first) / self.step + 0.5, 0.0, 0.999) * self.step

    def apart(self, first: Samples) -> Samples:
        """How much later than usual they stand first [s]."""
        half = self.period / 2
        return (first - self.centre + half) % self.period - half


def beat(first: Samples, step: float, usual: float) -> Beat | None:
    """How values come that stand first at these times, `usual` seconds apart on average; None where
    they do not come evenly, or at every so many samples.

    The times are in phase by the true period more than by any near it.
    """
    if first.size < FEWEST:
        return None
    reach = np.ceil(2 * NEAR * FINER * np.ptp(first) / usual)
    frequencies = np.linspace(1 - NEAR, 1 + NEAR, int(reach) + 1) / usual
    phases = np.exp(2j * np.pi * frequencies[:, None] * first).mean(axis=1)
    most = int(np.argmax(np.abs(phases)))
    period = 1 / float(frequencies[most])
    found = Beat(period, float(np.angle(phases[most])) / (2 * np.pi) * period, step)
    spread = float(np.std(found.apart(first))) / (EVENLY * step)
    return found if SPREAD[0] < spread < SPREAD[1] else None


def on_time(time: Samples, samples: Samples, taken: Mask, found: Beat) -> Samples:
    """The samples that are taken as they were when they stand first, by a cubic through them."""
    from scipy.interpolate import CubicSpline  # seldom needed, and long to import

    known = taken & ~np.isnan(samples)
    first = time[known]
    curve = CubicSpline(first - found.late(first), samples[known])
    changed = samples.copy()
    changed[known] = curve(first, extrapolate=True)
    return changed


def beat_of(time: Samples, starts: Mask, moves: Mask) -> Beat | None:
    """How the values of one segment come, by those that begin where its signal moves."""
    lengths = np.diff(np.flatnonzero(starts), append=starts.size)[moves[starts]]
    step = usual_step(time)
    return beat(time[starts & moves], step, step * float(lengths.mean())) if lengths.size else None
