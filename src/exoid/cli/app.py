"""The commands, gathered. Their heavy parts load when they run."""

from importlib.metadata import version as installed_version
from typing import Annotated

import typer

from exoid.cli.diagnose import diagnose
from exoid.cli.fit import fit
from exoid.cli.plan import plan
from exoid.cli.simulate import simulate

app = typer.Typer(
    name="exoid",
    help="Mechanical parameters of the lower leg from exoskeleton recordings.",
    no_args_is_help=True,
    add_completion=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command()(fit)
app.command()(diagnose)
app.command()(plan)
app.command()(simulate)


def show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"exoid {installed_version('exoid')}")
        raise typer.Exit


@app.callback()
def exoid(
    version: Annotated[
        bool, typer.Option("--version", callback=show_version, is_eager=True, help="Show it.")
    ] = False,
) -> None:
    """Mechanical parameters of the lower leg from exoskeleton recordings."""
