"""A bus or a file, followed to its end."""

from collections.abc import Callable
from functools import partial
from math import degrees, inf, isfinite
from pathlib import Path

from exoid.cli.live.opened import Opened
from exoid.cli.live.replay import AT_ONCE, IN_PACE, play
from exoid.cli.live.session import Session
from exoid.cli.live.viewing import Viewer
from exoid.cli.live.watched import Watched
from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.log_file import LogFile, Unkept
from exoid.recordings.recording import Subject
from exoid.watching.estimate.expect import is_known
from exoid.watching.origin import Origin

WAITING = 4  # batches of samples of a file that are read ahead


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
        duration: float | None,
        refined: bool,
    ) -> Session:
        """Until it is `stopped`, has lasted, or the goals are reached."""
        make = partial(origin.company, coached=True, refined=refined)
        watched = Watched(make, viewer.panel, viewer.sinks)
        watched.stream = NodeStream(self.node or 0)
        watched.known = is_known(origin.subject)
        session = Session(self.log, self.subject, watched, pressed, self.node)
        session.hear = watched.hear
        try:
            session.run(self.address, lambda: stopped() or watched.over, duration)
        finally:
            watched.end(patient=False)
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


def follow_file(
    opened: Opened,
    origin: Origin,
    viewer: Viewer,
    stopped: Callable[[], bool],
    *,
    speed: float,
    refined: bool,
) -> None:
    """Until its end, or until it is `stopped` or the goals are reached."""
    fast = speed == inf
    make = partial(origin.company, coached=True, refined=refined)
    watched = Watched(make, viewer.panel, viewer.sinks, WAITING if fast else 0)
    watched.stream = opened.stream
    watched.known = is_known(origin.subject)

    def going(_: float) -> bool:
        watched.show(line_of(watched))
        return not (stopped() or watched.over)

    try:
        play(opened.parts(AT_ONCE if fast else IN_PACE), watched.give, going, speed)
    finally:
        watched.end(patient=not stopped())
        watched.panel.show(line_of(watched))


def line_of(watched: Watched) -> str:
    """A moment of a file in one line, in degrees."""
    moment, stream = watched.board.moment, watched.stream
    if moment is None:
        return ""
    turning = moment.angular_velocity
    parts = [f"{moment.time:7.1f} s", f"{degrees(moment.angle):+7.1f} deg"]
    parts += [f"{degrees(turning):+7.1f} deg/s"] if isfinite(turning) else []
    parts += [f"{stream.ticks.lost} lost"] if stream is not None else []
    return "  ".join(parts)
