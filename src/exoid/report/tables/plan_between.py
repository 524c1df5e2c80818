"""A plan that tells rival causes apart, as a person reads it, and as JSON."""

from typing import Any

from rich.console import Console

from exoid.planning.planned import Contrast
from exoid.recordings.declared.subject import Subject
from exoid.report.document.plain_json import plain, shown
from exoid.report.tables.plan import (
    ROUNDING,
    SHOWN,
    as_good,
    in_one_row,
    print_steps,
    segment_document,
)
from exoid.report.tables.table import Table, print_table
from exoid.report.words.person import identity
from exoid.report.words.text import heading, note, say, with_digits

NONE = 0.05  # log odds that count as none: a twentieth more likely
NAMES = {
    "rivals": "between",
    "at_hand": "log_odds_at_hand",
    "log_odds": "expected_log_odds",
    "if_right": "expected_log_odds_if_right",
}


def print_contrast(found: Contrast, console: Console) -> None:
    """What the recordings at hand say, what to record, and what to expect of it."""
    heading(console, f"What to record next to tell {' from '.join(found.rivals)}")
    columns = {
        "model": found.rivals,
        "log odds at hand": [f"{each:.1f}" for each in found.at_hand],
        "expected if right": [f"{each:.1f}" for each in found.if_right],
    }
    print_table(Table("", columns), console)
    if found.proposed:
        say(
            console,
            f"Expected with what follows: log odds of {found.log_odds:.1f} against whichever is "
            f"wrong; they reach 20 to 1 with a probability of {found.probability:.0%}.",
        )
        print_steps(found.proposed, console)
    print_tellings(found, console)
    note(console, found.sentences)


def print_tellings(found: Contrast, console: Console) -> None:
    """The single segments, best first, and what each would tell; what is as good in one row."""
    odds = [(each, each.log_odds if each.log_odds > NONE else 0.0) for each in found.options]
    rows = as_good((each.candidate, with_digits(one, ROUNDING)) for each, one in odds)
    likely = {each.candidate: f"{each.probability:.0%}" for each in found.options}
    shown = list(rows.items())[:SHOWN]
    heading(console, "One segment more, and what it would tell")
    columns = {
        "release": [in_one_row(some, found.proposed) for _, some in shown],
        "log odds": [written for written, _ in shown],
        "20 to 1": [likely[some[0]] for _, some in shown],
    }
    print_table(Table("", columns), console)


def contrast_document(found: Contrast, subject: Subject) -> dict[str, Any]:
    """The plan in SI units and radians."""
    return plain(
        {
            "subject": identity(subject),
            **shown(found, **NAMES),
            "proposed": [segment_document(each) for each in found.proposed],
            "options": [
                {**segment_document(each.candidate), **shown(each, ["candidate"], **NAMES)}
                for each in found.options
            ],
        }
    )
