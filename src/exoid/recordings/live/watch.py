"""What a person should know while a bus is recorded; what goes wrong is told once, in words."""

import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import can

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.commissioned import SETTINGS
from exoid.recordings.can.node.config_crc import LEARNED, filter_of
from exoid.recordings.can.node.health import HEALTH
from exoid.recordings.can.node.last_estimate import LastEstimate
from exoid.recordings.can.node.one_frame import unsigned, values_of
from exoid.recordings.can.node.rows import SAMPLED, STATE, TIME
from exoid.recordings.can.node.samples import STATUS
from exoid.recordings.can.node.which import MEASURED, messages_of, senders
from exoid.recordings.can.node_estimate import NodeEstimate
from exoid.recordings.live.health_watch import HealthWatch
from exoid.recordings.live.mounting_watch import MountingWatch
from exoid.recordings.live.second_node import Alternation
from exoid.recordings.live.silence import SILENT_SINCE, why_silent
from exoid.recordings.live.tick_count import TickCount

SILENCE = 2.0  # s without a frame of the node, after which a person should know
RATED_OVER = 1.0  # s
SEEN = (*MEASURED, SETTINGS, HEALTH, *LEARNED)
START_BIT = "FilterReset"  # a status bit that is no fault


@dataclass(frozen=True)
class Status:
    """A moment of the recording; angle and rate NaN before the first EXO_STATE."""

    seconds: float  # on the recording's clock
    angle: float  # rad
    angular_velocity: float  # rad/s
    rate: float  # frames/s
    lost: int
    bad: int
    faults: tuple[tuple[str, int], ...]
    learned: NodeEstimate | None = None


class Watch:
    """Looks at every frame that is recorded, and at the silence between them."""

    def __init__(self, tell: Callable[[str], Any], config_crc: int, only: int | None = None):
        node = only or 0
        self.plans = {messages_of(node)[name].identifier: messages_of(node)[name] for name in SEEN}
        self.node, self.only = node, only  # the id of the node; whether to leave out others
        self.tell = tell
        self.told: set[str] = set()
        self.config_crc = config_crc
        self.ticks = TickCount()
        self.alternation = Alternation()
        self.mounting, self.health = MountingWatch(), HealthWatch()
        self.estimate = LastEstimate()
        self.told_crc: int | None = None  # by the last EXO_TIME
        self.faults: Counter[str] = Counter()
        self.state: bytes | None = None  # of the last EXO_STATE
        self.frames = self.errors = self.ours = 0
        self.heard = time.monotonic()
        self.began: float | None = None  # s, monotonic, with the first frame
        self.first: float | None = None  # s, host time of the first frame
        self.latest = 0.0
        self.rated = (time.monotonic(), 0, 0.0)  # when, frames until then, frames/s before it

    @property
    def seconds(self) -> float:
        """The recording's clock: the node's where it sends, else this computer's."""
        if self.ticks.tick is not None:
            return self.ticks.seconds
        return 0.0 if self.first is None else self.latest - self.first

    def is_wanted(self, message: can.Message) -> bool:
        """Whether it belongs into the log: where one of several nodes is recorded, not others'."""
        sender = None if self.only is None else senders().get(message.arbitration_id)
        return sender is None or sender[0] == self.only

    def see(self, message: can.Message) -> None:
        """A frame that was recorded."""
        self.frames += 1
        self.latest = message.timestamp
        if self.first is None:
            self.first = message.timestamp
            self.began = time.monotonic()
        if message.is_error_frame:
            self.see_error()
            return
        plan = self.plans.get(message.arbitration_id)
        plain = not (message.is_extended_id or message.is_remote_frame or message.is_fd)
        if plan is None or not plain or len(message.data) != plan.length:
            self.check_silence(0)
            return
        self.ours += 1
        self.heard = time.monotonic()
        self.told.discard("silence")
        self.see_ours(plan, bytes(message.data), message.timestamp)

    def see_error(self) -> None:
        self.errors += 1
        self.once(
            "errors",
            "the bus reports errors. Check the bit rate, the wiring, and that both ends of the bus "
            "carry 120 ohm.",
        )

    def see_ours(self, plan: MessagePlan, data: bytes, host: float) -> None:
        if plan.name not in MEASURED:
            self.see_told(plan, data)
            return
        told = {each.name: each for each in plan.signals}
        counter = unsigned(data, told["Counter"])
        if plan.name == TIME:
            self.ticks.clock(counter, unsigned(data, told["DeviceTime"]), host)
            self.told_crc = unsigned(data, told["ConfigCrc"])
            self.check_config(self.told_crc)
            return
        reset = False
        if plan.name == STATE:
            self.state = data
            bits = [name for name in STATUS if unsigned(data, told[name])]
            reset = START_BIT in bits
            self.faults.update(name for name in bits if name != START_BIT)
            self.check_alone(counter, data)
        if plan.name in SAMPLED:
            self.ticks.sample(plan.name, counter, SAMPLED[plan.name], host, reset)

    def see_told(self, plan: MessagePlan, data: bytes) -> None:
        """Only a node that is known to tell of itself is believed to be the sender."""
        if self.told_crc != self.config_crc:
            return
        watches = {HEALTH: self.health, SETTINGS: self.mounting}
        for sentence in watches.get(plan.name, self.estimate).see(plan, data):
            self.tell(sentence)

    def check_config(self, told: int) -> None:
        if told != self.config_crc and filter_of(told) is None:
            self.once(
                "config",
                f"the node was built with another exoid.dbc or other filter constants (ConfigCrc "
                f"0x{told:04X}, here 0x{self.config_crc:04X}): its numbers may mean something "
                "else. The frames are kept; flash the node with the firmware of this exoid, or "
                "read the log with the exoid of the node.",
            )

    def check_alone(self, counter: int, data: bytes) -> None:
        self.alternation.add(counter, data)
        if self.alternation.found:
            self.once(
                "second",
                "two nodes send with the same ids: the counters of EXO_STATE alternate, and nobody "
                "can tell their samples apart. Unplug one of them and record again.",
            )

    def check_silence(self, bad: int) -> None:
        """Nothing of the node came just now; `bad` lines have come in all that are no frames."""
        if time.monotonic() - self.heard >= SILENCE:
            self.once("silence", f"{SILENCE:g} s without a frame of the node: {self.silence(bad)}")

    def silence(self, bad: int) -> str:
        """Why nothing may come of the node."""
        if self.ours:
            return SILENT_SINCE
        return why_silent(self.frames > self.errors, bad, self.node)

    def once(self, key: str, sentence: str) -> None:
        if key not in self.told:
            self.told.add(key)
            self.tell(sentence)

    def status(self, bad: int) -> Status:
        """This moment; `bad` as in `check_silence`."""
        angle, velocity = self.motion()
        return Status(
            seconds=self.seconds,
            angle=angle,
            angular_velocity=velocity,
            rate=self.rate(),
            lost=self.ticks.lost,
            bad=bad,
            faults=tuple(sorted(self.faults.items())),
            learned=self.estimate.known,
        )

    def motion(self) -> tuple[float, ...]:
        """Angle [rad] and rate [rad/s] of the last EXO_STATE."""
        if self.state is None:
            return float("nan"), float("nan")
        return values_of(messages_of(self.node)[STATE], self.state, ("Angle", "AngularVelocity"))

    def rate(self) -> float:
        """Frames/s over the last second."""
        now, (since, before, rate) = time.monotonic(), self.rated
        if now - since >= RATED_OVER:
            rate = (self.frames - before) / (now - since)
            self.rated = (now, self.frames, rate)
        return rate
