"""One recording under way: the bus, the log, what is shown, and the keys that mark segments."""

import time
from collections.abc import Callable
from dataclasses import replace
from math import degrees, inf
from pathlib import Path
from typing import Protocol

import can

from exoid.cli.terminal.faults import one_line
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.declared.protocol import Kind
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.live.log_file import LogFile, Unkept
from exoid.recordings.live.marks import Marks
from exoid.recordings.live.record import record
from exoid.recordings.live.watch import Status, Watch
from exoid.recordings.sidecar import write_sidecar

LOOKED_EVERY = 0.1  # s, at keys and clock
KEYS: dict[str, Kind] = {"d": "passive", "c": "active"}
NAMES = {"passive": "drop", "active": "cycle"}
END = " "
BESIDE = ".recorded.toml"
HELP = "keys: d a drop begins, c a cycle begins, space it ends; Ctrl-C ends the recording."


class Shown(Protocol):
    """Where a person looks."""

    def tell(self, sentence: str) -> None: ...

    def show(self, line: str) -> None: ...


class Session:
    """Records until it is stopped; the sidecar is there with the first frame and with each mark."""

    def __init__(
        self,
        log: LogFile | Unkept,
        subject: Subject,
        screen: Shown,
        pressed: Callable[[], str] | None,
        node: int | None = None,
    ):
        self.log, self.subject, self.screen, self.pressed = log, subject, screen, pressed
        self.hear: Callable[[can.Message], None] = lambda message: None
        self.marking = True  # do keys mark segments?
        self.keys: dict[str, Callable[[], None]] = {}  # and what do others do?
        self.added: Callable[[float], Subject] = lambda begin: subject  # with what was on it then
        self.watch = Watch(screen.tell, config_crc(), node)
        self.marks = Marks()
        self.described: bytes | None = None  # what the sidecar says, as it was written
        self.beside = False  # another wrote the sidecar meanwhile
        self.looked = 0.0

    @property
    def sidecar(self) -> Path:
        return self.log.path.with_suffix(BESIDE if self.beside else ".toml")

    def run(self, address: BusAddress, stopped: Callable[[], bool], duration: float | None) -> None:
        """Record from the bus; whatever ends it, the files are complete."""
        self.bus = LiveBus(address, self.screen.tell)
        doing = "following" if isinstance(self.log, Unkept) else "recording"
        self.screen.tell(f"{doing} {address} at {address.bitrate} bit/s. Ctrl-C ends it.")
        if self.pressed is not None and self.marking:
            self.screen.tell(HELP)
        begin = time.monotonic()

        def going() -> bool:
            now = time.monotonic()
            if now >= self.looked + LOOKED_EVERY:
                self.looked = now
                self.look()
            since = begin if self.watch.began is None else self.watch.began
            return not stopped() and now < since + (inf if duration is None else duration)

        try:
            record(self.bus, self.log, self.watch, going, self.hear)
        finally:
            self.bus.close()
            self.marks.end(self.watch.seconds)
            if self.log.frames:
                self.describe()
            self.log.close()

    def look(self) -> None:
        """At what was typed, and show how it goes."""
        if self.described is None and self.log.frames:
            self.described = b""
            self.describe()
        for key in self.pressed() if self.pressed is not None else "":
            self.keys.get(key, lambda key=key: self.mark(key))()
        self.screen.show(f"{live_line(self.watch.status(self.bus.bad))}{self.open_segment()}")

    def mark(self, key: str) -> None:
        if not self.marking or key not in {*KEYS, END}:
            return
        if not self.log.frames:
            self.screen.tell(
                f"'{key}' marks nothing: no frame has come yet. Press it again once angles are "
                "shown."
            )
            return
        if key in KEYS:
            self.marks.begin(KEYS[key], self.watch.seconds)
        else:
            self.marks.end(self.watch.seconds)
        self.describe()

    def open_segment(self) -> str:
        number = len(self.marks.closed) + 1
        return "" if self.marks.open is None else f"  [{NAMES[self.marks.open[0]]} {number}]"

    def describe(self) -> None:
        """Write the sidecar, none that is another's; nothing about it may end the recording."""
        if not self.beside and self.is_of_another():
            there, self.beside = self.sidecar, True
            self.screen.tell(
                f"{there} was written by another meanwhile and stays. What is known of this "
                f"recording goes to {self.sidecar}: bring the two together before a fit."
            )
        try:
            write_sidecar(self.loaded(), self.marks.protocol(), Sensors(), self.sidecar)
            self.described = self.sidecar.read_bytes()
        except (OSError, ValueError) as fault:
            self.screen.tell(f"the sidecar cannot be written: {one_line(fault)}")

    def loaded(self) -> Subject:
        """With what was on the shank in each segment."""
        each = [self.added(begin) for _, begin, _ in self.marks.closed] or [self.added(inf)]
        if all(one == each[0] for one in each):
            return each[0]
        return replace(
            self.subject,
            added_mass=tuple(one.added_mass or 0.0 for one in each),
            added_mass_distance=None
            if self.subject.added_mass_distance is None
            else tuple(one.added_mass_distance or 0.0 for one in each),
        )

    def is_of_another(self) -> bool:
        """Is there a sidecar that this recording has not written, and was not told to replace?"""
        if not self.described and self.log.replace:
            return False
        try:
            return self.sidecar.read_bytes() != (self.described or b"")
        except OSError:
            return False


def live_line(now: Status) -> str:
    """A moment in one line, in degrees."""
    if not now.seconds > 0:
        return "waiting for the node"
    parts = [
        f"{now.seconds:7.1f} s",
        f"{degrees(now.angle):+7.1f} deg",
        f"{degrees(now.angular_velocity):+7.1f} deg/s",
        f"{now.rate:4.0f} frames/s",
        f"{now.lost} lost",
    ]
    parts += [f"{now.bad} bad"] if now.bad else []
    parts += [now.learned.short] if now.learned is not None and now.learned.drops else []
    return "  ".join([*parts, *(f"{name} {count}" for name, count in now.faults)])
