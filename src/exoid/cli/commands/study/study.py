"""exoid study: the commands for many recordings of many people."""

import typer

from exoid.cli.commands.study.report import report

study = typer.Typer(
    name="study",
    help="""Ask many recordings of many people.

    \b
    Examples:
      exoid study report results -o report.html --by group
    """,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
for name, command in {
    "report": report,
}.items():
    study.command(name)(command)


@study.callback()
def chosen() -> None:
    """Ask many recordings of many people."""
