"""The noise of a sampled signal: its size and its tails, told from the samples themselves."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import FAR, FEWEST, NONE, Samples, quantum, robust_deviation
from exoid.recordings.signal.neighbours import known_of
from exoid.recordings.signal.smoothed import OF_ANGLE, QUIET, smoothed_or_not
from exoid.recordings.signal.tone import Tone

AGREE = 2.0  # factor between measured and declared noise, from which on it is worth a word
MORE = 1.5  # times the declared noise: samples that scatter by more are believed; jumps make 1.4
HEAVY = 1.15  # root mean square over robust deviation, from which on tails are worth a word
SAME = 0.01  # of an encoder's step, within which that of samples is the same
CHANCE = 4.5  # over the root of their number, by which it is more of one in 700 Gaussian samples


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
        told = self.declared is not None and self.measured is not None
        return told and not agree(self.measured, self.declared)

    @property
    def hidden(self) -> bool:
        """Does an angle scatter by less than a sensor on a leg can, and nobody declared it?"""
        return self.declared is None and bool(self.level < QUIET)

    @property
    def heavy(self) -> bool:
        """Are large errors more frequent than in a normal distribution, by more than chance?"""
        chance = CHANCE / np.sqrt(max(self.samples, 1))
        return bool(self.heaviness > 1.0 + max(HEAVY - 1.0, chance))


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


def swing_of(sensors: Sensors, signals: list[Samples]) -> float | None:
    """How far an angle may swing for `noise_of`; None where it stands on the steps of the encoder
    that the sidecar declares: whoever smooths, or interpolates, leaves values between them.
    """
    if sensors.encoder_counts is None:
        return OF_ANGLE
    step = 2 * np.pi / sensors.encoder_counts
    return None if abs(quantum(signals) - step) < SAME * step else OF_ANGLE


def noise_of(
    times: list[Samples],
    signals: list[Samples],
    declared: float | None,
    *,
    swing: float | None = None,
    driven: bool = False,
) -> Noise:
    """The noise of one channel from all its segments, beside what is `declared`.

    A sample is compared with the quintic through its neighbours, which sees white noise whatever
    the leg does. Errors beyond five robust deviations do not count: see `spikes`. What was smoothed
    or interpolated has errors that neighbours share: see `smoothed`, which is asked where it is
    told how far the signal of a leg may `swing` (`OF_ANGLE`, `OF_RATE`), unless the sidecar
    declares the white noise that shows. `driven` is what a torque moves that was measured.
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
    if swing is not None and not agree(measured, declared):
        measured, width = smoothed_or_not(known, measured, swing, driven=driven, rounding=step)
    level = measured if declared is None or measured > MORE * declared else declared
    return Noise(level, measured, declared, heaviness, samples=errors.size, alike_over=width)


def agree(measured: float | None, declared: float | None) -> bool:
    """Are both told, and within a factor of two of each other?"""
    if measured is None or declared is None:
        return False
    return bool(1 / AGREE <= measured / declared <= AGREE)


def of_few(errors: Samples) -> float:
    """The standard deviation of errors too few to tell it, by one of its own errors larger."""
    if not errors.size:
        return 0.0
    return float(np.sqrt(np.mean(errors**2))) * (1 + 1 / np.sqrt(2 * errors.size))
