"""When the frames of a message without a counter were sent, by the host's times alone."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from exoid.files.counted import counted
from exoid.recordings.can.clock_rate import fitted_line
from exoid.recordings.can.device_clock import without_spikes
from exoid.recordings.can.frames import CanLogError, Log
from exoid.recordings.can.sort import MessageFrames

WINDOW = 50  # frames; a delay by a busy computer is over within so many
REGULAR = 0.25  # share of a period: with more scatter the frames are not periodic


@dataclass(frozen=True, eq=False)
class Track:
    """The frames of one message in time."""

    time: Float[np.ndarray, " frame"]
    count: Int[np.ndarray, " frame"]  # periods since the first frame
    period: float  # s
    jitter: float  # s
    regular: bool


def track_of(log: Log, message: MessageFrames) -> Track:
    if message.order.size < 2:
        raise CanLogError(
            f"{log.path} holds {counted(message.order.size, 'frame')} of {message.plan.name} "
            f"(id 0x{message.plan.identifier:X}, {message.plan.length} bytes). "
            "Is this the right DBC for the log?"
        )
    host = without_spikes(message.frames.time - log.frames.time[0])
    count, period = periods(host)
    slope, level, jitter = fitted_line(count.astype(float), host)
    if jitter <= REGULAR * period and (np.diff(count) > 0).all():
        return Track(level + slope * count, count, slope, jitter, True)
    return Track(rising(host), count, period, jitter, False)


def periods(host: Float[np.ndarray, " frame"]) -> tuple[Int[np.ndarray, " frame"], float]:
    """How many periods lie before each frame, lost ones included, and the period.

    A late frame is soon made up for, a lost one never: of a lost frame every later one within a
    window tells.
    """
    steps = np.diff(host)
    period = float(np.median(steps[steps > 0])) if (steps > 0).any() else 1.0
    late = host - host[0] - np.arange(host.size) * period
    padded = np.pad(late, (0, WINDOW - 1), mode="edge")
    lasting = np.lib.stride_tricks.sliding_window_view(padded, WINDOW).min(axis=1)
    lost = np.maximum(0, np.rint(np.diff(lasting) / period)).astype(np.int64)
    return np.concatenate([[0], np.cumsum(1 + lost)]), period


def rising(host: Float[np.ndarray, " frame"]) -> Float[np.ndarray, " frame"]:
    """Host times that increase: a frame that is not later than the last is one rounding later."""
    return np.maximum.accumulate(host) + np.arange(host.size) * 1e-9


def told(name: str, track: Track) -> str:
    if track.regular:
        return f"{name}: every {track.period * 1e3:.3f} ms, time from a line through the host's"
    return f"{name}: not periodic, so every sample carries the host time of its frame"
