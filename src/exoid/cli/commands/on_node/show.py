"""exoid node show: how one node was commissioned, and how it is."""

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
    check_name(node)
    check_outputs((json, ()), force=force)
    with talking(channel, interface, bitrate) as dialogue:
        state = chosen(dialogue.find(), node)
    for line in told(state):
        say(line)
    files = Outputs()
    files.put_document(json, lambda: document([state]))
    files.end()
