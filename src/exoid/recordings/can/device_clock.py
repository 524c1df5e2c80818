"""When each sample was taken: the node's own clock, restored from counters of 4, 8 and 32 bits.

A tick is one period of the node's sampling timer, counted without end from the node's start. Host
time says only which of the possible ticks was meant; its jitter never reaches a sample's time.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int, Shaped

from exoid.recordings.can.frames import Columns

PERIOD = 0.01  # s; the sampling tick of the node
MICROSECOND = 1e-6
CLOCK_WRAP = 2**32  # us; the device clock starts again after 71.6 minutes
COUNTER = 256  # values of an 8-bit counter
SPIKE = 5  # frames; a host time that stands out among so many is not believed
AGREED = PERIOD / 4  # s within which clock and counter tell of the same tick
RESET_SLACK = 1.0  # s by which host and device may differ over a silence ...
RESET_SKEW = 0.02  # ... and this share of it: a node without a crystal is percents off

Ticks = Int[np.ndarray, " frame"]
Seconds = Float[np.ndarray, " frame"]


@dataclass(frozen=True, eq=False)
class Stamps(Columns):
    """Frames of one message: place in the log, host time, and the counter they carry."""

    order: Int[np.ndarray, " frame"]
    host: Seconds
    counter: Int[np.ndarray, " frame"]


@dataclass(frozen=True, eq=False)
class Anchors(Columns):
    """Frames whose tick is known, with the device time of that tick."""

    order: Int[np.ndarray, " frame"]
    host: Seconds
    tick: Ticks
    device: Seconds

    def device_time(self, tick: Ticks) -> Seconds:
        """t = TIME.t + (tick - TIME.tick) * period, from the last anchor before the tick."""
        at = np.clip(np.searchsorted(self.tick, tick, side="right") - 1, 0, self.tick.size - 1)
        return self.device[at] + (tick - self.tick[at]) * PERIOD


def without_spikes(host: Seconds) -> Seconds:
    """Host times with single outliers taken out: a running median, which leaves order alone."""
    if host.size < SPIKE:
        return host
    padded = np.pad(host, SPIKE // 2, mode="reflect")
    return np.median(np.lib.stride_tricks.sliding_window_view(padded, SPIKE), axis=1)


def nearest_tick(counter: Ticks | int, expected: Ticks | int, modulus: int) -> Any:
    """The tick nearest to `expected` that shows this counter."""
    return expected + (counter - expected + modulus // 2) % modulus - modulus // 2


def device_anchors(stamps: Stamps, device_us: Int[np.ndarray, " frame"]) -> list[Anchors]:
    """The EXO_TIME frames with their ticks, parted where the node started again."""
    repeated = np.zeros(device_us.size, dtype=bool)
    repeated[1:] = (np.diff(device_us) == 0) & (np.diff(stamps.counter) == 0)
    stamps, device_us = stamps.where(~repeated), device_us[~repeated]
    keep = ~lone(stamps, device_us)
    stamps, device_us = stamps.where(keep), device_us[keep]
    elapsed, steps, reset = elapsed_between(stamps, device_us, slice(None, -1), slice(1, None))
    return [
        Anchors(
            stamps.order[run],
            stamps.host[run],
            tick=carried_on(stamps.counter[run.start], steps, run),
            device=carried_on(device_us[run.start] * MICROSECOND, elapsed, run),
        )
        for run in runs_between(reset)
    ]


def runs_between(reset: Bool[np.ndarray, " step"]) -> list[slice]:
    """The frames of every run; a step with a reset parts two of them."""
    begins = np.flatnonzero(np.concatenate([[True], reset])).tolist()
    return [slice(*ends) for ends in pairwise([*begins, reset.size + 1])]


def carried_on(first: Any, steps: np.ndarray, run: slice) -> np.ndarray:
    """What begins with `first` and grows by the steps within a run."""
    within = steps[run.start : run.stop - 1]
    return first + np.concatenate([np.zeros(1, within.dtype), np.cumsum(within)])


def elapsed_between(stamps: Stamps, device_us, before: slice, after: slice):
    """Device seconds and ticks from each frame to a later one, and whether the node was reset.

    The clock may have wrapped: host time says how often, unless the counter contradicts it and
    does not contradict a clock that has not wrapped (then the host's clock was set). The node was
    reset when its clock went back, or when clock and counter do not tell of the same ticks.
    """
    host = stamps.host[after] - stamps.host[before]
    counted = stamps.counter[after] - stamps.counter[before]
    clock = ((device_us[after] - device_us[before]) % CLOCK_WRAP) * MICROSECOND
    wrap = CLOCK_WRAP * MICROSECOND
    wrapped = clock + np.maximum(0, np.rint((host - clock) / wrap)) * wrap
    unwrapped_fits = disagreement(clock, counted) <= AGREED
    set_clock = (disagreement(wrapped, counted) > AGREED) & unwrapped_fits
    elapsed = np.where(set_clock, clock, wrapped)
    back = (clock > wrap / 2) & (np.abs(host - elapsed) > RESET_SLACK + RESET_SKEW * elapsed)
    reset = back | (disagreement(elapsed, counted) > AGREED)
    return elapsed, ticks_in(elapsed, counted), reset


def ticks_in(elapsed: Seconds, counted: Ticks) -> Ticks:
    """The number of ticks that is nearest to the time and agrees with the counter."""
    return nearest_tick(counted, np.rint(elapsed / PERIOD).astype(np.int64), COUNTER)


def disagreement(elapsed: Seconds, counted: Ticks) -> Seconds:
    """How far clock and counter are apart."""
    return np.abs(elapsed - ticks_in(elapsed, counted) * PERIOD)


def lone(stamps: Stamps, device_us) -> Shaped[np.ndarray, " frame"]:
    """Frames that agree with neither neighbour while the neighbours agree: damaged in the log."""
    alone = np.zeros(device_us.size, dtype=bool)
    if device_us.size >= 3:
        *_, reset = elapsed_between(stamps, device_us, slice(None, -1), slice(1, None))
        *_, across = elapsed_between(stamps, device_us, slice(None, -2), slice(2, None))
        alone[1:-1] = reset[:-1] & reset[1:] & ~across
    return alone


def counter_anchors(stamps: Stamps, modulus: int, restart) -> list[Anchors]:
    """Without EXO_TIME: the frames of one message, their counter carried on with host time.

    A frame that says the filter has just started (`restart`) and breaks the count begins anew.
    """
    step = np.diff(stamps.counter) % modulus
    host_ticks = np.diff(stamps.host) / PERIOD
    steps = step + modulus * np.maximum(0, np.rint((host_ticks - step) / modulus)).astype(np.int64)
    parts = []
    for run in runs_between(restart[1:] & (step != 1)):
        tick = carried_on(stamps.counter[run.start], steps, run)
        parts.append(Anchors(stamps.order[run], stamps.host[run], tick, tick * PERIOD))
    return parts


def ticks_of(stamps: Stamps, anchors: Anchors, modulus: int) -> Ticks:
    """The tick of every frame: its counter says which of a few, the anchors around it say which.

    Where the anchors before and after it agree, no clock is asked. Where they do not (a long
    gap) and at both ends of the log, host time decides, which may then be off by half of
    `modulus` ticks.
    """
    last = anchors.order.size - 1
    following = np.searchsorted(anchors.order, stamps.order)
    between = (following > 0) & (following <= last)
    before, after = np.maximum(following - 1, 0), np.minimum(following, last)
    nearer_before = np.abs(stamps.host - anchors.host[before]) <= np.abs(
        anchors.host[after] - stamps.host
    )
    near = np.where(nearer_before, before, after)
    ticks_apart = np.rint((stamps.host - anchors.host[near]) / PERIOD).astype(np.int64)
    by_host = nearest_tick(stamps.counter, anchors.tick[near] + ticks_apart, modulus)
    by_before = nearest_tick(stamps.counter, anchors.tick[before], modulus)
    by_after = nearest_tick(stamps.counter, anchors.tick[after], modulus)
    return np.where(between & (by_before == by_after), by_before, by_host)


def astray(tick: Ticks) -> Shaped[np.ndarray, " frame"]:
    """Frames out of the order of their neighbours, which are in order: damaged or sent late."""
    found = np.zeros(tick.size, dtype=bool)
    if tick.size >= 3:
        before, here, after = tick[:-2], tick[1:-1], tick[2:]
        found[1:-1] = (before <= after) & ((here > after) | (here < before))
    return found
