"""Times that are off, each by its own: what that adds to the noise of a leg that moves.

A sample taken s seconds from where its time says it was shows the rate of its channel times s
beside what the sensor errs. Its noise has the variance

    steady^2 + jitter^2 rate^2

and is told without a model: by how the departures of samples from their neighbours grow with the
rate. A blurred image, or a clock that is read late, looks the same and is weighed the same. The
rounding of a coarse sensor errs at rest as well, where it does not scatter: no noise counts for
less.
"""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from exoid.recordings.measured.samples import Samples, quantum, robust_deviation
from exoid.recordings.recording import Recording
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.signal.neighbours import interpolation_errors
from exoid.recordings.signal.noise import Noise
from exoid.recordings.signal.turns import coarse

WIDTH = 0.06  # s, over which a rate is told
GROUPS, FEWEST = 12, 40  # of samples of like rates, and samples of one
LEAST_GROUPS = 5
SPREAD = 7.0  # variance of a group's squared deviation, over its fourth power and number
SURE = 4.0  # errors by which the noise grows
WORTH = 0.15  # of its mean square
STEADIEST = 0.1  # of the noise of all samples: none counts for more than a hundred others
ROUNDS = 5  # in which the weights of groups settle


@dataclass(frozen=True)
class TimeJitter:
    """The noise of a channel at rest, in its unit, and how far its times are off [s]."""

    steady: float
    jitter: float

    def noise(self, time: Samples, samples: Samples) -> Samples:
        """The standard deviation of every sample, in the unit of its channel."""
        return np.hypot(self.steady, self.jitter * local_line(time, samples, WIDTH)[1])

    def level(self, time: Samples, samples: Samples) -> float:
        """The root mean square over all that are known."""
        each = self.noise(time, samples)[~np.isnan(samples)]
        return float(np.sqrt(np.mean(each**2)))


def jitter_beside(noise: Noise | None, recording: Recording, channel: str) -> TimeJitter | None:
    """How far the times of a channel with this noise are off; None where its noise does not grow
    with its rate. What is declared counts for a leg at rest.
    """
    if noise is None or noise.alike_over or (found := time_jitter(recording, channel)) is None:
        return None
    least = STEADIEST * noise.level
    return replace(found, steady=max(found.steady, noise.declared or 0.0, least))


@remembered
def time_jitter(recording: Recording, channel: str) -> TimeJitter | None:
    """The same by its samples alone; None on a rig, whose models miss more at speed than a clock
    does.
    """
    if recording.subject.kind == "rig":
        return None
    signals = [(each.time, getattr(each, channel)) for each in recording.segments]
    if any(coarse(*each) for each in signals):
        return None
    told = [departures(*each) for each in signals]
    errors, rates = (np.concatenate(each) for each in zip(*told, strict=True))
    groups = min(GROUPS, errors.size // FEWEST)
    rounding = quantum([samples for _, samples in signals]) / np.sqrt(12)
    return None if groups < LEAST_GROUPS else grown(errors, rates, groups, rounding)


def departures(time: Samples, samples: Samples) -> tuple[Samples, Samples]:
    """Errors beside neighbours, and the rates there, of the samples that have both."""
    errors, rates = interpolation_errors(time, samples), local_line(time, samples, WIDTH)[1]
    known = ~(np.isnan(errors) | np.isnan(rates))
    return errors[known], rates[known]


def grown(errors: Samples, rates: Samples, groups: int, rounding: float) -> TimeJitter | None:
    """The line of squared deviations over squared rates, by groups of samples of like rates, none
    of which deviates by less than its `rounding` (standard deviation).
    """
    parts = np.array_split(np.argsort(np.abs(rates)), groups)
    squares = np.array([robust_deviation(errors[part], rounding) ** 2 for part in parts])
    design = np.stack([np.ones(groups), [np.mean(rates[part] ** 2) for part in parts]], axis=1)
    expected, least = np.full(groups, squares.mean()), 1e-3 * squares.mean()
    for _ in range(ROUNDS):
        line = fitted(design, squares, expected, errors.size / groups)[0]
        expected = np.maximum(design @ line, least)
    line, covariance, scatter = fitted(design, squares, expected, errors.size / groups)
    variance = covariance[1, 1] * max(scatter, 1.0)
    return judged(line, variance, float(np.mean(rates**2)), rounding)


def fitted(
    design: Float[np.ndarray, "group 2"], squares: Samples, expected: Samples, size: float
) -> tuple[Float[np.ndarray, "2"], Float[np.ndarray, "2 2"], float]:
    """The line through groups of so many samples, its covariance if they scatter as noise does
    around what is expected, and how much more they do.
    """
    weight = size / (SPREAD * expected**2)
    covariance = np.linalg.inv(design.T @ (weight[:, None] * design))
    line = covariance @ design.T @ (weight * squares)
    scatter = np.sum(weight * (squares - design @ line) ** 2) / (squares.size - 2)
    return line, covariance, float(scatter)


def judged(
    line: Float[np.ndarray, "2"], variance: float, swept: float, rounding: float
) -> TimeJitter | None:
    """What the line says, where it rises for sure and by enough."""
    steady, growth = np.maximum(line, [rounding**2, 0.0])
    sure = growth > SURE * np.sqrt(variance)
    worth = growth * swept > WORTH * (steady + growth * swept)
    return TimeJitter(float(np.sqrt(steady)), float(np.sqrt(growth))) if sure and worth else None
