"""exoid study report: what a study found, on one page."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from exoid.cli.outputs.destination import PAGES, Force, Json, check_outputs
from exoid.cli.outputs.origin import origin_of
from exoid.cli.outputs.results import show
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.waiting import patiently

Column = Annotated[
    str | None, typer.Option(help="Column of participants: groups, or a dose.", metavar="COLUMN")
]
Session = Annotated[str | None, typer.Option(help="A session, with the other.", metavar="SESSION")]
Quantities = Annotated[
    list[str] | None,
    typer.Option(
        "--quantity", help="One to ask about; the first leads. [default: all]", metavar="NAME"
    ),
]
Primary = Annotated[
    list[str] | None,
    typer.Option(help="One that was the question from the start. It leads.", metavar="NAME"),
]
Adjust = Annotated[
    list[str] | None,
    typer.Option(help="Column to hold equal between groups: age, site.", metavar="COLUMN"),
]


def report(
    results: Annotated[Path, typer.Argument(help="Folder that 'exoid study run' wrote.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Page to write (.html).", metavar="FILE")
    ] = None,
    by: Column = None,
    before: Session = None,
    after: Session = None,
    primary: Primary = None,
    quantity: Quantities = None,
    adjust: Adjust = None,
    task: Annotated[str | None, typer.Option(help="Only this task.", metavar="TASK")] = None,
    correction: Annotated[
        Literal["holm", "benjamini-hochberg"], typer.Option(help="Of p, over quantities.")
    ] = "holm",
    json: Json = None,
    force: Force = False,
) -> None:
    """Say what a study found, and write one page about it.

    Test and retest, left and right, before and after, groups, and which physics was missing. p is
    corrected over all quantities that are asked, or over those of --primary among themselves and
    over the others among themselves.

    \b
    Examples:
      exoid study report results                               in the terminal
      exoid study report results -o report.html --by group     groups compared, on a page
      exoid study report results --before day1 --after day2 -o report.html
      exoid study report results --by dose --adjust age --adjust site --primary relaxation_index
    """
    tables = [results / f"{name}.parquet" for name in ("recordings", "quantities")]
    check_outputs((output, PAGES), (json, ()), force=force, inputs=tables)
    from exoid.files.extras import require

    for package in ("pandas", "pyarrow"):
        require(package, "studies are asked", "study")
    answers = patiently(
        lambda: answered(
            results,
            quantities=tuple(quantity or ()),
            primary=tuple(primary or ()),
            adjust=tuple(adjust or ()),
            correction=correction,
            by=by or "",
            before=before or "",
            after=after or "",
            task=task or "",
        ),
        "asking the study",
    )
    from exoid.studies.page.document import study_document
    from exoid.studies.page.terminal import print_study

    show(lambda console: print_study(answers, console))
    settings = {"by": by, "before": before, "after": after, "primary": primary}
    more = {"quantity": quantity, "task": task, "adjust": adjust, "correction": correction}
    origin = origin_of(tables, {**settings, **more})
    written = Outputs()
    written.put(output, lambda path: put_page(answers, origin, results, path), "writing the page")
    written.put_document(
        json, lambda: {"version": origin.versions["exoid"], **study_document(answers)}
    )
    written.end()


def answered(results: Path, **asked):
    from exoid.studies.statistics.ask import ask
    from exoid.studies.statistics.asked import Asked
    from exoid.studies.statistics.tables.study import open_study

    return ask(open_study(results), Asked(**asked))


def put_page(answers, origin, results: Path, path: Path) -> None:
    from exoid.studies.page.page import write_page
    from exoid.studies.page.parts.part import Told

    write_page(Told(answers, origin, results.resolve().name), path)
