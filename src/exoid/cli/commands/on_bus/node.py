"""exoid node: the commands to the node on the leg."""

import typer

from exoid.cli.commands.on_bus.on_node.find import find
from exoid.cli.commands.on_bus.on_node.identify import identify
from exoid.cli.commands.on_bus.on_node.load import load
from exoid.cli.commands.on_bus.on_node.set import set_up
from exoid.cli.commands.on_bus.on_node.show import show
from exoid.cli.commands.on_bus.on_node.torque import torque
from exoid.cli.commands.on_bus.on_node.zero import zero

node = typer.Typer(
    name="node",
    help="""Find the node on the leg, and set it up.

    Its zero, direction, id and bit rate, and the leg by which it commands a torque.

    The node keeps what it is told over a loss of power. Nothing is to be compiled.

    \b
    Examples:
      exoid node find --channel /dev/ttyACM0
      exoid node zero --channel /dev/ttyACM0 --angle -90
      exoid node set --channel can0 --interface socketcan --id 2
    """,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
for name, command in {
    "find": find,
    "show": show,
    "zero": zero,
    "set": set_up,
    "identify": identify,
    "load": load,
    "torque": torque,
}.items():
    node.command(name)(command)
