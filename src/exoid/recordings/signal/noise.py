"""The noise of a sampled signal: its size and its tails, told from the samples themselves."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import Samples, quantile
from exoid.recordings.signal.neighbours import (
    NEIGHBOURS,
    Known,
    astride,
    at_rest,
    jumps_of,
    known_of,
)
from exoid.recordings.signal.scatter import FAR, FEWEST, NONE, quantum, robust_deviation
from exoid.recordings.signal.tone import Tone

AGREE = 2.0  # factor between measured and declared noise, from which on it is worth a word
MORE = 1.5  # times the declared noise: samples that scatter by more are believed; jumps make 1.4
SHARED = 2.0  # times white noise and motion, that wider neighbourhoods must show
CLOSE, WIDEST = 0.051, 0.1  # s between neighbours: where smoothing shows at last, and motion does
RESTING = 0.13  # s, the same of both in a leg at rest: errors that a filter of 4 Hz leaves
STILL = 0.1  # of how far a leg swings most of the time, that it swings at rest at most
STRIDES = 60  # neighbourhoods that are tried at most
SWING, QUICK = 0.2, 8.0  # rad, rad/s: how much, and how fast, a leg swings most of the time
OF_ANGLE, OF_RATE = SWING, SWING * QUICK  # rad, rad/s: how much the signal of a sensor swings then
TELLING = 20_000  # samples of all segments, which tell a scatter to 0.6 %
HINTING, HINT = 500, 0.7  # samples that tell it to 4 %, and the share of the limit to look closer
TURN = 0.2  # s between jumps, at least on average: steps that come faster are of an interpolation
QUIET = np.radians(0.003)  # of an angle: less than encoders and cameras on a leg scatter
HEAVY = 1.15  # root mean square over robust deviation, from which on tails are worth a word


@dataclass(frozen=True)
class Play:
    """How far a leg turns before its encoder follows."""

    width: float  # rad
    standard_error: float


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
    play: Play | None = None  # between a leg and its encoder; taken out
    alike_over: float = 0.0  # s over which errors are alike, where it was smoothed

    @property
    def contradicted(self) -> bool:
        """Is the declaration off by more than a factor of two?"""
        if self.declared is None or self.measured is None:
            return False
        return not bool(1 / AGREE <= self.measured / self.declared <= AGREE)

    @property
    def hidden(self) -> bool:
        """Does an angle scatter by less than a sensor on a leg can, and nobody declared it?"""
        return self.declared is None and bool(self.level < QUIET)

    @property
    def heavy(self) -> bool:
        """Are large errors more frequent than in a normal distribution?"""
        return bool(self.heaviness > HEAVY)


def of_hidden_noise(noise: Noise) -> str:
    """What is wrong with an angle whose noise is hidden, and what to do about it."""
    level = f"{np.degrees(noise.level):.4f}".rstrip("0").rstrip(".")
    return (
        f"the angle scatters by {level} deg only, less than a sensor on a leg does: a filter "
        "hides noise, and takes from peaks and releases what it smooths. Export the angle without "
        "one, or give angle_noise_rad in [sensors]"
    )


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
    times: list[Samples],
    signals: list[Samples],
    declared: float | None,
    *,
    swing: float | None = None,
) -> Noise:
    """The noise of one channel from all its segments, beside what is `declared`.

    A sample is compared with the quintic through its neighbours, which sees white noise whatever
    the leg does. Errors beyond five robust deviations do not count: see `spikes`. What was smoothed
    or interpolated has errors that neighbours share: see `smoothed`, which is asked where it is
    told how far the signal of a leg may `swing` (`OF_ANGLE`, `OF_RATE`).
    """
    known = [known_of(*each) for each in zip(times, signals, strict=True)]
    errors = np.concatenate([each.errors()[1] for each in known])
    step = quantum(signals) / np.sqrt(12)
    if errors.size < FEWEST:
        level = max(declared or of_few(errors), step, NONE)
        return Noise(level, None, declared, samples=errors.size)
    robust = robust_deviation(errors, step)
    inside = errors[np.abs(errors) <= FAR * robust]
    measured = max(float(np.sqrt(np.mean(inside**2))), step, NONE)
    heaviness, width = measured / robust, 0.0
    if swing is not None:
        measured, width = smoothed_or_not(known, measured, swing)
    level = measured if declared is None or measured > MORE * declared else declared
    return Noise(level, measured, declared, heaviness, samples=errors.size, alike_over=width)


def known_step(known: list[Known]) -> float:
    """The usual time between known samples [s]: where a gyro is faster, an angle has empty cells
    between them.
    """
    return quantile(np.concatenate([np.diff(each.time) for each in known]))


def of_few(errors: Samples) -> float:
    """The standard deviation of errors too few to tell it, by one of its own errors larger."""
    if not errors.size:
        return 0.0
    return float(np.sqrt(np.mean(errors**2))) * (1 + 1 / np.sqrt(2 * errors.size))


def smoothed_or_not(known: list[Known], white: float, swing: float) -> tuple[float, float]:
    """`smoothed` by all samples, and by those of rests, which nothing but noise moves: what shows
    more noise. Where a filter has left none, it has also taken from the motion.
    """
    step, still = known_step(known), STILL * swing
    near = max(CLOSE, 2.1 * step)  # of a slow camera there is nothing nearer
    found = smoothed(known, step, white, swing, (near, WIDEST))
    rests = [rest for each in known if (rest := at_rest(each, still)) is not None]
    if not rests or found[0] < QUIET:
        return found
    return max(found, smoothed(rests, step, white, still, (RESTING, RESTING)))


def smoothed(
    known: list[Known], step: float, white: float, swing: float, reach: tuple[float, float]
) -> tuple[float, float]:
    """The noise that a signal had before it was smoothed, and over how many seconds [s] its errors
    are alike now; `white` and 0 where neighbours share nothing. `step` is between known samples,
    `reach` how far they may be apart [s] where smoothing shows, and where noise is told.

    White noise shows the same beside neighbours far and near, smoothed noise ever more. As many
    independent errors as there are such stretches tell a mean as well as white noise would that is
    larger by the root of the samples in a stretch. Neighbours on both sides of a jump (a release, a
    catch, play at a turn) share nothing that smoothing left: they do not count.
    """
    close, widest = reach
    jumps = [jumps_of(each, FAR * white, TURN) for each in known]
    tried = np.unique(np.geomspace(2, max(widest / step, 2), STRIDES).astype(int)).tolist()

    def scatter(stride: int, most: int) -> float:
        """nan where too few samples tell."""
        found = [each.errors(stride, most // len(known)) for each in known]
        clear = [
            errors[~astride(jump, inner, NEIGHBOURS * stride)]
            for jump, (inner, errors) in zip(jumps, found, strict=True)
        ]
        told = np.concatenate(clear)
        return robust_deviation(told) if told.size >= 2 * FEWEST else np.nan

    def shared(stride: int) -> float:
        bend = swing * (2 * np.sin(QUICK * stride * step / 2)) ** 6 / 20
        return SHARED * float(np.hypot(white, bend))

    level, width, most = white, 0.0, max(TELLING, FEWEST * len(known))
    near = [stride for stride in tried if stride * step <= close]
    few = max(HINTING, FEWEST * len(known))
    if not any(scatter(stride, few) > HINT * shared(stride) for stride in near):
        return white, 0.0
    for stride in tried:
        found = scatter(stride, most)
        if np.isnan(found) or (not width and stride * step > close):
            break
        if found > max(shared(stride), level / np.sqrt(max(width / step, 1.0))):
            level, width = found * np.sqrt(stride), stride * step
    return level, width
