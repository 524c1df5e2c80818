"""A recording as a stream: frames or samples in their order, as fast as asked for."""

import time
from collections.abc import Callable, Iterator
from math import inf, isfinite

import numpy as np

from exoid.online.recorded import PAUSE, columns_of
from exoid.recordings.can.frames import Log
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.live.decoding.stretch import take_all
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

AT_ONCE = 3100  # frames: ten seconds of a node
IN_PACE = 8  # frames, or samples, between two looks at the clock
LOOKED_EVERY = 0.1  # s


def of_log(log: Log, stream: NodeStream, together: int) -> Iterator[list[Reading]]:
    """Samples of the node's frames."""
    for first in range(0, len(log.frames), together):
        part = np.arange(first, min(first + together, len(log.frames)))
        take_all(stream, log.frames.where(part))
        yield stream.drained()


def of_recording(recording: Recording, together: int) -> Iterator[list[Reading]]:
    """Samples of any other recording, its segments one after the other."""
    begin = 0.0
    for segment in recording.segments:
        every = readings_of(segment, begin)
        for first in range(0, len(every), together):
            yield every[first : first + together]
        begin = every[-1].time + PAUSE


def readings_of(segment: Segment, begin: float) -> list[Reading]:
    rows = zip(*(each.tolist() for each in columns_of(segment, begin)), strict=True)
    every = [Reading(*row) for row in rows]
    known = next((at for at, each in enumerate(every) if isfinite(each.angle)), 0)
    every[known] = every[known]._replace(begins=True)
    return every


def play(
    parts: Iterator[list[Reading]],
    give: Callable[[list[Reading]], None],
    going: Callable[[float], bool],
    speed: float,
) -> None:
    """Give all samples, at `speed` times their own pace; `going` is asked with the stream's time,
    ten times a second at least.
    """
    begin, first, looked = time.monotonic(), None, -inf
    for readings in parts:
        give(readings)
        if not readings:
            continue
        first = readings[0].time if first is None else first
        due = begin + (readings[-1].time - first) / speed
        while True:
            now = time.monotonic()
            if now >= looked + LOOKED_EVERY:
                looked = now
                if not going(readings[-1].time):
                    return
            if now >= due:
                break
            time.sleep(min(due - now, LOOKED_EVERY))
