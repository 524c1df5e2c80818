"""`exoid live` of a node on a bus, from its beginning to its end."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from exoid.cli.live.ending import conclude
from exoid.cli.live.result import give, judge
from exoid.cli.live.session import Session
from exoid.cli.live.viewing import Viewer, paged, viewing
from exoid.cli.live.wanted import Wanted
from exoid.cli.live.watched import Watched
from exoid.cli.live.weighing import KEY, Weighing
from exoid.cli.terminal.keys import has_keyboard, keyboard
from exoid.cli.terminal.stopping import stoppable
from exoid.recordings.declared.subject import Subject
from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.log_file import LogFile, Unkept
from exoid.watching.board import Board
from exoid.watching.estimate.expect import is_known
from exoid.watching.estimate.load import constant_load
from exoid.watching.estimate.switch import Switch
from exoid.watching.origin import Origin


class Bus:
    """A node on a bus; its frames are kept in a log as `exoid record` keeps them."""

    def __init__(
        self, address: BusAddress, log: LogFile | Unkept, subject: Subject, node: int | None
    ):
        self.address, self.log, self.subject, self.node = address, log, subject, node

    def follow(
        self,
        origin: Origin,
        viewer: Viewer,
        stopped: Callable[[], bool],
        *,
        pressed: Callable[[], str] | None,
        marked: bool,
        duration: float | None,
        refined: bool,
    ) -> Session:
        """Until it is `stopped`, has lasted, or the goals are reached."""
        make = partial(origin.company, coached=True, refined=refined)
        watched = Watched(make, viewer.panel, viewer.sinks)
        board = watched.board
        watched.stream = NodeStream(self.node or 0)
        watched.known = is_known(origin.subject)
        session = Session(self.log, self.subject, watched, pressed, self.node)
        session.hear, session.marking = watched.hear, marked
        if isinstance(origin.load, Switch):
            Weighing(origin.load, session, watched)
            session.screen.tell(f"key {KEY}: the added mass is taken off, or put on. It is on now.")

        def ended() -> bool:
            """Where it is kept, a fault of the estimator must not end the recording."""
            lost = board.fault is not None and isinstance(self.log, Unkept)
            return stopped() or board.reached or lost

        try:
            session.run(self.address, ended, duration)
        finally:
            watched.end(patient=lambda: False)
        return session


def bus_of(
    where: tuple[str, str, int],
    output: Path | None,
    subject: Subject,
    node: int | None,
    *,
    force: bool,
) -> Bus:
    """The bus at interface, channel and bit rate, kept in a log where one is asked for."""
    log = Unkept() if output is None else LogFile(output, replace=force)
    return Bus(BusAddress(*where), log, subject, node)


def run_bus(bus: Bus, wanted: Wanted, *, marked: bool, duration: float | None) -> None:
    """Follow a node until somebody stops it, it has lasted, or the goals are reached."""
    board = Board(wanted.goals)
    load = constant_load(bus.subject)
    origin = wanted.origin(bus.subject, load=Switch(load.masses[0]) if load.known else load)
    keys = marked or (load.known and has_keyboard())
    with (
        stoppable() as stopped,
        paged(board, str(bus.address), wanted.views) as address,
        viewing(board, str(bus.address), wanted.views, address) as viewer,
        keyboard(keys) as pressed,
    ):
        session = bus.follow(
            origin,
            viewer,
            stopped,
            pressed=pressed if keys else None,
            marked=marked,
            duration=duration,
            refined=wanted.refine is not False,
        )
    conclude(session, err=wanted.views.err)
    give(board, err=wanted.views.err)
    judge(board, lost=viewer.lost)
