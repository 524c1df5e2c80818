"""exoid node show: how one node was commissioned, and how it is."""

from exoid.cli.inputs.node import (
    BITRATE,
    INTERFACE,
    Bitrate,
    Channel,
    Interface,
    Who,
    talking_to,
)
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.nodes import document, told
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say


def show(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    json: Json = None,
    force: Force = False,
) -> None:
    """Show all that a node tells of itself.

    \b
    Examples:
      exoid node show --channel /dev/ttyACM0
      exoid node show --interface socketcan --channel can0 --node 2
    """
    check_outputs((json, ()), force=force)
    with talking_to(node, channel, interface, bitrate) as (_, state):
        lines = told(state)
    for line in lines:
        say(line)
    files = Outputs()
    files.put_document(json, lambda: document([state]))
    files.end()
