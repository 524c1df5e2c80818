"""exoid node find: which nodes are on a bus."""

from exoid.cli.inputs.node import BITRATE, INTERFACE, Bitrate, Channel, Interface, talking
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.nodes import document, table
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say


def find(
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    json: Json = None,
    force: Force = False,
) -> None:
    """Show which nodes answer, and how they are.

    Their versions, serials, settings, supplies and errors.

    \b
    Examples:
      exoid node find --channel /dev/ttyACM0
      exoid node find --interface socketcan --channel can0 --json nodes.json
    """
    check_outputs((json, ()), force=force)
    with talking(channel, interface, bitrate) as dialogue:
        nodes = dialogue.find()
    for line in table(nodes):
        say(line)
    ids = [each.node for each in nodes]
    for each in sorted({each for each in ids if ids.count(each) > 1}):
        say(
            f"exoid: {ids.count(each)} nodes have the id {each}, so that nobody can tell their "
            "samples apart. Give one another id: exoid node set --node SERIAL --id ID.",
            err=True,
        )
    files = Outputs()
    files.put_document(json, lambda: document(nodes))
    files.end()
