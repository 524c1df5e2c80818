"""`exoid live` of a file, from its beginning to its end."""

import time
from collections.abc import Callable
from functools import partial
from math import degrees, inf, isfinite
from pathlib import Path

from exoid.cli.live.opened import Opened
from exoid.cli.live.replay import AT_ONCE, IN_PACE, play
from exoid.cli.live.result import give, judge
from exoid.cli.live.viewing import Viewer, paged, viewing
from exoid.cli.live.wanted import Wanted
from exoid.cli.live.watched import LOOKED_EVERY, Watched
from exoid.cli.terminal.say import say
from exoid.cli.terminal.stopping import stoppable
from exoid.watching.board import Board
from exoid.watching.estimate.expect import is_known
from exoid.watching.origin import Origin

OVER, LEFT = "the file is over", "the file was left before its end"
WAITING = 4  # batches of samples of a file that are read ahead


def run_file(name: Path, opened: Opened, wanted: Wanted, speed: float) -> None:
    """Follow a recording until its end, or until the goals are reached."""
    board, views = Board(wanted.goals), wanted.views
    placed = {"load": opened.load, "thigh_angle": opened.thigh_angle, "node": opened.node}
    refined = speed != inf if wanted.refine is None else wanted.refine
    with stoppable() as stopped, paged(board, name.name, views) as address:
        with viewing(board, name.name, views, address) as viewer:
            origin = wanted.origin(opened.subject, **placed)
            follow_file(opened, origin, viewer, stopped, speed=speed, refined=refined)
        give(board, err=views.err)
        if address is not None and not stopped():
            stay(board, address)
    judge(board, lost=viewer.lost)


def stay(board: Board, address: str) -> None:
    """A page can be read until somebody ends it, or is gone."""
    say(f"exoid: {board.over}; its page stays until Ctrl-C: {address}", err=True)
    with stoppable(hangs_up=True) as left:
        while not left():
            time.sleep(LOOKED_EVERY)


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
        left = stopped() or watched.over
        watched.end(patient=lambda: not stopped(), over=LEFT if left else OVER)
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
