"""A tone that moves a leg, as a tremor does, in what a simulation leaves of encoder and gyro."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.chi_square import chance_above, median_of
from exoid.recordings.measured.samples import Samples, robust_deviation, usual_step
from exoid.recordings.signal.both_sensors.sensor_scales import GYRO_SCALE
from exoid.recordings.signal.both_sensors.shared_motion import shared
from exoid.recordings.signal.tone import AROUND, FALSE, powers, spectrum, standing_out, unbroken

SLOWEST = 2.5  # Hz
OWN = 3.5  # times a leg's swing: what friction leaves of one is as fast, or three times
PERIODS, PIECE = 3.0, 0.4  # of the tone, and s, that a piece has at least
MOST = 0.6  # of what the gyro misses, that a tone is at least: what else is missed has no line
STEADY, SURGES = 0.4, 2.0  # of its size: three of four pieces exceed the one, one of four the other
FEWEST = 4  # pieces

Left = tuple[Samples, Samples, Samples]  # time [s], and what is left of angle and rate


@dataclass(frozen=True)
class LegTone:
    """A tone of a leg's motion."""

    frequency: float  # Hz
    amplitude: float  # rad, either way; median over pieces of the recording
    standard_error: float  # rad
    rate: float  # rad/s


def leg_tone(each: Sequence[Left], swing: float = 0.0) -> LegTone | None:
    """The tone that encoder and gyro show alike for as long as they record; None where none does.
    Of a leg that swings at `swing` Hz it is no harmonic.

    It makes up most of what is `left` of every segment's gyro, so that what a model misses
    otherwise, which dies out with the swings, is no tone.
    """
    parts = [known(*one) for one in each]
    parts = [one for one in parts if one[0].size > AROUND]
    slowest = max(SLOWEST, OWN * swing)
    frequency = line([(time, rate) for time, _, rate in parts], slowest) if parts else None
    if frequency is None:
        return None
    found = [piece for one in parts for piece in pieces(*one, frequency)]
    rate, slope = (np.array([one[at] for one in found]) for at in (0, 1))
    total, rest = (sum(one[at] for one in found) for at in (2, 3))
    sizes = np.hypot(*rate.T)
    size = float(np.median(sizes))
    least, most = np.quantile(sizes, [0.25, 0.75])
    steady = least > STEADY * size and most < SURGES * size
    if len(found) < FEWEST or not steady or rest > (1 - MOST) * total or not shared(rate, slope):
        return None
    error = float(np.hypot(robust_deviation(sizes - size) / np.sqrt(len(found)), GYRO_SCALE * size))
    turns = 2 * np.pi * frequency
    return LegTone(frequency, size / turns, error / turns, size)


def swing_of(motions: Sequence[tuple[Samples, Samples]]) -> float:
    """The frequency [Hz] of swings, from time [s] and rate: root mean square of its slope, over its
    own.
    """
    slopes = sum(float(np.sum(np.gradient(rate, time) ** 2)) for time, rate in motions)
    squares = sum(float(np.sum(rate**2)) for _, rate in motions)
    return float(np.sqrt(slopes / squares)) / (2 * np.pi) if squares else 0.0


def known(time: Samples, angle: Samples, rate: Samples) -> Left:
    """The samples that tell both, from the longest stretch without a pause."""
    together = np.where(np.isnan(angle), np.nan, rate)
    stretch, _ = max(unbroken(time, together), key=lambda one: one[0].size)
    inside = np.isin(time, stretch)
    return time[inside] - time[inside][:1], angle[inside], rate[inside]


def line(signals: list[tuple[Samples, Samples]], slowest: float) -> float | None:
    """The frequency [Hz], `slowest` or above, whose power over all signals stands out the most from
    those around it.
    """
    step = min(usual_step(time) for time, _ in signals)
    size = 2 * max(int(time[-1] / step) + 1 for time, _ in signals)
    grid = np.fft.rfftfreq(size, step)
    quick = grid >= slowest
    level = [(time, left - left.mean()) for time, left in signals]
    power = np.sum([spectrum(*one, step, size) for one in level], axis=0)[quick]
    freedom = 2 * len(signals)
    if power.size <= AROUND or not power.all():
        return None
    top, ratio = standing_out(power)
    if power.size * chance_above(freedom, ratio * median_of(freedom)) > FALSE:
        return None
    near = grid[quick][top] + grid[1] * np.arange(-1, 1, 0.05)
    return float(near[np.argmax(sum(powers(*one, near) for one in level))])


def pieces(
    time: Samples, angle: Samples, rate: Samples, frequency: float
) -> list[tuple[NDArray[np.float64], NDArray[np.float64], float, float]]:
    """Of every piece the tone's cosine and sine in the rate and in the slope of the angle, and the
    squares of the rate before and after they are taken out, beside a line.
    """
    turns = 2 * np.pi * frequency
    count = max(int(time[-1] / max(PERIODS / frequency, PIECE)), 1)
    found = []
    for at in np.array_split(np.arange(time.size), count):
        phase = turns * time[at]
        middle = time[at] - time[at].mean()
        columns = np.stack([np.ones(at.size), middle, np.cos(phase), np.sin(phase)], axis=1)
        signals = np.stack([rate[at], angle[at]], axis=1)
        told = np.linalg.lstsq(columns, signals, rcond=None)[0]
        left = rate[at] - columns @ told[:, 0]
        (cosine, sine), square = told[2:, 1], float(rate[at] @ rate[at])
        found.append((told[2:, 0], turns * np.array([sine, -cosine]), square, float(left @ left)))
    return found
