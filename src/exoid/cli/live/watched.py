"""A leg that is watched: a stream goes to its follower, and what is found to the board."""

import time
from collections.abc import Callable, Sequence
from math import inf
from typing import TYPE_CHECKING

from exoid.cli.live.panel import Panel
from exoid.cli.terminal.say import ring
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.decoding.reading import Reading
from exoid.watching.estimate.moment import Sink
from exoid.watching.follower import Company, Follower

if TYPE_CHECKING:
    import can

QUIET = 1.0  # s without a sample, from which on a person should know
FILTERED = (
    "the node sends no encoder and gyro of its own (EXO_RAW): its filtered motion is taken, which "
    "is smooth and late; errors are too small by what that hides."
)
ANYBODY = (
    "nobody says whose leg it is, so that of any adult is expected: give --body-mass KG and "
    "--height M."
)
FITTING = "{}; the batch fit of its drops is still made: Ctrl-C ends without it."
LOOKED_EVERY = 0.1  # s, at what helpers have found
PATIENCE = 3.0  # s that what was heard may take to be taken in at the end


class Watched:
    """The board, who writes on it, and the panel that shows it."""

    def __init__(
        self, make: Callable[[], Company], panel: Panel, sinks: Sequence[Sink], most: int = 0
    ):
        self.board, self.panel = panel.board, panel
        self.stream: NodeStream | None = None
        self.known = True  # whose leg it is
        self.given = time.monotonic()
        self.heard = -inf  # s, of the last sample, by the node's clock
        self.told: set[str] = set()
        self.follower = Follower(make, self.board, sinks, most)

    def hear(self, message: "can.Message") -> None:
        """A frame of the bus."""
        assert self.stream is not None
        strange = message.is_extended_id or message.is_remote_frame or message.is_fd
        if not strange and not message.is_error_frame:
            self.stream.take(message.arbitration_id, message.timestamp, bytes(message.data))
            self.give(self.stream.drained())

    def give(self, readings: list[Reading]) -> None:
        if readings:
            self.given, self.heard = time.monotonic(), readings[-1].time
            self.follower.give(readings)

    def tell(self, sentence: str) -> None:
        self.panel.tell(sentence)

    def show(self, line: str) -> None:
        """A moment of the stream, in a line."""
        quiet = time.monotonic() - self.given
        waits = self.board.state == "following" and self.board.moment is not None
        self.board.silent = quiet if quiet > QUIET and waits else 0.0
        self.look()
        self.panel.show(line)

    def look(self) -> None:
        """At what is wrong with the stream, and at what was found beside it."""
        self.once(None if self.known or self.board.moment is None else ANYBODY)
        if self.stream is not None:
            self.board.spoiled = self.stream.spoiled
            self.once(self.stream.spoiled)
            self.once(FILTERED if self.stream.filtered else None)
        if self.follower.company is not None:
            self.follower.company.look(self.board)

    def once(self, sentence: str | None) -> None:
        if sentence is not None and sentence not in self.told:
            self.told.add(sentence)
            self.tell(sentence)

    @property
    def over(self) -> bool:
        """Is there nothing more to wait for?"""
        return self.board.reached or self.board.fault is not None

    def end(self, patient: Callable[[], bool], over: str = "") -> None:
        """Take in what was heard, and while one is `patient` what helpers still look for: then
        the board says that it is `over`.
        """
        self.follower.end(None if patient() else PATIENCE)
        company, moment = self.follower.company, self.board.moment
        if company is not None and moment is not None and patient() and not self.over:
            company.ask_anew(moment)
        self.look()
        self.board.over = over
        while company is not None and company.busy and patient() and not self.over:
            self.once(FITTING.format(over) if company.fits else None)
            time.sleep(LOOKED_EVERY)
            self.look()
        if company is not None:
            company.close()
        self.board.silent = 0.0
        if self.board.reached:
            ring()
