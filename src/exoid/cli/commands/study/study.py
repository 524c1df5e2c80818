"""exoid study: the commands of a study of many people."""

import typer

from exoid.cli.commands.study.check import check
from exoid.cli.commands.study.init import init
from exoid.cli.commands.study.report import report
from exoid.cli.commands.study.run import run

study = typer.Typer(
    name="study",
    help="""Many people: look at a data set, run it, report it.

    A data set is a folder: Motion-BIDS, or recordings whose names say whose they are, with a table
    of participants.

    \b
    Examples:
      exoid study init study
      exoid study check study
      exoid study run study -o results
      exoid study report results -o report.html --by group
    """,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
study.command("init")(init)
study.command("check")(check)
study.command("run")(run)
study.command("report")(report)
