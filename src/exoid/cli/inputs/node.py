"""Which bus, and which of its nodes."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from exoid.recordings.commissioning.dialogue import Dialogue
    from exoid.recordings.commissioning.node_state import NodeState

Channel = Annotated[str, typer.Option(help="Such as /dev/ttyACM0, can0, COM3.")]
Interface = Annotated[str, typer.Option(help="Of python-can: slcan, socketcan, pcan, kvaser, ...")]
Bitrate = Annotated[int, typer.Option(min=1, help="Of the bus [bit/s].")]
OneOf = Annotated[
    int | None, typer.Option(min=0, max=15, help="This one of several nodes.", metavar="ID")
]
Duration = Annotated[
    float | None,
    typer.Option(min=0.1, help="Stop so long after the first frame [s].", metavar="S"),
]
Marking = Annotated[
    bool, typer.Option("--segment", help="Mark by keys: d drop, c cycle, space end.")
]
Who = Annotated[
    str | None,
    typer.Option("--node", help="Id or serial of the one that is meant.", metavar="ID|SERIAL"),
]
INTERFACE, BITRATE = "slcan", 500_000
SERIAL_LENGTH = 8  # hexadecimal digits


@contextmanager
def talking(channel: str, interface: str, bitrate: int) -> Iterator["Dialogue"]:
    """The nodes of a bus, to be asked."""
    from exoid.recordings.commissioning.dialogue import Dialogue
    from exoid.recordings.live.bus import LiveBus
    from exoid.recordings.live.channel.address import BusAddress

    bus = LiveBus(BusAddress(interface, channel, bitrate))
    try:
        yield Dialogue(bus)
    finally:
        bus.close()


@contextmanager
def talking_to(
    who: str | None, channel: str, interface: str, bitrate: int
) -> Iterator[tuple["Dialogue", "NodeState"]]:
    """The node of that id or serial, or the only one, to be asked and ordered.

    **Raises** `ValueError` as `check_name` and `chosen` do.
    """
    check_name(who)
    with talking(channel, interface, bitrate) as dialogue:
        yield dialogue, chosen(dialogue.find(), who)


def chosen(found: list["NodeState"], who: str | None) -> "NodeState":
    """The node that is meant: the only one, or the one of that id or serial.

    **Raises** `ValueError` where that is none, or not one.
    """
    meant = [each for each in found if who is None or is_named(each, who)]
    if len(meant) == 1:
        return meant[0]
    listed = ", ".join(f"{each.node} ({each.serial:08X})" for each in meant or found)
    if not meant:
        raise ValueError(
            f"--node {who}: nobody answers to that. The ids (serials) that answer: {listed}."
        )
    by = "--node SERIAL" if len({each.node for each in meant}) < len(meant) else "--node ID"
    raise ValueError(f"{len(meant)} nodes answer: {listed}. Say which one is meant: {by}.")


def is_named(state: "NodeState", who: str) -> bool:
    """Whether this is its id, in decimal, or its serial, in eight hexadecimal digits."""
    if len(who) == SERIAL_LENGTH:
        return who.upper() == f"{state.serial:08X}"
    return who == str(state.node)


def check_name(who: str | None) -> None:
    """**Raises** `ValueError` for what is neither an id nor a serial."""
    digits = "0123456789abcdefABCDEF" if who and len(who) == SERIAL_LENGTH else "0123456789"
    if who is not None and (not who or len(who) > SERIAL_LENGTH or who.strip(digits)):
        raise ValueError(
            f"--node {who}: give an id such as 2, or a serial such as C0FFEE01, as exoid node find "
            "shows them."
        )
