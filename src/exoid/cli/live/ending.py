"""What `exoid record` says at its end, and `exoid live` of what it has kept."""

from collections.abc import Iterator
from contextlib import suppress

from exoid.cli.live.session import NAMES, Session
from exoid.cli.terminal.faults import one_line
from exoid.cli.terminal.say import say
from exoid.files.counted import counted
from exoid.recordings.live.channel.address import CanBusError
from exoid.recordings.live.log_file import LogFile
from exoid.recordings.loading.can_log import read_can_log


def conclude(session: Session, *, err: bool = False) -> None:
    """What was recorded, as `exoid fit` will read it, and what to do with it."""
    watch, log = session.watch, session.log
    kept = isinstance(log, LogFile)
    if not watch.frames:
        done = "recorded" if kept else "heard"
        raise CanBusError(
            f"nothing was {done} from {session.bus.address}: {watch.silence(session.bus.bad)}"
        )
    if kept:
        with suppress(OSError):  # nobody is there to read it: the terminal is gone
            say(*lines_of(session), err=err)


def lines_of(session: Session) -> Iterator[str]:
    path, watch, marked = session.log.path, session.watch, session.marks.closed
    yield f"{path}: {watch.seconds:.1f} s, {watch.frames} frames; sidecar {session.sidecar}"
    if session.bus.bad:
        yield f"{counted(session.bus.bad, 'bad line')}, no frames, left out"
    if marked:
        yield ", ".join(f"{NAMES[kind]} {a:.1f} to {b:.1f} s" for kind, a, b in marked)
    try:
        _, quality = read_can_log(path)
    except (OSError, ValueError) as fault:
        yield one_line(fault)
        return
    yield from quality.lines()
    options = "" if session.subject.body_mass else " --body-mass KG --height M"
    yield f"next: exoid fit {path}{options}"
