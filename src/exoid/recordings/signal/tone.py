"""A steady tone in a signal: hum of the mains, as it is or aliased by the sampling.

A leg has no part in what is faster than nine times a second and never fades.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.chi_square import chance_above, median_of
from exoid.recordings.measured.samples import Samples, usual_step
from exoid.recordings.signal.spline import follow

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
AT_ONCE = 2**12  # medians: 3 MB
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
    rest = [
        (time - time[0], signal - moved)
        for (time, signal), moved in zip(parts, motions(parts), strict=True)
    ]
    step = min(usual_step(time) for time, _ in rest)
    size = 2 * max(int(time[-1] / step) + 1 for time, _ in rest)
    grid = np.fft.rfftfreq(size, step)
    each = [spectrum(time, left, step, size) for time, left in rest]
    power = np.sum(each, axis=0)[grid >= SLOWEST]
    freedom = 2 * len(rest)
    if power.size < FEWEST or not power.all():
        return None
    top, ratio = standing_out(power)
    if top < EDGE or power.size * chance_above(freedom, ratio * median_of(freedom)) > FALSE:
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


def standing_out(power: Samples) -> tuple[int, float]:
    """The frequency that is the most times the median of the `AROUND` about it, mirrored at both
    ends, and how many times.

    Three whole quarters of 25 are among 101, and 26 others: the median, the 51st, is no less than
    the 25th of those 75. Where the power is too small even for that, no median is asked for.
    """
    mirrored = np.pad(power, AROUND // 2, mode="reflect")
    quarter = AROUND // 4
    parts = np.lib.stride_tricks.sliding_window_view(mirrored, 3 * quarter)[::quarter]
    least = np.partition(parts, quarter - 1, axis=1)[:, quarter - 1]
    most = power / least[-(-np.arange(power.size) // quarter)]
    found = times_the_median(power, mirrored, np.argpartition(most, -FEWEST)[-FEWEST:])
    at = np.flatnonzero(most >= found.max())
    found = times_the_median(power, mirrored, at)
    return int(at[np.argmax(found)]), float(found.max())


def times_the_median(power: Samples, mirrored: Samples, at: NDArray[np.int_]) -> Samples:
    """How many times the median about it the power at some frequencies is."""
    windows, middle = np.lib.stride_tricks.sliding_window_view(mirrored, AROUND), AROUND // 2
    parts = [at[begin : begin + AT_ONCE] for begin in range(0, at.size, AT_ONCE)]
    medians = [np.partition(windows[part], middle, axis=1)[:, middle] for part in parts]
    return power[at] / np.concatenate(medians)


def motion(time: Samples, signal: NDArray[np.float64]) -> NDArray[np.float64]:
    """`motions` of one signal."""
    return motions([(time, signal)])[0]


def motions(signals: list[tuple[Samples, NDArray[np.float64]]]) -> list[NDArray[np.float64]]:
    """The part of every signal (time first) that a cubic spline with a knot each 0.08 s follows;
    anew after so many samples, for rounding grows with them.
    """
    counts = [-(-time.size // STRETCH) for time, _ in signals]
    pieces = [
        (time[at], signal[at])
        for (time, signal), count in zip(signals, counts, strict=True)
        for at in np.array_split(np.arange(time.size), count)
    ]
    followed = iter(follow(pieces, KNOT))
    return [np.concatenate([next(followed) for _ in range(count)]) for count in counts]
