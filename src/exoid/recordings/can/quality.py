"""How good a log is: what was lost of it, what is doubtful in it, told in lines a person reads."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float, Int

from exoid.files.counted import counted
from exoid.recordings.can.clock_rate import ClockRate, clock_lines
from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.node_estimate import NodeEstimate
from exoid.recordings.filter.constants import UNTOLD
from exoid.recordings.filter.effect import FilterEffect

SHOWN = 5  # gaps and resets that are listed one by one


@dataclass(frozen=True)
class Gap:
    """A stretch without any sample, in seconds of the recording."""

    start: float
    duration: float
    samples: int


def gaps_in(time: Float[np.ndarray, " sample"], steps: Int[np.ndarray, " step"]) -> list[Gap]:
    """Where more than one of the ticks, or periods, of a step lies between two samples."""
    return [
        Gap(float(time[at]), float(time[at + 1] - time[at]), int(steps[at]) - 1)
        for at in np.flatnonzero(steps > 1)
    ]


@dataclass(frozen=True)
class FrameCounts:
    """Every frame of the log under one heading: `read` is the sum of all the others."""

    read: int = 0
    used: int = 0
    error: int = 0
    foreign: int = 0
    remote: int = 0
    fd: int = 0
    extended: int = 0
    wrong_length: int = 0
    duplicate: int = 0
    astray: int = 0


@dataclass(frozen=True)
class MessageCount:
    """One message: how many frames its counter promises, how many were used, where it jumps."""

    name: str
    expected: int
    used: int
    jumps: int


@dataclass(frozen=True)
class LogQuality:
    """What is known about how complete a log is and how far its clock can be trusted."""

    path: str
    frames: FrameCounts
    clock: Literal["device", "counter", "host"]
    samples: int
    messages: tuple[MessageCount, ...] = ()
    gaps: tuple[Gap, ...] = ()
    resets: tuple[float, ...] = ()  # s of the recording at which the node had started again
    clock_rate: ClockRate | None = None  # of the node's clock; None where no host time tells it
    host_jitter: float | None = None  # s, of the host times that make up the time themselves
    faults: tuple[tuple[str, int], ...] = ()  # status bit, samples that carry it
    missed_ticks: int = 0  # ticks the node itself reports as missed
    config_crc: int | None = None
    design: str | None = None  # which of the node's filters ran, as [sensors] filter has it
    commissioned: tuple[str, ...] = ()  # zero, direction and firmware, and what changed of them
    learned: NodeEstimate | None = None  # what the node said of the leg at last
    encoder_counts: int | None = None  # a turn, of the node's encoder
    filter: FilterEffect | None = None
    announced: int | None = None
    found: int | None = None
    stopped: str | None = None  # what of the file could not be read, and why
    notes: tuple[str, ...] = ()

    @property
    def skew_ppm(self) -> float | None:
        """How much faster than the host's the node's clock runs [ppm]; None where none can tell."""
        return None if self.clock_rate is None else self.clock_rate.excess * 1e6

    def losses(self) -> list[str]:
        """What of the log is missing; strict reading refuses all of it."""
        frames = self.frames
        told = [
            (self.stopped, f"not read: {self.stopped}"),
            (self.announced_missing, self.announced_line),
            (frames.remote, f"{counted(frames.remote, 'remote frame')} with an id of ours"),
            (frames.fd, f"{counted(frames.fd, 'CAN FD frame')} with an id of ours"),
            (
                frames.extended,
                f"{counted(frames.extended, 'frame')} with our id in the wrong id format",
            ),
            (frames.wrong_length, f"{counted(frames.wrong_length, 'frame')} of the wrong length"),
            (frames.astray, f"{counted(frames.astray, 'frame')} out of order, left out"),
        ]
        lines = [line for found, line in told if found]
        lines += [
            f"{count.name}: {count.expected - count.used} of {counted(count.expected, 'frame')} "
            f"lost, {self.jumps_line(count.jumps)}"
            for count in self.messages
            if count.expected > count.used
        ]
        return lines + self.gap_lines() + self.reset_lines()

    @property
    def announced_missing(self) -> bool:
        """Whether the file's header counts other than what is there."""
        return self.announced is not None and self.announced != self.found

    @property
    def announced_line(self) -> str:
        if not self.announced:
            why = "the logger was killed, or its disk was full"
            return f"the header was never completed ({why}); {self.found} found"
        return (
            f"the header announces {counted(self.announced, 'object')}, the file holds {self.found}"
        )

    def jumps_line(self, jumps: int) -> str:
        """By what it is known that frames are lost: where there is no counter, by their times."""
        if self.clock == "host":
            return f"by their times in {counted(jumps, 'place')}"
        return f"the counter jumps {counted(jumps, 'time')}"

    def gap_lines(self) -> list[str]:
        longest = sorted(self.gaps, key=lambda gap: -gap.duration)[:SHOWN]
        lines = [
            f"gap of {gap.duration:.2f} s ({counted(gap.samples, 'sample')}) at {gap.start:.2f} s"
            for gap in sorted(longest, key=lambda gap: gap.start)
        ]
        rest = len(self.gaps) - len(lines)
        return lines + ([counted(rest, "shorter gap")] if rest else [])

    def reset_lines(self) -> list[str]:
        places = ", ".join(f"{at:.2f} s" for at in self.resets[:SHOWN])
        count = len(self.resets)
        return [f"the node started again {counted(count, 'time')}, at {places}"] if count else []

    def lines(self) -> list[str]:
        """The report, line by line: what was read, by which clock, what is missing or masked."""
        frames = self.frames
        lines = [
            f"{self.samples} samples from {frames.used} of {frames.read} frames",
            f"time from the {CLOCKS[self.clock]}",
        ]
        if self.clock != "host":
            lines += clock_lines(self.clock_rate)
        if self.host_jitter is not None:
            lines.append(f"host time jitters by {self.host_jitter * 1e3:.2f} ms (not used)")
        lines += self.commissioned
        lines += self.losses()
        lines += [f"{counted(frames.foreign, 'frame')} of other nodes"] if frames.foreign else []
        lines += [f"{counted(frames.error, 'error frame')} on the bus"] if frames.error else []
        lines += (
            [f"{counted(frames.duplicate, 'duplicate frame')} left out"] if frames.duplicate else []
        )
        lines += [f"{name}: {counted(count, 'sample')}" for name, count in self.faults if count]
        lines += (
            [f"the node missed {counted(self.missed_ticks, 'tick')}"] if self.missed_ticks else []
        )
        lines += self.filter_lines()
        lines += [self.learned.line] if self.learned is not None else []
        return lines + [note for note in self.notes if note not in lines]

    def filter_lines(self) -> list[str]:
        """What the filter did, and that it is not known where it matters which one it was."""
        if self.filter is None:
            return []
        unknown = self.design is None and self.filter.fitted
        return self.filter.lines() + ([f"no ConfigCrc says {UNKNOWN_FILTER}"] if unknown else [])

    def require_complete(self) -> None:
        """**Raises** `CanLogError` when anything is missing."""
        if losses := self.losses():
            raise CanLogError(
                f"{self.path} is not complete: {'; '.join(losses)}. "
                "Read it without strict to use the rest."
            )


UNKNOWN_FILTER = (
    f"which filter made the channels that are fitted: a fit takes it for that of {UNTOLD}. Say "
    "which in [sensors] filter"
)
CLOCKS = {
    "device": "node's clock (EXO_TIME and counter)",
    "counter": "node's counter alone: no EXO_TIME frame, so its period is taken as 10 ms",
    "host": "recording computer's clock: no counter",
}
