"""The node's samples as their frames come, tick by tick: the same live and of a log.

A sample is complete with its last frame, or when one of a later tick shows that the rest is lost.
"""

from math import nan

from exoid.recordings.can.device_clock import COUNTER, PERIOD, nearest_tick
from exoid.recordings.can.node.config_crc import filter_of
from exoid.recordings.can.node.rows import FINE, RAW, SAMPLED, STATE, TIME
from exoid.recordings.can.node.which import messages_of
from exoid.recordings.live.decoding.bits import Word, reader_of
from exoid.recordings.live.decoding.counts import Counts
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.live.decoding.tick import Tick
from exoid.recordings.live.second_node import Alternation
from exoid.recordings.live.tick_count import TickCount

UNHEARD = 50  # ticks without an EXO_RAW, from which on the filtered motion is taken
SILENT = 1.0  # s after which a counter of eight bits may have gone round: EXO_TIME tells
TOLD_WITHIN = 30  # ticks in which EXO_TIME comes, where it comes at all
TWO_NODES = (
    "two nodes send with the same ids: nobody can tell their samples apart, so nothing is "
    "estimated. Unplug one of them, or give it its own id (exoid node set)."
)
OTHER_FIRMWARE = (
    "the node was built with another exoid.dbc or other filter constants (ConfigCrc): its numbers "
    "may mean something else, so nothing is estimated. Flash the firmware of this exoid."
)


class NodeStream:
    """Takes frames, gives samples. `spoiled` says why nothing can be believed any more."""

    def __init__(self, node: int = 0):
        self.node = node
        plans = messages_of(node)
        takers = {TIME: self.clock, STATE: self.state, RAW: self.raw, FINE: self.fine}
        self.takers = {plans[name].identifier: taker for name, taker in takers.items()}
        self.counter = {name: reader_of(plans[name], "Counter") for name in takers}
        self.device_time = reader_of(plans[TIME], "DeviceTime")
        self.told_crc = reader_of(plans[TIME], "ConfigCrc")
        self.restarted = reader_of(plans[STATE], "FilterReset")
        self.meant: dict[int, bool] = {0: True}  # by ConfigCrc: does it mean what this exoid reads?
        self.counts, self.ticks, self.alternation = Counts(), TickCount(), Alternation()
        self.open: Tick | None = None
        self.last: int | None = None  # the latest tick that was opened
        self.heard: float | None = None  # s, host time
        self.unsure = 0  # ticks that may be others
        self.unheard = 0  # ticks without an EXO_RAW since the last one
        self.finer = False
        self.spoiled: str | None = None
        self.ready: list[Reading] = []

    @property
    def filtered(self) -> bool:
        """Are samples those of the node's filter, for want of others?"""
        return self.unheard >= UNHEARD

    def take(self, identifier: int, host: float, data: bytes) -> None:
        """A frame, and the host's time [s] of it; what the node does not sample is passed over."""
        taker = self.takers.get(identifier)
        if taker is None or len(data) != 8 or self.spoiled:
            return
        if self.heard is not None and host - self.heard > SILENT and self.ticks.anchor is not None:
            self.unsure = TOLD_WITHIN
        self.heard = host
        taker(int.from_bytes(data, "little"), host)

    def drained(self) -> list[Reading]:
        """What has become complete since the last call."""
        found, self.ready = self.ready, []
        return found

    def means_ours(self, told: int) -> bool:
        """Do the frames of a node with this ConfigCrc mean what they mean here?"""
        if told not in self.meant:
            self.meant[told] = filter_of(told) is not None
        return self.meant[told]

    def clock(self, word: Word, host: float) -> None:
        told, before = self.told_crc(word), self.ticks.restarts
        if not self.means_ours(told):
            self.spoiled = OTHER_FIRMWARE
            return
        self.ticks.clock(self.counter[TIME](word), self.device_time(word), host)
        if self.unsure:
            self.unsure, self.open = 0, None
        if self.ticks.restarts != before:
            self.begin_anew()

    def state(self, word: Word, host: float) -> None:
        counter = self.counter[STATE](word)
        self.alternation.add(counter, word.to_bytes(8, "little"))
        if self.alternation.found:
            self.spoiled = TWO_NODES
            return
        tick = self.opened(self.tick_of(STATE, counter, host, reset=bool(self.restarted(word))))
        if tick is not None and tick.state is None:
            tick.state = word
            if tick.raw is not None or self.filtered:
                self.close_if_whole(tick)

    def raw(self, word: Word, host: float) -> None:
        if self.filtered:
            self.unheard = 0
        tick = self.opened(self.tick_of(RAW, self.counter[RAW](word), host))
        if tick is not None and tick.raw is None:
            tick.raw = word
            self.close_if_whole(tick)

    def fine(self, word: Word, host: float) -> None:
        tick, number = self.open, self.ticks.tick
        if number is None or tick is None:
            self.finer = self.finer or number is not None
            return
        if nearest_tick(self.counter[FINE](word), number, COUNTER) == tick.number:
            tick.fine, self.finer = word, True
            self.close_if_whole(tick)

    def tick_of(self, name: str, counter: int, host: float, *, reset: bool = False) -> int | None:
        """The tick of a frame; None before any is known."""
        before = self.ticks.restarts
        self.ticks.sample(name, counter, SAMPLED[name], host, reset)
        if self.ticks.tick is None:
            return None
        if self.ticks.restarts != before:
            self.begin_anew()
        return nearest_tick(counter, self.ticks.tick, SAMPLED[name])

    def opened(self, number: int | None) -> Tick | None:
        """The tick with this number, if it is the one that is open, or a new one."""
        if self.open is not None and self.open.number == number:
            return self.open
        if number is None or (self.last is not None and number <= self.last):
            return None
        self.close()
        self.last = number
        self.open = Tick(number, (number - self.ticks.begin) * PERIOD)
        return self.open

    def close_if_whole(self, tick: Tick) -> None:
        if tick.state is None or (self.finer and tick.fine is None and not self.filtered):
            return
        if tick.raw is not None or self.filtered:
            self.close()

    def close(self) -> None:
        """What came of the open tick is a sample."""
        tick, self.open = self.open, None
        if tick is None:
            return
        self.unheard = 0 if tick.raw is not None else self.unheard + 1
        if self.unsure:
            self.unsure -= 1
            return
        motion = self.counts.measured(tick)
        if self.filtered:
            motion = (nan, nan) if tick.state is None else self.counts.filtered(tick.state)
        self.ready.append(Reading(tick.time, *motion))

    def begin_anew(self) -> None:
        """The node counts from elsewhere."""
        self.close()
        self.last = None
