"""exoid node torque: let a node command a torque, on a bench."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated

import typer

from exoid.cli.inputs.node import (
    BITRATE,
    INTERFACE,
    Bitrate,
    Channel,
    Interface,
    Who,
    talking_to,
)
from exoid.cli.terminal.say import say

if TYPE_CHECKING:
    from exoid.recordings.commissioning.torque_host import Commanded

EVERY = 0.5  # s between two lines
STEP = 0.25  # N m, in which a node is told a limit


def torque(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    enable: Annotated[
        bool, typer.Option("--enable", help="Command it; else the node is armed alone, as a trial.")
    ] = False,
    limit: Annotated[
        float,
        typer.Option(min=0, max=15.75, help="Of the torque, in steps of 0.25 [N m].", metavar="NM"),
    ] = 1.0,
    seconds: Annotated[
        float, typer.Option(min=0.1, max=3600, help="How long.", metavar="S")
    ] = 10.0,
) -> None:
    """Let a node command a torque by its parameters, on a bench.

    This command says every 20 ms that it lives. Where it ends, by Ctrl-C or in any other way, the
    torque is 0 within 0.1 s; so it is at any fault of the node's sensors, and stays so until this
    command is called again.

    Emulated and simulated only: no motor and no person was ever near it. It is no safety function.

    \b
    Examples:
      exoid node torque --channel /dev/ttyACM0                 could it be enabled?
      exoid node torque --channel /dev/ttyACM0 --enable --limit 2 --seconds 10
    """
    from exoid.recordings.commissioning.torque_host import TorqueHost

    if limit % STEP:
        raise ValueError(f"--limit {limit:g}: give it in steps of {STEP:g} N m.")
    with talking_to(node, channel, interface, bitrate) as (dialogue, asked):
        host = TorqueHost(dialogue.bus, asked, limit)
        try:
            host.arm()
            say(f"{asked} is armed.")
            ended = host.enable(seconds, lines()) if enable else None
        finally:
            host.stop()
    if ended is not None:
        raise ValueError(f"{asked} has cut its torque to 0: {'; '.join(ended.doubts)}.")
    say("The torque is 0." if enable else "Nothing was enabled: give --enable.")


def lines() -> Callable[["Commanded"], None]:
    """Says the torque now and then."""
    begun, due = time.monotonic(), 0.0

    def tell(now: "Commanded") -> None:
        nonlocal due
        since = time.monotonic() - begun
        if since >= due:
            say(f"{since:5.1f} s  {now.torque:+6.2f} N m")
            due = since + EVERY

    return tell
