"""A steady tone in a signal: hum of the mains, as it is or aliased by the sampling.

A leg has no part in what is faster than nine times a second and never fades.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_lsq_spline
from scipy.ndimage import median_filter
from scipy.special import chdtrc, chdtri  # not scipy.stats: half a second of every command

from exoid.recordings.samples import Samples, usual_step

SLOWEST = 9.0  # Hz, of a tone that is no motion: tremor and clonus of a leg are slower
KNOT = 0.08  # s between the knots of the spline that is the motion
AROUND = 101  # frequencies, half the width of a line apart, that a tone stands out from
FALSE = 1e-4  # chance that noise alone shows a tone in a recording
FINER = 0.05  # of the search's own step, to which a frequency is refined
SMALLEST = 5e-4  # rad or rad/s, of a tone: smaller ones change nothing
MATTERS = 0.5  # of the noise
SEEN = 0.6  # of a tone, that is left beside a motion that is free to do what is slower
EDGE = 5  # frequencies beside the slowest, where a motion's kinks still show
STEADY = 0.4  # of its size, that a tone has in three of four pieces
SURGES = 2.0  # of its size, that it exceeds in no more than one of four: a frame that strikes does
IN_PHASE = 0.6  # of its size, that is left of the middle of its pieces: noise has any phase
PIECE, FEW = 0.3, 24  # s, and samples, of a piece at least
STRETCH = 5_000  # samples of one spline
PAUSE = 1.0  # s without a sample
FEWEST = 64  # samples of a segment that can tell a tone


@dataclass(frozen=True)
class Tone:
    """A tone that was found."""

    frequency: float  # Hz, as sampled
    amplitude: float  # of the signal, median over pieces of the recording


def find_tone(times: list[Samples], signals: list[Samples], noise: float = 0.0) -> Tone | None:
    """The strongest tone that all segments share, None where noise shows as much.

    The power at every frequency over the median of those around it: a line, not a hill. Every
    segment, and what follows a pause in it, has the phase to itself.
    """
    each = (unbroken(*one) for one in zip(times, signals, strict=True))
    parts = [part for parts in each for part in parts if part[0].size >= FEWEST]
    if not parts:
        return None
    rest = [(time - time[0], signal - motion(time, signal)) for time, signal in parts]
    step = min(usual_step(time) for time, _ in rest)
    size = 2 * max(int(time[-1] / step) + 1 for time, _ in rest)
    grid = np.fft.rfftfreq(size, step)
    each = [spectrum(time, left, step, size) for time, left in rest]
    power = np.sum(each, axis=0)[grid >= SLOWEST]
    freedom = 2 * len(rest)
    if power.size < FEWEST or not power.all():
        return None
    around = median_filter(power, AROUND, mode="mirror") / chdtri(freedom, 0.5)
    top = int(np.argmax(power / around))
    if top < EDGE or power.size * chdtrc(freedom, power[top] / around[top]) > FALSE:
        return None
    near = grid[grid >= SLOWEST][top] + grid[1] * np.arange(-1, 1, FINER)
    frequency = float(near[np.argmax(sum(powers(*each, near) for each in rest))])
    if min(visible(time, frequency) for time, _ in parts) < SEEN:
        return None
    pieces = [piecewise(*each, frequency) for each in parts]
    sizes = np.concatenate([np.hypot(*each.T) for each in pieces])
    size = float(np.median(sizes))
    least, most = np.quantile(sizes, [0.25, 0.75])
    steady = least > STEADY * size and most < SURGES * size
    in_phase = [float(np.hypot(*np.median(each, axis=0))) for each in pieces]
    one = np.average(in_phase, weights=[len(each) for each in pieces]) > IN_PHASE * size
    loud = size > max(SMALLEST, MATTERS * noise)
    return Tone(frequency, size) if steady and one and loud else None


def unbroken(time: Samples, signal: Samples) -> list[tuple[Samples, Samples]]:
    """The known samples between pauses."""
    known = ~np.isnan(signal)
    time, signal = time[known], signal[known]
    begins = np.flatnonzero(np.diff(time) > PAUSE) + 1
    return list(zip(np.split(time, begins), np.split(signal, begins), strict=True))


def piecewise(time: Samples, signal: Samples, frequency: float) -> NDArray[np.float64]:
    """Cosine's and sine's amplitude in every piece of 0.3 s: jumps that come back have lines, but
    pauses too, and a kink is no tone elsewhere.
    """
    left = without_motion(time, signal, frequency)
    count = max(min(int((time[-1] - time[0]) / PIECE), time.size // FEW), 1)
    each = np.array_split(left, count)
    found = [np.linalg.lstsq(piece[:, 1:], piece[:, 0], rcond=None)[0] for piece in each]
    return np.array(found, dtype=np.float64)


def without_tone(time: Samples, signal: Samples, tone: Tone) -> Samples:
    """The signal less the tone, with the phase and size that it has there."""
    known = ~np.isnan(signal)
    if known.sum() < FEWEST:
        return signal
    return signal - waves(time, tone.frequency) @ coefficients(
        time[known], signal[known], tone.frequency
    )


def coefficients(time: Samples, signal: Samples, frequency: float) -> Samples:
    """Of cosine and sine, beside a motion that is free to do what is slower: the middle of all
    pieces, which no kink moves.
    """
    return np.median(piecewise(time, signal, frequency), axis=0)


def visible(time: Samples, frequency: float) -> float:
    """The share of a tone that no motion follows."""
    columns = waves(time, frequency)
    left = columns - motion(time, columns)
    return float(np.linalg.norm(left) / np.linalg.norm(columns))


def without_motion(time: Samples, signal: Samples, frequency: float) -> NDArray[np.float64]:
    """Signal, cosine and sine, each without what a motion could be."""
    columns = np.column_stack([signal, waves(time, frequency)])
    return columns - motion(time, columns)


def waves(time: Samples, frequency: float) -> NDArray[np.float64]:
    turns = 2 * np.pi * frequency * time
    return np.stack([np.cos(turns), np.sin(turns)], axis=1)


def spectrum(time: Samples, left: Samples, step: float, size: int) -> Samples:
    """Power at the frequencies of a grid of `size` steps, every sample at its nearest place."""
    placed = np.zeros(size)
    placed[np.round(time / step).astype(int)] = left
    return np.abs(np.fft.rfft(placed)) ** 2


def powers(time: Samples, left: Samples, grid: Samples) -> Samples:
    """What a tone of each frequency would explain of what is left [signal squared]."""
    turns = 2 * np.pi * np.outer(grid, time)
    return (np.cos(turns) @ left) ** 2 + (np.sin(turns) @ left) ** 2


def motion(time: Samples, signal: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of the signal (time first) that a cubic spline with a knot each 0.1 s follows; anew
    after so many samples, for its cost grows with their square.
    """
    parts = np.array_split(np.arange(time.size), -(-time.size // STRETCH))
    return np.concatenate([spline(time[part], signal[part]) for part in parts])


def spline(time: Samples, signal: NDArray[np.float64]) -> NDArray[np.float64]:
    count = max(int((time[-1] - time[0]) / KNOT), 1)
    places = np.linspace(0, time.size - 1, count + 1)[1:-1]  # as dense as the samples, gaps too
    inner = np.interp(places, np.arange(time.size), time)
    knots = np.concatenate([[time[0]] * 4, inner, [time[-1]] * 4])
    return np.asarray(make_lsq_spline(time, signal, knots, method="norm-eq")(time))
