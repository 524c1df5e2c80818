"""exoid node set: direction, id and bit rate of a node."""

from typing import Annotated, Literal

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
from exoid.cli.outputs.nodes import told
from exoid.cli.terminal.say import say

RATES = (125_000, 250_000, 500_000, 1_000_000)  # bit/s


def set_up(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    direction: Annotated[
        Literal["rises", "falls"] | None,
        typer.Option(help="What the encoder's count does while the knee extends."),
    ] = None,
    new_id: Annotated[
        int | None,
        typer.Option("--id", min=0, max=15, help="Of this node on its bus.", metavar="ID"),
    ] = None,
    rate: Annotated[
        int | None,
        typer.Option(help="Of the node's CAN bus from its next start on [bit/s].", metavar="RATE"),
    ] = None,
) -> None:
    """Set a node's direction, its id or its bit rate.

    The direction is that of its encoder, the bit rate that of its CAN bus.

    \b
    Examples:
      exoid node set --channel /dev/ttyACM0 --direction falls
      exoid node set --interface socketcan --channel can0 --node C0FFEE01 --id 2
      exoid node set --interface socketcan --channel can0 --rate 250000
    """
    if rate is not None and rate not in RATES:
        raise ValueError(f"--rate {rate}: it can be {', '.join(map(str, RATES))} bit/s.")
    orders = orders_of(direction, new_id, rate)
    if not orders:
        raise ValueError("nothing to set: give --direction, --id or --rate.")
    with talking_to(node, channel, interface, bitrate) as (dialogue, state):
        for name, values in orders:
            state = dialogue.order(state, name, **values)
    for line in told(state):
        say(line)
    if rate is not None:
        say(f"The new bit rate counts when the node starts again: --bitrate {rate} then.")


def orders_of(direction: str | None, new_id: int | None, rate: int | None) -> list:
    """The commands that were asked for, with their values."""
    from exoid.recordings.commissioning.commands import SET_BIT_RATE, SET_DIRECTION, SET_NODE_ID

    wanted = [
        (direction, SET_DIRECTION, {"Reversed": int(direction == "falls")}),
        (new_id, SET_NODE_ID, {"NodeId": new_id}),
        (rate, SET_BIT_RATE, {"BitRate": rate}),
    ]
    return [(name, values) for asked, name, values in wanted if asked is not None]
