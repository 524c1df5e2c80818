"""What `exoid record` says at its end."""

from contextlib import suppress

from exoid.cli.live.session import NAMES, Session
from exoid.cli.terminal.faults import one_line
from exoid.cli.terminal.say import say
from exoid.recordings.live.channel.address import CanBusError
from exoid.recordings.loading.can_log import read_can_log


def conclude(session: Session) -> None:
    """What was recorded, as `exoid fit` will read it, and what to do with it."""
    watch = session.watch
    if not watch.frames:
        raise CanBusError(
            f"nothing was recorded from {session.bus.address}: {watch.silence(session.bus.bad)}"
        )
    with suppress(OSError):  # nobody is there to read it: the terminal is gone
        tell(session)


def tell(session: Session) -> None:
    path, watch, marked = session.log.path, session.watch, session.marks.closed
    say(f"{path}: {watch.seconds:.1f} s, {watch.frames} frames; sidecar {session.sidecar}")
    if session.bus.bad:
        say(f"{session.bus.bad} bad line(s) were no frames and are left out")
    if marked:
        say(", ".join(f"{NAMES[kind]} {a:.1f} to {b:.1f} s" for kind, a, b in marked))
    try:
        _, quality = read_can_log(path)
    except (OSError, ValueError) as fault:
        say(one_line(fault))
        return
    for line in quality.lines():
        say(line)
    options = "" if session.subject.body_mass else " --body-mass KG --height M"
    say(f"next: exoid fit {path}{options}")
