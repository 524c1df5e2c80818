"""The noise of a sampled signal: its size and its tails, told from the samples themselves."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.recording import Sensors
from exoid.recordings.samples import Samples
from exoid.recordings.signal.tone import Tone

NEIGHBOURS = 3  # on either side: a quintic, from which a leg departs by 1e-5 rad even at 30 Hz
REACH = 2 * NEIGHBOURS + 1
OFFSETS = [offset for offset in range(-NEIGHBOURS, NEIGHBOURS + 1) if offset]
EVENLY = [
    0.05,
    -0.3,
    0.75,
    0.75,
    -0.3,
    0.05,
]  # of neighbours in a quintic, evenly apart
ALIKE = 1e-7  # of a step, to which neighbours are evenly apart: a leg moves 1e-8 rad in it
FAR = 5.0  # standard deviations of a spike: of clean samples one in 1.7 million
SMALLEST = 1e-3  # rad or rad/s, of a spike: smaller ones change nothing, and a release has them
STILL, MOVING = 1.0, 2.0  # range of seven samples, over what a spike departs by at least
CLUSTER = 5  # samples, among which more than one spike are no spikes but an event
ROUNDS = 30  # each takes the worst sample of every neighbourhood
AGREE = 2.0  # factor between measured and declared noise, from which on it is worth a word
MORE = 1.5  # times the declared noise: samples that scatter by more are believed; jumps make 1.4
SHARED = 2.0  # times white noise and motion, that wider neighbourhoods must show
CLOSE, WIDEST = 0.051, 0.1  # s between neighbours: where smoothing shows at last, and motion does
STRIDES = 60  # neighbourhoods that are tried at most
SWING, QUICK = 0.2, 8.0  # rad, rad/s: how much, and how fast, a leg swings most of the time
TELLING = 20_000  # samples of all segments, which tell a scatter to 0.6 %
FEWEST = 30  # samples that tell a noise to 15 %
HEAVY = 1.15  # root mean square over robust deviation, from which on tails are worth a word
NORMAL = 0.6745  # median of |x| over the standard deviation
NONE = 1e-6  # noise of a signal without any: below every sensor's
ROUNDING = 1e-7  # rad or rad/s, of numbers in a file: no step of a sensor
EVEN = 0.05  # of a step: differences that are as close to multiples of it on average are multiples


@dataclass(frozen=True)
class Noise:
    """The white noise of one channel of a recording, and what else scatters in it.

    `level` is what a fit counts with: the declared noise, unless the samples scatter by more. A
    declaration that is too large stays: it may mean errors that neighbouring samples share.
    """

    level: float  # standard deviation of a sample, with what an encoder's steps add
    measured: float | None = None  # None where too few samples tell
    declared: float | None = None  # None where the sidecar is silent
    heaviness: float = 1.0  # root mean square over robust deviation; 1 for a normal distribution
    spikes: int = 0  # samples left out
    samples: int = 0
    tone: Tone | None = None  # taken out
    drift: float | None = None  # of a gyro's zero, root mean square; taken out
    alike_over: float = 0.0  # s over which errors are alike, of an angle that was smoothed

    @property
    def contradicted(self) -> bool:
        """Is the declaration off by more than a factor of two?"""
        if self.declared is None or self.measured is None:
            return False
        return not bool(1 / AGREE <= self.measured / self.declared <= AGREE)

    @property
    def heavy(self) -> bool:
        """Are large errors more frequent than in a normal distribution?"""
        return bool(self.heaviness > HEAVY)


def declared_angle_noise(sensors: Sensors, signals: list[Samples]) -> float | None:
    """What the sidecar says [rad], with what the encoder's steps add; None where it is silent.

    Steps that nobody declared are seen in the samples.
    """
    if sensors.angle_noise is None:
        return None
    counts = sensors.encoder_counts
    step = quantum(signals) if counts is None else 2 * np.pi / counts
    return float(np.hypot(sensors.angle_noise, step / np.sqrt(12)))


def noise_of(
    times: list[Samples], signals: list[Samples], declared: float | None, *, angle: bool = False
) -> Noise:
    """The noise of one channel from all its segments, beside what is `declared`.

    A sample is compared with the quintic through its neighbours, which sees white noise whatever
    the leg does. Errors beyond five robust deviations do not count: see `find_spikes`. An `angle`
    that was smoothed or interpolated has errors that neighbours share: see `smoothed`.
    """
    errors = np.concatenate(
        [interpolation_errors(*each) for each in zip(times, signals, strict=True)]
    )
    errors = errors[~np.isnan(errors)]
    step = quantum(signals) / np.sqrt(12)
    if errors.size < FEWEST:
        return Noise(max(declared or step, NONE), None, declared, samples=errors.size)
    robust = robust_deviation(errors, step)
    inside = errors[np.abs(errors) <= FAR * robust]
    measured = max(float(np.sqrt(np.mean(inside**2))), step, NONE)
    heaviness, width = measured / robust, 0.0
    if angle:
        measured, width = smoothed(times, signals, measured)
    level = measured if declared is None or measured > MORE * declared else declared
    return Noise(level, measured, declared, heaviness, samples=errors.size, alike_over=width)


def smoothed(times: list[Samples], signals: list[Samples], white: float) -> tuple[float, float]:
    """The noise that an angle had before it was smoothed, and over how many seconds [s] its errors
    are alike now; `white` and 0 where neighbours share nothing.

    White noise shows the same beside neighbours far and near, smoothed noise ever more. As many
    independent errors as there are such stretches tell a mean as well as white noise would that is
    larger by the root of the samples in a stretch.
    """
    step = float(np.median(np.diff(times[0])))
    level, width, most = white, 0.0, max(TELLING // len(times), FEWEST)
    for stride in np.unique(np.geomspace(2, max(WIDEST / step, 2), STRIDES).astype(int)).tolist():
        if not width and stride * step > CLOSE:
            break
        errors = [
            interpolation_errors(*each, stride, most) for each in zip(times, signals, strict=True)
        ]
        found = np.concatenate(errors)
        if np.count_nonzero(~np.isnan(found)) < FEWEST:
            break
        scatter = robust_deviation(found)
        bend = SWING * (2 * np.sin(QUICK * stride * step / 2)) ** 6 / 20
        if scatter > max(SHARED * np.hypot(white, bend), level / np.sqrt(max(width / step, 1.0))):
            level, width = scatter * np.sqrt(stride), stride * step
    return level, width


def interpolation_errors(
    time: Samples, samples: Samples, stride: int = 1, most: int | None = None
) -> Samples:
    """By how much every sample departs from the quintic through its three known neighbours on
    either side, `stride` samples apart, scaled to scatter as the noise does.

    nan for missing samples, for those at either end, and where there are too few; with `most`, for
    all but about so many, evenly taken.
    """
    known = np.flatnonzero(~np.isnan(samples))
    errors = np.full(samples.size, np.nan)
    if known.size <= 2 * NEIGHBOURS * stride:
        return errors
    first, last = NEIGHBOURS * stride, known.size - NEIGHBOURS * stride
    skip = max((last - first) // most, 1) if most else 1

    def beside(each: NDArray, offset: int) -> NDArray:
        return each[first + offset * stride : last + offset * stride : skip]

    clock, values = time[known], samples[known]
    near = np.stack([beside(values, offset) for offset in OFFSETS])
    departure = (beside(values, 0) - np.array(EVENLY) @ near) / np.sqrt(1 + np.square(EVENLY).sum())
    steps = np.diff(clock)
    if np.ptp(steps) > ALIKE * steps[0]:
        lags = np.stack([beside(clock, offset) - beside(clock, 0) for offset in OFFSETS])
        step = lags[-1] / NEIGHBOURS
        off = np.abs(lags - np.array(OFFSETS)[:, None] * step).max(axis=0) > ALIKE * step
        weights = lagrange(lags[:, off])
        missed = beside(values, 0)[off] - np.sum(weights * near[:, off], axis=0)
        departure[off] = missed / np.sqrt(1 + np.sum(weights**2, axis=0))
    errors[beside(known, 0)] = departure
    return errors


def lagrange(lags: NDArray[np.float64]) -> NDArray[np.float64]:
    """What each neighbour (first axis) counts in the polynomial through all of them."""
    weights = np.ones_like(lags)
    for one, weight in enumerate(weights):
        for other, lag in enumerate(lags):
            if one != other:
                weight *= lag / (lag - lags[one])
    return weights


def find_spikes(time: Samples, samples: Samples, least: float = 0.0) -> NDArray[np.bool_]:
    """Which samples stand alone, farther from their neighbours than noise throws one; `least` is
    what the noise is at least.

    Where the sample is taken away its neighbours agree with each other. A jump that lasts (a stop
    that is hit, play that ends) leaves more than one in a row: that is motion, and stays. Two close
    to each other go where both are beyond all around them.
    """
    found = np.zeros(samples.size, dtype=bool)
    errors = interpolation_errors(time, samples)
    if np.isnan(errors).all():
        return found
    least = max(least, quantum([samples]) / np.sqrt(12))
    limit = max(FAR * robust_deviation(errors, least), SMALLEST)
    for _ in range(ROUNDS):
        size = np.nan_to_num(np.abs(errors))
        around = np.lib.stride_tricks.sliding_window_view(np.pad(size, NEIGHBOURS), REACH)
        worst = (size > limit) & (size == around.max(axis=1))
        if not worst.any():
            break
        found |= worst
        errors = interpolation_errors(time, np.where(found, np.nan, samples))
    found = pardoned(time, samples, found, limit)
    kept = np.where(found, np.nan, samples)
    single, pair = alone(found, 1), alone(found, 2)
    for at in np.flatnonzero(found):
        before, after = kept[max(at - REACH, 0) : at], kept[at + 1 : at + 1 + REACH]
        bend = begins_or_ends(before, after, limit)
        wild = stands_out(samples[at], before, after, limit)
        found[at] = pair[at] if wild else single[at] and not bend
    return found


def stands_out(sample: float, before: Samples, after: Samples, limit: float) -> bool:
    """Is it beyond all that is around it? Where the signal jumps or bends it lies between."""
    around = np.concatenate([before, after])
    if np.isnan(around).all():
        return False
    return not np.nanmin(around) - limit < sample < np.nanmax(around) + limit


def begins_or_ends(before: Samples, after: Samples, limit: float) -> bool:
    """Is the signal still on one side only? A gyro bends where a leg is let go."""
    if np.isnan(before).all() or np.isnan(after).all():
        return False
    still, moving = sorted(np.nanmax(each) - np.nanmin(each) for each in (before, after))
    return bool(still <= STILL * limit and moving > MOVING * limit)


def pardoned(
    time: Samples, samples: Samples, found: NDArray[np.bool_], limit: float
) -> NDArray[np.bool_]:
    """Without the samples that only stood beside a spike: they agree with what is left."""
    found = found.copy()
    for at in np.flatnonzero(found):
        near = slice(max(at - 3 * REACH, 0), at + 3 * REACH + 1)
        kept = np.where(found[near], np.nan, samples[near])
        kept[at - near.start] = samples[at]
        error = interpolation_errors(time[near], kept)[at - near.start]
        found[at] = abs(error) > limit  # not where nothing is left to compare with
    return found


def alone(found: NDArray[np.bool_], most: int) -> NDArray[np.bool_]:
    """Without crowds of more than `most`: what jumps and stays leaves many in a row."""
    crowd = np.convolve(found, np.ones(CLUSTER), mode="same") > most
    return found & ~(np.convolve(crowd, np.ones(CLUSTER), mode="same") > 0)


def robust_deviation(errors: Samples, least: float = 0.0) -> float:
    """The standard deviation of a normal distribution with this median size."""
    median = float(np.nanmedian(np.abs(errors))) / NORMAL
    return max(median, least) or float(np.nanstd(errors)) or NONE


def quantum(signals: list[Samples]) -> float:
    """The step of a signal that only takes multiples of one, 0 where it has none."""
    values = np.unique(np.concatenate([each[~np.isnan(each)] for each in signals]))
    steps = np.diff(values)
    steps = steps[steps > ROUNDING]
    if steps.size < FEWEST:
        return 0.0
    step = float(steps.min())
    parts = steps / step
    return step if np.abs(parts - np.round(parts)).mean() < EVEN else 0.0
