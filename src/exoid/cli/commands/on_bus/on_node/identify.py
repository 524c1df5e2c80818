"""exoid node identify: which of the boards it is."""

from typing import Annotated

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


def identify(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    duration: Annotated[
        int, typer.Option(min=1, max=255, help="How long it blinks [s].", metavar="S")
    ] = 10,
) -> None:
    """Let a node blink ten times a second, to see which board it is.

    \b
    Examples:
      exoid node identify --channel /dev/ttyACM0
      exoid node identify --interface socketcan --channel can0 --node C0FFEE01
    """
    from exoid.recordings.commissioning.commands import IDENTIFY

    with talking_to(node, channel, interface, bitrate) as (dialogue, asked):
        state = dialogue.order(asked, IDENTIFY, Duration=duration)
    say(f"{state} blinks for {duration} s.")
