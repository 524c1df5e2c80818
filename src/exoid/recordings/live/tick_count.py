"""Which tick a frame belongs to, told live from its counter; and how many frames never came.

`device_clock` tells the same of a whole log at once. Here only the past is known: a silence of
more than 1.27 s is understood when the next EXO_TIME comes, which carries the node's clock.
"""

from dataclasses import dataclass

from exoid.recordings.can.device_clock import CLOCK_WRAP, COUNTER, MICROSECOND, PERIOD, nearest_tick


@dataclass
class Track:
    """The ticks of one message, and how many of its frames came."""

    first: int
    last: int
    count: int = 1

    def add(self, tick: int) -> None:
        self.count += tick != self.last
        self.last = max(self.last, tick)

    def add_all(self, last: int, count: int) -> None:
        """So many ticks up to `last`, each of which came."""
        self.count += count
        self.last = last

    @property
    def lost(self) -> int:
        return max(0, self.last - self.first + 1 - self.count)


class TickCount:
    """The node's ticks since the first sample, on one clock over restarts of the node."""

    def __init__(self):
        self.tick: int | None = None  # the latest
        self.begin = 0  # the tick at which the recording's clock is 0
        self.heard = 0.0  # s, host time of the latest
        self.anchor: tuple[int, int] | None = None  # tick and device time [us] of the last EXO_TIME
        self.tracks: dict[str, Track] = {}
        self.lost_before = 0  # before the last restart
        self.restarts = 0

    @property
    def seconds(self) -> float:
        """The latest tick [s] on the clock of the recording, as `load` will have it."""
        return 0.0 if self.tick is None else (self.tick - self.begin) * PERIOD

    @property
    def lost(self) -> int:
        """Frames whose counters were passed over."""
        return self.lost_before + sum(track.lost for track in self.tracks.values())

    def sample(self, name: str, counter: int, modulus: int, host: float, reset: bool) -> None:
        """A frame of STATE, RAW or ACC; `reset` where it says that the filter has just started."""
        if self.tick is None:
            if modulus < COUNTER:
                return  # too short a counter to begin with
            self.tick = self.begin = counter
        tick = nearest_tick(counter, self.tick, modulus)
        if reset and name in self.tracks and tick != self.tick + 1:
            tick = self.restart(counter, host)
        if name in self.tracks:
            self.tracks[name].add(tick)
        else:
            self.tracks[name] = Track(tick, tick)
        self.advance(tick, host)

    def clock(self, counter: int, device_us: int, host: float) -> None:
        """A frame of TIME: how many ticks have passed since the last one, lost or not."""
        if self.tick is None:
            return
        tick = nearest_tick(counter, self.tick, COUNTER)
        if self.anchor is not None:
            elapsed = (device_us - self.anchor[1]) % CLOCK_WRAP
            tick = self.anchor[0] + round(elapsed * MICROSECOND / PERIOD)
            if elapsed > CLOCK_WRAP / 2 or (tick - counter) % COUNTER:
                tick = self.restart(counter, host)
        self.anchor = (tick, device_us)
        self.advance(tick, host)

    def advance(self, tick: int, host: float) -> None:
        self.tick = tick if self.tick is None else max(self.tick, tick)
        self.heard = host

    def restart(self, counter: int, host: float) -> int:
        """The node counts anew; only host time tells how long it was away."""
        away = max(1, round((host - self.heard) / PERIOD))
        self.begin = counter - round(self.seconds / PERIOD) - away
        self.lost_before = self.lost
        self.restarts += 1
        self.tick, self.anchor = counter, None
        self.tracks.clear()
        return counter
