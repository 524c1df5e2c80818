"""How much a candidate explains, by what the best of them leaves."""

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording

LONGEST_LAG = 1.0  # s, over which what is left may be correlated


def yardstick(prepared: PreparedRecording, best: Optimum) -> Yardstick:
    """By what the best candidate leaves: white noise, or what nothing explains.

    What is left and correlated in time counts as few samples: the variance of a sum over it is
    larger by the sum of its autocorrelation.
    """
    seen = prepared.seen
    return Yardstick(prepared.samples, max(1.0, float(np.mean(inflation(seen, best.motion)))))


def misfits(seen: Observation, shown: np.ndarray) -> list[list[np.ndarray]]:
    """What is left over the noise: of every segment its angle and its rate."""
    data = (seen.angle, seen.angular_velocity)
    weights = (seen.angle_weight, seen.velocity_weight)
    return [
        [
            (weight[k] * (shown[k, :, channel] - value[k]))[weight[k] > 0]
            for channel, (value, weight) in enumerate(zip(data, weights, strict=True))
        ]
        for k in range(seen.time.shape[0])
    ]


def inflation(seen: Observation, shown: np.ndarray) -> list[float]:
    """Mean square of what is left, times the sum of its autocorrelation, of every channel."""
    found = []
    for number, channels in enumerate(misfits(seen, shown)):
        step = float(np.median(np.diff(seen.time[number])))
        for left in channels:
            if left.size:
                found += [long_run(left, step)] * left.size
    return found


def long_run(left: np.ndarray, step: float) -> float:
    """Newey and West's long-run variance (Econometrica 55(3), 1987) of samples every `step` s,
    never below the variance.
    """
    lags = min(int(LONGEST_LAG / step), left.size // 4)
    square = float(np.mean(left**2))
    weights = 1 - np.arange(1, lags + 1) / (lags + 1)
    products = [float(left[lag:] @ left[:-lag]) / left.size for lag in range(1, lags + 1)]
    return max(square, square + 2 * float(weights @ products))
