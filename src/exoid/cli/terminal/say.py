"""What a command says in lines of its own: they may quote a file, and are shown, never obeyed."""

import sys

import typer

from exoid.cli.terminal.options import as_options
from exoid.files.visible import visible


def say(*lines: object, err: bool = False) -> None:
    """Each on a line of its own, on stdout or stderr."""
    for line in lines:
        typer.echo(visible(as_options(str(line))), err=err)


def ring() -> None:
    """The terminal's bell, whatever goes to a file."""
    if sys.stderr.isatty():
        typer.echo("\a", nl=False, err=True)
