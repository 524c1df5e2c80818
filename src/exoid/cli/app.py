"""The commands by name. Each is loaded when it is called."""

from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperCommand
from typer.main import get_command

from exoid.cli.welcome import WELCOME

# As the command itself begins, each as short as `--help` shows it whole, and without loading any.
COMMANDS = {
    "fit": "Find a leg's mass, inertia, damping, stiffness and torque.",
    "example": "Copy the recording that comes with exoid, and its sidecar.",
    "drops": "Read the pendulum-test measures off every passive drop.",
    "diagnose": "Say which physics the model lacks, where it shows, and prove it.",
    "effects": "List the effects that --with and --between take.",
    "report": "Fit and diagnose a leg, and write one page about it.",
    "plan": "Say what to record next, and how much it would tell.",
    "compare": "Show two saved results side by side.",
    "export": "Hand a fitted leg on to MuJoCo, URDF, OpenSim, C or Python.",
    "record": "Record the node's frames until Ctrl-C.",
    "live": "Estimate a leg while it moves, and what to do next.",
    "node": "Find the node on the leg, and set it up.",
    "simulate": "Simulate drops and cycles of a leg, as a recording.",
    "study": "Many people: look at a data set, run it, report it.",
    "convert": "Write a recording as exoid's table, with its sidecar.",
}
ROOMS = {**dict.fromkeys(("record", "live", "node"), "on_bus"), "study": "study"}
PLAIN: dict[str, Any] = {"pretty_exceptions_enable": False, "rich_markup_mode": None}

app = typer.Typer(
    name="exoid",
    help="Mechanical parameters of the lower leg from exoskeleton recordings.",
    invoke_without_command=True,
    add_completion=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    **PLAIN,
)


def load(name: str):
    """The command of that name: in `commands`, a function, or a group, and its file bear it."""
    room = f"{ROOMS[name]}." if name in ROOMS else ""
    found = getattr(import_module(f"exoid.cli.commands.{room}{name}"), name)
    if isinstance(found, typer.Typer):
        return get_command(found)
    alone = typer.Typer(add_completion=False, **PLAIN)
    alone.command(name)(found)
    return get_command(alone)


class Deferred(TyperCommand):
    """What `exoid --help` says of a command. Called, completed or asked for help, it is loaded."""

    def make_context(self, info_name, args, parent=None, **extra):
        return load(self.name or "").make_context(info_name, args, parent, **extra)


for each, line in COMMANDS.items():
    app.command(each, cls=Deferred, help=line)(lambda: None)


def show_version(wanted: bool) -> None:
    from importlib.metadata import version

    if wanted:
        typer.echo(f"exoid {version('exoid')}")
        raise typer.Exit


@app.callback()
def exoid(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=show_version, is_eager=True, help="Show it.")
    ] = False,
) -> None:
    """Mechanical parameters of the lower leg from exoskeleton recordings."""
    if context.invoked_subcommand is None:
        typer.echo(WELCOME)
