"""Many frames of a log at once, where they are as a node sends them that loses none.

What `NodeStream` does frame by frame, to the last bit and with the same memory afterwards, many
times as fast. Where anything is unusual, the frames go one by one.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from exoid.recordings.can.decode import decode_signal, raw_values
from exoid.recordings.can.device_clock import (
    CLOCK_WRAP,
    COUNTER,
    MICROSECOND,
    PERIOD,
    nearest_tick,
)
from exoid.recordings.can.frames import Frames
from exoid.recordings.can.node.rows import FINE, RAW, SAMPLED, STATE, TIME
from exoid.recordings.can.node.samples import RAW_LIMIT
from exoid.recordings.can.node.which import messages_of
from exoid.recordings.live.decoding.node_stream import SILENT, NodeStream
from exoid.recordings.live.decoding.reading import Reading

TOGETHER = 620  # frames: two seconds of a node


def take_all(stream: NodeStream, frames: Frames) -> None:
    """All frames of a part of a log, in order."""
    plans = messages_of(stream.node)
    wanted = [plans[name].identifier for name in (TIME, STATE, RAW, FINE)]
    plain = (frames.flags == 0) & (frames.length == 8) & np.isin(frames.identifier, wanted)
    chosen = frames.where(plain)
    for first in range(0, len(chosen), TOGETHER):
        part = chosen.where(np.arange(first, min(first + TOGETHER, len(chosen))))
        lead = 0
        while lead < len(part) and stream.open is not None:
            lead = lead + one_by_one(stream, part, lead, lead + 1)
        if lead == len(part):
            continue
        stretch = stretch_of(stream, part.where(np.arange(lead, len(part))))
        if stretch is not None:
            absorb(stream, stretch)
            lead += stretch.frames
        one_by_one(stream, part, lead, len(part))


def one_by_one(stream: NodeStream, frames: Frames, begin: int, end: int) -> int:
    """How many were taken."""
    data = frames.data[begin:end].tobytes()
    each = zip(frames.identifier[begin:end].tolist(), frames.time[begin:end].tolist(), strict=True)
    for place, (identifier, host) in enumerate(each):
        stream.take(identifier, host, data[8 * place : 8 * place + 8])
    return end - begin


@dataclass(frozen=True, eq=False)
class Stretch:
    """Whole ticks that follow each other, each with its STATE and its RAW."""

    frames: int  # how many, from the first on
    state: UInt8[np.ndarray, "tick 8"]
    raw: UInt8[np.ndarray, "tick 8"]
    number: Int[np.ndarray, " tick"]
    anchor: tuple[int, int]  # tick and device time [us] of the last EXO_TIME
    heard: float  # s, host time of the last frame


def stretch_of(stream: NodeStream, frames: Frames) -> Stretch | None:
    """The frames up to the last whole tick; None where anything about them is unusual."""
    ticks = stream.ticks
    usual = not (stream.spoiled or stream.filtered or stream.unsure or stream.finer)
    if not usual or ticks.tick is None or ticks.anchor is None or stream.last != ticks.tick:
        return None
    if stream.heard is None or not {STATE, RAW} <= ticks.tracks.keys():
        return None
    plans = messages_of(stream.node)
    ends = np.flatnonzero(frames.identifier == plans[RAW].identifier)
    if not ends.size:
        return None
    frames = frames.where(np.arange(ends[-1] + 1))
    is_time, is_state, is_raw = (
        frames.identifier == plans[name].identifier for name in (TIME, STATE, RAW)
    )
    state, raw = frames.data[is_state], frames.data[is_raw]
    number = ticks.tick + 1 + np.arange(len(state))
    hosts = np.concatenate([[stream.heard], frames.time])
    if (
        not takes_turns(is_time, is_state, is_raw)
        or (np.diff(hosts) > SILENT).any()
        or not counts_on(plans, state, raw, number)
        or plans[STATE].values(state, "FilterReset").any()
    ):
        return None
    clocks = frames.data[is_time]
    at = ticks.tick + np.cumsum(is_state)[is_time]
    anchor = anchored(stream, plans[TIME], clocks, at)
    if anchor is None:
        return None
    return Stretch(len(frames), state, raw, number, anchor, float(frames.time[-1]))


def takes_turns(
    is_time: Bool[np.ndarray, " frame"],
    is_state: Bool[np.ndarray, " frame"],
    is_raw: Bool[np.ndarray, " frame"],
) -> bool:
    """STATE and RAW by turns, STATE first; TIME between the ticks, and nothing else."""
    if not (is_time | is_state | is_raw).all():
        return False
    order = is_state[~is_time]
    apart = np.cumsum(is_state) == np.cumsum(is_raw)
    return bool(order[::2].all() and not order[1::2].any() and apart[is_time].all())


def counts_on(plans, state, raw, number) -> bool:
    """Do the counters go on from tick to tick?"""
    if len(state) != len(raw):
        return False
    each = ((STATE, state), (RAW, raw))
    return all(
        (raw_values(data, plans[name].signal("Counter")) == number % SAMPLED[name]).all()
        for name, data in each
    )


def anchored(stream: NodeStream, plan, clocks, at: Int[np.ndarray, " clock"]):
    """The last EXO_TIME's tick and device time; None where one tells of another tick."""
    assert stream.ticks.anchor is not None
    told = raw_values(clocks, plan.signal("ConfigCrc"))
    device = raw_values(clocks, plan.signal("DeviceTime")).astype(np.int64)
    counter = raw_values(clocks, plan.signal("Counter"))
    tick_before, device_before = stream.ticks.anchor
    every = np.concatenate([[device_before], device])
    elapsed = np.diff(every) % CLOCK_WRAP
    steps = np.diff(np.concatenate([[tick_before], at]))
    sound = (
        all(map(stream.means_ours, np.unique(told).tolist()))
        and (counter == at % COUNTER).all()
        and (np.rint(elapsed * MICROSECOND / PERIOD) == steps).all()
    )
    if not sound:
        return None
    return (int(at[-1]), int(device[-1])) if at.size else stream.ticks.anchor


def absorb(stream: NodeStream, stretch: Stretch) -> None:
    """The samples of a stretch, and the stream as it is after it."""
    ticks, number = stream.ticks, stretch.number
    time = (number - ticks.begin) * PERIOD
    angle, rate = measured(stream, stretch)
    columns = (time.tolist(), angle.tolist(), rate.tolist())
    stream.ready += [Reading(*each) for each in zip(*columns, strict=True)]
    last = int(number[-1])
    for name in (STATE, RAW):
        ticks.tracks[name].add_all(last, number.size)
    ticks.tick, ticks.anchor, ticks.heard = last, stretch.anchor, stretch.heard
    stream.last, stream.heard, stream.unheard = last, stretch.heard, 0
    counters = (number[-2:] % COUNTER).tolist()
    stream.alternation.follow(counters, stretch.state[-1].tobytes(), number.size)


def measured(stream: NodeStream, stretch: Stretch) -> tuple[Float[np.ndarray, " tick"], ...]:
    """Angle [rad] and rate [rad/s] of every tick."""
    counts, state, raw = stream.counts, stretch.state, stretch.raw
    word = state.view("<u8")[:, 0]
    filtered = decode_signal(state, counts.of_state)
    signal = counts.of_raw
    near = np.rint((filtered - signal.offset) / signal.scale).astype(np.int64)
    count = raw_values(raw, signal).astype(np.int64)
    angle = nearest_tick(count, near, counts.turn) * signal.scale + signal.offset
    turned = raw_values(raw, counts.of_gyro).astype(np.int64)
    rate = turned * counts.of_gyro.scale + counts.of_gyro.offset
    blind = (word & np.uint64(counts.no_angle)) != 0
    stream.counts.expected = float(filtered[-1] if blind[-1] else angle[-1])
    angle[blind] = np.nan
    rate[((word & np.uint64(counts.no_rate)) != 0) | (np.abs(turned) >= RAW_LIMIT)] = np.nan
    return angle, rate
