"""A diagnosis as a person reads it in a terminal."""

from rich.console import Console

from exoid.fitting.result.chief import chief
from exoid.fitting.result.estimates.estimate import RIVALS
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.summary import quantities
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.tables.leg import before_and_after, in_print, quantities_of
from exoid.report.tables.mismatch.candidates import candidates, how_large, legend, suspects
from exoid.report.tables.table import Column, Table, print_table
from exoid.report.words.astray import astray
from exoid.report.words.diagnosis.leg import beside
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.used import used
from exoid.report.words.diagnosis.verdict import headline
from exoid.report.words.text import (
    heading,
    note,
    quantity_words,
    say,
)

IN_ERRORS = "The errors of the leg's numbers hold how far these are apart, each by its odds."
NO_ERRORS = "Eq. 9 alone does not follow the recording: the leg has no numbers with errors here."
MARGIN = 15  # characters, as wide as the longest heading


def in_errors_of(fit: FitResult) -> str:
    """What errors of a diagnosis hold beside the noise."""
    limits = [most for each in fit.ratios.values() if (most := chief(each))]
    doubt = " and for what else it may be, a spring slack at another angle among it"
    return "what is still missing" + (doubt if RIVALS in dict(limits) else "")


def print_diagnosis(found: Diagnosis, console: Console) -> None:
    """The answer, then the candidates with their evidence."""
    if not found.follows:
        heading(console, "No model here follows this recording")
        say(console, astray(found.fit, diagnosed=True))
    heading(console, headline(found))
    said = sentences(found)
    for title, sentence in said.items():
        say(console, f"{title + ':':{MARGIN}s}{sentence}", MARGIN)
    aside = used(found.fit.set_aside, " ".join(said.values()))
    note(console, aside, "What of the recordings was used")
    if found.after is not None:
        print_table(before_and_after(found.before, found.after), console)
        say(console, f"± one standard error, with the part for {in_errors_of(found.after)}.")
        for each in beside(found):
            say(console, each)
    if found.verdict == "cannot_tell" and found.after is None:
        print_by_eq9(found.before, console)
    if found.suspected:
        print_table(suspects(found), console)
        if found.fit.follows:
            say(console, IN_ERRORS)
        if said := how_large(found):
            say(console, said)
    print_table(candidates(found), console)
    say(console, legend(found))
    console.print()


def print_by_eq9(fit: FitResult, console: Console) -> None:
    """The numbers of the leg with errors that hold its suspects, or that it has none."""
    if not fit.follows:
        say(console, NO_ERRORS)
        return
    print_table(by_eq9(fit), console)
    say(console, f"± one standard error, with the part for {in_errors_of(fit)}.")


def by_eq9(fit: FitResult) -> Table:
    """The numbers of the leg where nothing is told by name."""
    known = {name: in_print(one) for name, one in quantities(fit).items() if one.value is not None}
    each = list(known.values())
    columns = {
        "quantity": [quantity_words(name) for name in known],
        "symbol": Column([one.symbol for one in each], symbols=True, head="", spare=3),
        "value": quantities_of(each),
        "set by": [one.set_by or "" for one in each],
    }
    return Table("The leg by Eq. 9 alone", columns, "The leg, by Eq. 9 alone")
