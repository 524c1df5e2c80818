"""Which frames make one sample: STATE, RAW and ACC of one tick, joined by their counters.

A tick of which nothing arrived is no row: the times tell of it and the report lists it, and a
pause of an hour costs no memory. A tick of which only some frames arrived is a row with gaps.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from jaxtyping import Float, Int

from exoid.recordings.can.clock_rate import ClockRate, clock_rate
from exoid.recordings.can.device_clock import (
    COUNTER,
    PERIOD,
    Anchors,
    Stamps,
    astray,
    counter_anchors,
    device_anchors,
    ticks_of,
    without_spikes,
)
from exoid.recordings.can.sort import MessageFrames

TIME, STATE, RAW, ACC = "EXO_TIME", "EXO_STATE", "EXO_RAW", "EXO_ACC"
FINE = "EXO_FINE"  # of some nodes alone: it goes with a sample and makes none
SAMPLED = {STATE: COUNTER, ACC: COUNTER, RAW: 16}  # message: how many values its counter has
MISSING = -1
NEIGHBOURS = 50  # frames from which host time across a restart is told


@dataclass(frozen=True, eq=False)
class Rows:
    """The samples of one run of the node, in order."""

    tick: Int[np.ndarray, " row"]
    time: Float[np.ndarray, " row"]  # s on the device clock, later on the recording's
    frame: dict[str, Int[np.ndarray, " row"]]  # which frame of each message; MISSING for none
    anchors: Anchors
    heard: Anchors  # every frame of the message that came most often
    duplicate: int
    astray: int


def stamps_of(messages: dict[str, MessageFrames]) -> dict[str, Stamps]:
    """Place, host time and counter of every good frame; host times without single outliers."""
    order = np.concatenate([message.order for message in messages.values()])
    host = np.concatenate([message.frames.time for message in messages.values()])
    by_place = np.argsort(order)
    order, host = order[by_place], without_spikes(host[by_place])
    return {
        name: Stamps(
            message.order,
            host[np.searchsorted(order, message.order)],
            message.values("Counter").astype(np.int64),
        )
        for name, message in messages.items()
    }


def runs(messages: dict[str, MessageFrames]) -> list[Rows]:
    """The samples of the log on the node's clock, run by run: it ends where the node restarts."""
    stamps = stamps_of(messages)
    restart = messages[STATE].values("FilterReset") > 0  # the filter has just started
    restart_orders = stamps[STATE].order[restart]
    anchors = anchors_of(messages[TIME], stamps, restart)
    borders = [
        restart_order(before, after, stamps, restart_orders) for before, after in pairwise(anchors)
    ]
    begins, ends = [0, *borders], [*borders, np.iinfo(np.int64).max]
    found = [
        rows_of(within(stamps, begin, end), part)
        for part, begin, end in zip(anchors, begins, ends, strict=True)
    ]
    return [rows for rows in found if rows.tick.size]


def anchors_of(time: MessageFrames, stamps: dict[str, Stamps], restart) -> list[Anchors]:
    """What fixes the ticks: EXO_TIME, and without it the sampled frames with the most to say."""
    if time.order.size:
        return device_anchors(stamps[TIME], time.values("DeviceTime").astype(np.int64))
    name = next(name for name in SAMPLED if stamps[name].order.size)
    none = np.zeros(stamps[name].order.size, dtype=bool)
    return counter_anchors(stamps[name], SAMPLED[name], restart if name == STATE else none)


def restart_order(before: Anchors, after: Anchors, stamps: dict[str, Stamps], restarts) -> int:
    """The place of the first frame after a restart that lies between two anchors.

    That is a STATE frame which says so, or else the frame after the longest silence.
    """
    first, last = before.order[-1], after.order[0]
    said = restarts[(restarts > first) & (restarts <= last)]
    if said.size:
        return int(said[0])
    order = np.concatenate([each.order for each in stamps.values()])
    host = np.concatenate([each.host for each in stamps.values()])
    between = (order >= first) & (order <= last)
    by_place = np.argsort(order[between])
    silence = np.argmax(np.diff(host[between][by_place]))
    return int(order[between][by_place][silence + 1])


def within(stamps: dict[str, Stamps], begin: int, end: int) -> dict[str, Stamps]:
    return {
        name: each.where((each.order >= begin) & (each.order < end))
        for name, each in stamps.items()
    }


def rows_of(stamps: dict[str, Stamps], anchors: Anchors) -> Rows:
    """The samples of one run."""
    ticks: dict[str, np.ndarray] = {}
    frames: dict[str, np.ndarray] = {}
    duplicate = strayed = 0
    known = heard = anchors
    for name, modulus in SAMPLED.items():
        tick = ticks_of(stamps[name], known if modulus < COUNTER else anchors, modulus)
        stray = astray(tick)
        kept = np.flatnonzero(~stray)
        told = told_by(stamps[name].where(kept), tick[kept], anchors)
        known = merged(known, told)
        heard = max(heard, told, key=lambda each: each.order.size)
        ticks[name], first = np.unique(tick[kept], return_index=True)
        frames[name] = stamps[name].order[kept[first]]
        strayed += int(stray.sum())
        duplicate += kept.size - first.size
    # With an index NumPy sorts, and three sorted runs are soon sorted; without, it hashes.
    tick, _ = np.unique(np.concatenate(list(ticks.values())), return_index=True)
    placed_frames = {name: placed(frames[name], ticks[name], tick) for name in SAMPLED}
    return Rows(
        tick,
        anchors.device_time(tick),
        placed_frames | {FINE: beside(stamps[FINE], known, tick)},
        anchors,
        heard,
        duplicate,
        strayed,
    )


def told_by(stamps: Stamps, tick, clock: Anchors) -> Anchors:
    """Frames whose tick is known, as anchors of others."""
    return Anchors(stamps.order, stamps.host, tick, clock.device_time(tick))


def merged(known: Anchors, more: Anchors) -> Anchors:
    """Both, in the order of the log."""
    both = known.followed_by(more)
    return both.where(np.argsort(both.order, kind="stable"))


def placed(order, ticks, rows) -> Int[np.ndarray, " row"]:
    """The place in the log of each row's frame, MISSING where there is none."""
    at = np.full(rows.size, MISSING, dtype=np.int64)
    at[np.searchsorted(rows, ticks)] = order
    return at


def beside(stamps: Stamps, known: Anchors, rows) -> Int[np.ndarray, " row"]:
    """The place in the log of the frame that goes with each row, MISSING where none does."""
    if not stamps.order.size:
        return np.full(rows.size, MISSING, dtype=np.int64)
    tick, first = np.unique(ticks_of(stamps, known, COUNTER), return_index=True)
    there = np.isin(tick, rows)
    return placed(stamps.order[first[there]], tick[there], rows)


def rate_of(found: list[Rows]) -> ClockRate | None:
    """How fast the node's clock runs, by its longest run."""
    heard = max(found, key=lambda rows: rows.tick.size).heard
    return clock_rate(heard.device, heard.host)


def on_one_clock(found: list[Rows], factor: float) -> list[Rows]:
    """All runs on the recording's clock: 0 at the first sample, the node's seconds times `factor`.

    Only host time tells how long a restart took: it is known to the host's jitter, no better.
    """
    moved: list[Rows] = []
    for rows in found:
        device, time = rows.anchors.device * factor, rows.time * factor
        shift = -time[0]
        if moved:
            before = moved[-1]
            host_before = np.median((before.anchors.host - before.anchors.device)[-NEIGHBOURS:])
            host_after = np.median((rows.anchors.host - device)[:NEIGHBOURS])
            earliest = before.time[-1] + PERIOD * factor - time[0]
            shift = max(float(host_after - host_before), earliest)
        anchors = replace(rows.anchors, device=device + shift)
        moved.append(replace(rows, time=time + shift, anchors=anchors))
    return moved
