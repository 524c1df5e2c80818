"""exoid study: the commands of a study of many people."""

import typer

from exoid.cli.commands.study.report import report

study = typer.Typer(
    name="study",
    help="""Many people: look at a data set, run it, report it.

    \b
    Examples:
      exoid study report results -o report.html --by group
    """,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
study.command("report")(report)


@study.callback()
def chosen() -> None:
    """A group of commands, however few it has."""
