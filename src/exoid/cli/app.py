"""The commands, gathered. Their heavy parts load when they run."""

from importlib.metadata import version as installed_version
from typing import Annotated

import typer

from exoid.cli.commands.compare import compare
from exoid.cli.commands.convert import convert
from exoid.cli.commands.diagnose import diagnose
from exoid.cli.commands.drops import drops
from exoid.cli.commands.example import example
from exoid.cli.commands.fit import fit
from exoid.cli.commands.plan import plan
from exoid.cli.commands.record import record
from exoid.cli.commands.report import report
from exoid.cli.commands.simulate import simulate
from exoid.cli.welcome import WELCOME

app = typer.Typer(
    name="exoid",
    help="Mechanical parameters of the lower leg from exoskeleton recordings.",
    invoke_without_command=True,
    add_completion=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command()(fit)
app.command()(example)
app.command()(drops)
app.command()(diagnose)
app.command()(report)
app.command()(plan)
app.command()(compare)
app.command()(record)
app.command()(simulate)
app.command()(convert)


def show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"exoid {installed_version('exoid')}")
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
