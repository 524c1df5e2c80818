"""A study as a terminal shows it."""

from rich.console import Console

from exoid.report.tables.table import print_table
from exoid.report.words.text import note, say
from exoid.studies.page.parts.copies import copies
from exoid.studies.page.parts.correction import correction
from exoid.studies.page.parts.opening import opening
from exoid.studies.page.parts.tables import (
    agreements,
    causes,
    comparisons,
    failures,
    reliabilities,
    values,
)
from exoid.studies.page.parts.words import MAIN, column_words, reasons, silent, told_of
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import ALL
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import Untold


def print_study(answers: Answers, console: Console) -> None:
    """The clearest answers, then every table that holds something, then why others do not."""
    for each in opening(answers):
        say(console, each)
    asked = answers.asked
    found = [values(answers.each), reliabilities(answers)]
    if asked.by:
        found.append(comparisons(answers, "groups", f"By {column_words(asked.by)}"))
    if asked.before:
        when = f"{asked.after} - {asked.before}"
        found.append(agreements(answers, "change", when))
        found.append(comparisons(answers, "change_by_group", f"{when}, by group"))
    found.append(agreements(answers, "sides", "right - left"))
    if not isinstance(answers.physics, Untold):
        groups = dict.fromkeys(each.group for each in answers.physics)
        found.append(causes(answers.physics, list(groups) or [ALL]))
    found.append(failures(answers.study.recordings))
    for each in found:
        if each.rows:
            print_table(each, console)
    note(console, notes(answers))


def notes(answers: Answers) -> list[str]:
    """How p is corrected, what was left out, and what is not told."""
    said = [correction(answers), *copies(answers.study.recordings)]
    said += [f"{each.quantity}: {one}" for each in answers.each for one in each.values.notes]
    found = (each.reliability for each in answers.each)
    said += told_of([each for each in found if isinstance(each, Reliability)])
    compared = (getattr(each, kind) for kind in MAIN for each in answers.each)
    said += dict.fromkeys(x for one in compared if isinstance(one, Comparison) for x in one.notes)
    said += silent(answers)
    for kind in ("reliability", "groups", "change", "change_by_group", "sides"):
        said += reasons(answers, kind)
    return [*said, answers.physics.why] if isinstance(answers.physics, Untold) else said
