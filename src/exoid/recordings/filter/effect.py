"""What the node's filter did to the motion: its filtered channels measured against the raw ones."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool

from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.signal.condition import MOTION_SPEED, SMOOTHING
from exoid.recordings.signal.local_line import local_line

FEWEST = 50  # moving samples; with fewer a lag cannot be told
LONGEST = 0.5  # s; no filter is later
ROUNDS = 5  # each takes out what the last one left: the second already leaves microseconds
MOST = 50_000  # samples; more would tell the lag no better than to the microsecond
SURE = 1e-3  # s, standard error of a lag that can be told
LEAST_GAIN = 0.2  # below it the two channels do not show the same motion
MATTERS = np.pi / 4096  # rad; half a count of the encoder
CHANNELS = {"angle": "angle", "angular_velocity": "rate"}  # and what they are called


@dataclass(frozen=True)
class ChannelEffect:
    """filtered(t) = gain raw(t - lag) + constant, by least squares."""

    channel: str
    lag: float  # s
    gain: float


@dataclass(frozen=True)
class FilterEffect:
    """The effect on each channel that was recorded both ways, and whether it is in the way."""

    channels: tuple[ChannelEffect, ...]
    speed: float  # rad/s, the fastest motion of the recording
    fitted: bool  # is the filtered angle fitted, because there is no raw one?

    def lines(self) -> list[str]:
        """What was found, and a warning where a fit would meet the filter instead of the leg."""
        told = [
            f"{CHANNELS[each.channel]} {abs(each.lag) * 1e3:.2f} ms "
            f"{'late' if each.lag >= 0 else 'early'}, gain {each.gain:.4f}"
            for each in self.channels
        ]
        found = [f"the node's filter, against the raw samples: {'; '.join(told)}"] if told else []
        return found + ([self.warning()] if self.fitted and self.matters else [])

    @property
    def matters(self) -> bool:
        """Does the lag move the angle by more than the encoder can tell, or may it?"""
        return not self.channels or self.lag * self.speed > MATTERS

    @property
    def lag(self) -> float:
        return max(abs(each.lag) for each in self.channels)

    def warning(self) -> str:
        begin = "no raw angle was recorded, so the filtered one is fitted"
        advice = "Record the raw angle too (EXO_RAW)."
        if not self.channels:
            return f"{begin}, and how late its filter makes it cannot be told. {advice}"
        return (
            f"{begin}: {self.lag * 1e3:.1f} ms off, that is "
            f"{np.degrees(self.lag * self.speed):.2f} deg at {np.degrees(self.speed):.0f} deg/s, "
            f"where the filter that a fit reckons with is off by less than 0.1 ms. {advice}"
        )


def filter_effect(segment: Segment) -> FilterEffect | None:
    """What the filter did in this recording; None where nothing was filtered, or too short."""
    if segment.angle is None or segment.time.size < FEWEST:
        return None
    speed = np.abs(local_line(segment.time, segment.best_angle, SMOOTHING)[1])
    found = [channel_effect(segment, each, speed > MOTION_SPEED) for each in CHANNELS]
    return FilterEffect(
        tuple(each for each in found if each is not None),
        float(speed.max()),
        segment.raw_angle is None,
    )


def channel_effect(
    segment: Segment, channel: str, moving: Bool[np.ndarray, " time"]
) -> ChannelEffect | None:
    """Lag and gain of one channel; None where it was not recorded both ways, or nothing moved.

    Both are smoothed alike, so the noise of the raw samples goes and the filter's effect stays.
    """
    after, before = getattr(segment, channel), getattr(segment, f"raw_{channel}")
    if after is None or before is None:
        return None
    time = segment.time
    inside = (time > time[0] + LONGEST) & (time < time[-1] - LONGEST)
    used = np.flatnonzero(inside & ~np.isnan(after) & ~np.isnan(before))
    if moving[used].sum() < FEWEST:
        return None
    used = used[:: 1 + used.size // MOST]
    smooth, slope = local_line(time, before, SMOOTHING)
    target = local_line(time, after, SMOOTHING)[0][used]
    lag, gain, error = 0.0, 1.0, 0.0
    for _ in range(ROUNDS):
        at = time[used] - lag
        gain, further, error = matched(
            target, np.interp(at, time, smooth), np.interp(at, time, slope)
        )
        if gain < LEAST_GAIN or error > SURE:
            return None
        lag = float(np.clip(lag + further, -LONGEST, LONGEST))
    return ChannelEffect(channel, lag, gain)


def matched(target: Samples, source: Samples, slope: Samples) -> tuple[float, float, float]:
    """gain and lag of target = gain (source - lag slope) + constant, and the lag's error."""
    columns = np.stack([source, -slope, np.ones_like(source)])
    (gain, late, level), _, rank, _ = np.linalg.lstsq(columns.T, target)
    if rank < len(columns) or gain == 0:
        return 0.0, 0.0, np.inf
    rest = target - gain * source + late * slope - level
    error = np.sqrt(rest @ rest / rest.size * np.linalg.inv(columns @ columns.T)[1, 1])
    return float(gain), float(late / gain), float(error / abs(gain))
