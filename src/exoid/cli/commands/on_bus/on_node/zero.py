"""exoid node zero: where the knee is now."""

from math import radians
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


def zero(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    angle: Annotated[
        float,
        typer.Option(
            min=-180, max=180, help="Of the knee now [deg]: 0 extended, -90 hanging.", metavar="DEG"
        ),
    ] = 0.0,
) -> None:
    """Take the angle at which the knee is held now as known.

    It is fully extended, or at --angle. Set a direction before the zero: with --angle it counts.
    The knee has to be still.

    \b
    Examples:
      exoid node zero --channel /dev/ttyACM0                 the knee is fully extended
      exoid node zero --channel /dev/ttyACM0 --angle -90     the shank hangs, the thigh is level
    """
    with talking_to(node, channel, interface, bitrate) as (dialogue, before):
        after = dialogue.zero(before, radians(angle))
    say(
        f"{after}: the knee is at {angle:g} deg; the zero was {before.mounting.zero} and is "
        f"{after.mounting.zero}."
    )
