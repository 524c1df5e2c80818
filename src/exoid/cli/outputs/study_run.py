"""What a run of a study did."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from exoid.cli.terminal.progress import pace
from exoid.cli.terminal.say import say
from exoid.files.counted import counted
from exoid.files.visible import visible

SHOWN = 12  # reasons


def check_results(folder: Path) -> None:
    """Refuse what can be no folder of results, before anything is computed."""
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"{folder}: this is a file. Name a folder for the tables.")
    if not folder.parent.is_dir():
        raise ValueError(f"{folder}: the folder {folder.parent} does not exist. Make it first.")


def doubted(folder: str, errors: int) -> Iterator[str]:
    """That names, sidecars or contents have errors, how many, and which command tells them."""
    if errors:
        yield (
            f"{counted(errors, 'error')} in this data set: results of them are wrong or missing. "
            f"See 'exoid study check {folder}'."
        )


@contextmanager
def kept_when_interrupted() -> Iterator[None]:
    """Say, where Ctrl-C ends a run, what becomes of what it has computed."""
    try:
        yield
    except KeyboardInterrupt:
        say("What was computed is kept: the same command goes on from there.", err=True)
        raise


def exchanged_sides(results: Path) -> list[str]:
    """Whose left and right look exchanged, at which visit."""
    from exoid.studies.page.parts.opening import turned
    from exoid.studies.statistics.tables.study import open_study
    from exoid.studies.statistics.visits.exchanged import exchanged

    return [turned(each) for each in exchanged(open_study(results))]


def print_outcome(made: Any, results: Path, console: Any) -> None:
    """Counts, time, and why recordings failed."""
    from exoid.report.tables.table import Table, print_table

    told = f"{made.seconds:.1f} s"
    told += f", {pace(made.computed / made.seconds)}" if made.computed else ""
    counts = {
        "all": made.recordings,
        "measured": made.ok,
        "failed": made.failed,
        "of these, measured in part": made.partly,
        "the same as another": made.duplicates,
        "computed now": made.computed,
        "time": told,
    }
    columns = {"recordings": list(counts), "": [str(each) for each in counts.values()]}
    print_table(Table("", columns, "Study"), console)
    for reason, count in list(made.reasons.items())[:SHOWN]:
        console.print(visible(f"{count} failed, {reason}"), markup=False, highlight=False)
    if len(made.reasons) > SHOWN:
        console.print(f"and {len(made.reasons) - SHOWN} more reasons: see recordings.parquet")
    for name in ("recordings", "quantities"):
        console.print(visible(f"wrote {results / f'{name}.parquet'}"), markup=False, soft_wrap=True)
