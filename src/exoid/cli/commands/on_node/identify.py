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
    check_name,
    chosen,
    talking,
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
    check_name(node)
    from exoid.recordings.commissioning.commands import IDENTIFY

    with talking(channel, interface, bitrate) as dialogue:
        state = dialogue.order(chosen(dialogue.find(), node), IDENTIFY, Duration=duration)
    say(f"{state} blinks for {duration} s.")
