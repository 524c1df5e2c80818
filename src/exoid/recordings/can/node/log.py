"""A log of the exoskeleton's own frames (exoid.dbc) as one segment, with its report."""

from dataclasses import replace

import numpy as np

from exoid.recordings.can.device_clock import PERIOD
from exoid.recordings.can.frames import CanLogError, Log
from exoid.recordings.can.node.commissioned import commissioned_lines
from exoid.recordings.can.node.config_crc import config_crc, filter_of
from exoid.recordings.can.node.health import HEALTH, health_lines
from exoid.recordings.can.node.learned import LEARNING, course_of
from exoid.recordings.can.node.rows import (
    FINE,
    MISSING,
    SAMPLED,
    TIME,
    Rows,
    on_one_clock,
    rate_of,
    runs,
)
from exoid.recordings.can.node.samples import Samples, samples_of
from exoid.recordings.can.node.which import MEASURED, nodes_in, read_by
from exoid.recordings.can.quality import LogQuality, MessageCount, gaps_in
from exoid.recordings.can.sort import MessageFrames, SortedFrames, sort_frames
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.filter.effect import filter_effect
from exoid.recordings.measured.segment import Segment

RAW_TURN = 4096  # counts of an encoder that EXO_RAW holds in full
EXO_SENSORS = Sensors(encoder_counts=float(RAW_TURN), gyro_range=2000.0, sample_rate=1 / PERIOD)
IDS_SHOWN = 8
FEWEST_SAMPLES = 2


def read_exo(log: Log) -> tuple[Segment, LogQuality]:
    """All samples of the node in a log; of several, that with the lowest id.

    **Raises** `CanLogError` when the log holds no usable frame of the node, or no valid angle.
    """
    nodes = nodes_in(log.frames) or [0]
    ordered = sort_frames(log.frames, read_by(log.frames, nodes[0]))
    require_exo_frames(log, ordered)
    measured = {name: ordered.messages[name] for name in MEASURED}
    found = runs(measured)
    if sum(rows.tick.size for rows in found) < FEWEST_SAMPLES:
        raise CanLogError(f"{log.path} holds fewer than {FEWEST_SAMPLES} samples of the node.")
    rate = rate_of(found)
    found = on_one_clock(found, rate.factor if rate is not None else 1.0)
    samples = samples_of(measured, found)
    quality = replace(quality_of(log, ordered, found, samples), clock_rate=rate)
    quality = replace(quality, design=filter_of(quality.config_crc))
    refuse_other_firmware(log, quality.config_crc)
    if "angle" not in samples.channels and "raw_angle" not in samples.channels:
        raise CanLogError(
            f"{log.path} holds no valid angle: {'; '.join(quality.lines())}. "
            "Check the encoder and its magnet."
        )
    time = np.concatenate([rows.time for rows in found])
    segment = replace(Segment(time), **samples.channels)
    return segment, replace(
        quality,
        filter=filter_effect(segment),
        commissioned=commissioned_lines(nodes[0], ordered.messages, found),
        learned=course_of(ordered.messages).last if LEARNING in ordered.messages else None,
        notes=several(nodes) + health_lines(ordered.messages.get(HEALTH)),
    )


def several(nodes: list[int]) -> tuple[str, ...]:
    """What to say where more than one node is in a log."""
    if len(nodes) < 2:
        return ()
    return (
        f"the log holds the nodes {', '.join(map(str, nodes))}: node {nodes[0]} is read. Record "
        "another one alone: exoid record --node ID.",
    )


def require_exo_frames(log: Log, ordered: SortedFrames) -> None:
    if any(ordered.messages[name].order.size for name in SAMPLED):
        return
    counts = ordered.counts
    seen = np.unique(log.frames.identifier)
    some = ", ".join(f"0x{identifier:X}" for identifier in seen[:IDS_SHOWN])
    more = f" and {seen.size - IDS_SHOWN} more" if seen.size > IDS_SHOWN else ""
    ours = counts.extended + counts.fd + counts.remote + counts.wrong_length
    unfit = (
        f", {ours} of them with an id of ours but unfit ({counts.extended} extended id, "
        f"{counts.fd} CAN FD, {counts.remote} remote, {counts.wrong_length} wrong length)"
        if ours
        else ""
    )
    raise CanLogError(
        f"{log.path}: no exoid frames (EXO_STATE 0x101, EXO_RAW 0x102, EXO_ACC 0x103) among "
        f"{counts.read} frames with ids {some}{more}{unfit}. If another device recorded the leg, "
        "give its DBC file and a map of its signals."
    )


def refuse_other_firmware(log: Log, told: int | None) -> None:
    """Where the node says what it was built from, it must be what this exoid can read."""
    if told and filter_of(told) is None:
        raise CanLogError(
            f"{log.path}: the node was built with another exoid.dbc or other filter constants "
            f"(ConfigCrc 0x{told:04X}, here 0x{config_crc():04X}), so that its numbers may mean "
            "something else. Flash this version's firmware, or give the DBC it was built with "
            "(dbc and signals)."
        )


def quality_of(log: Log, ordered: SortedFrames, found: list[Rows], samples: Samples) -> LogQuality:
    messages = ordered.messages
    duplicate = sum(rows.duplicate for rows in found)
    strayed = sum(rows.astray for rows in found)
    return LogQuality(
        path=str(log.path),
        frames=replace(
            ordered.counts,
            used=ordered.counts.used - duplicate - strayed,
            duplicate=duplicate,
            astray=strayed,
        ),
        clock="device" if messages[TIME].order.size else "counter",
        samples=sum(rows.tick.size for rows in found),
        messages=message_counts(found, messages, samples),
        encoder_counts=samples.encoder_counts,
        gaps=tuple(gap for rows in found for gap in gaps_in(rows.time, np.diff(rows.tick))),
        resets=tuple(float(rows.time[0]) for rows in found[1:]),
        faults=samples.faults,
        **told_by_time(messages[TIME], found),
        announced=log.announced,
        found=log.found,
        stopped=log.stopped,
    )


def message_counts(found: list[Rows], messages: dict[str, MessageFrames], samples: Samples):
    fine = (FINE,) if samples.encoder_counts > RAW_TURN else ()
    counts = [message_count(name, found) for name in (*SAMPLED, *fine)]
    if messages[TIME].order.size:
        period = round((messages[TIME].plan.period or PERIOD) / PERIOD)
        steps = [np.diff(rows.anchors.tick) for rows in found]
        expected = sum(int(np.rint(step / period).clip(1).sum()) + 1 for step in steps)
        used = sum(step.size + 1 for step in steps)
        jumps = sum(int((np.rint(step / period) > 1).sum()) for step in steps)
        counts.append(MessageCount(TIME, expected, used, jumps))
    return tuple(counts)


def message_count(name: str, found: list[Rows]) -> MessageCount:
    """How many frames there are, of how many ticks.

    A log may begin and end in the middle of a tick: the first and last are not expected.
    """
    expected = used = jumps = 0
    for rows in found:
        there = rows.frame[name] != MISSING
        span = int(rows.tick[-1] - rows.tick[0]) + 1
        expected += span - int(not there[0]) - int(not there[-1] and span > 1)
        used += int(there.sum())
        jumps += int((np.diff(rows.tick[there]) != 1).sum())
    return MessageCount(name, expected, used, jumps)


def told_by_time(time: MessageFrames, found: list[Rows]) -> dict:
    """What only EXO_TIME tells: ticks the node missed, and the CRC of its configuration."""
    if not time.order.size:
        return {}
    told, missed = time.values("MissedTicks"), 0
    for rows in found:
        places = np.searchsorted(time.order, rows.anchors.order)
        missed += int((np.diff(told[places]) % 256).sum())
    return {"missed_ticks": missed, "config_crc": int(np.median(time.values("ConfigCrc")))}
