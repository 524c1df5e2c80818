"""A diagnosis as a person reads it in a terminal."""

from rich.console import Console

from exoid.fitting.result.chief import chief
from exoid.fitting.result.estimates.estimate import RIVALS
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.summary import quantities
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import guessed, parameters_shown
from exoid.report.tables.leg import before_and_after, in_print, quantities_of
from exoid.report.tables.table import Column, Table, print_table
from exoid.report.words.astray import astray
from exoid.report.words.diagnosis.asserted import evidence, is_chosen, ran_free
from exoid.report.words.diagnosis.cause import for_inertia, parameter, remark
from exoid.report.words.diagnosis.leg import beside, tabled
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.used import used
from exoid.report.words.diagnosis.verdict import headline
from exoid.report.words.text import (
    causes_in_words,
    heading,
    note,
    quantity_words,
    say,
    shown_unit,
)

IN_ERRORS = "The errors of the leg's numbers hold how far these are apart, each by its odds."
NO_ERRORS = "Eq. 9 alone does not follow the recording: the leg has no numbers with errors here."
SMALL = 0.01  # times the noise, below which two decimals would be none
LEGEND = (
    "left: mean square of what is left over the noise, 1.00 is the noise itself. evidence: log "
    "odds times two against the baseline, after the price of the parameters."
)
CHOSEN = "chosen: more causes only where they leave less than a third as much."
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


def suspects(found: Diagnosis) -> Table:
    """A number by Eq. 9 alone, and what each suspected cause would make of it."""
    numbers = [tabled(found, each.numbers) for each in found.suspected]
    first = numbers[0]
    columns: dict[str, Column | list[str]] = {
        "quantity": [quantity_words(one.name) for one in first],
        "Eq. 9 alone": Column([f"{one.before:.3g}" for one in first], head="Eq. 9\nalone"),
    }
    for each, own in zip(found.suspected, numbers, strict=True):
        name = causes_in_words(each.terms)
        cells = [f"{one.after:.3g}" for one in own]
        columns[name] = Column(cells, head=name.replace(" ", "\n"))
    columns["unit"] = [shown_unit(one.unit) for one in first]
    title = "What each cause that it may be would make of the leg"
    return Table(title, columns, title)


def how_large(found: Diagnosis) -> str:
    """The sizes of the suspects, by noise and J but for what a fit has; none in older files."""
    each = [
        f"{causes_in_words(one.terms)}: {', '.join(map(parameter, parameters_shown(found, own)))}"
        f"{''.join(map(remark, one.terms))}"
        for one in found.suspected
        if (own := one.parameters)
    ]
    torques = any(one.unit.startswith("N m") for each in found.suspected for one in each.parameters)
    known = torques and not guessed(found.fit)
    scale = f" ({for_inertia(found.inertia, found.fit)})" if known else ""
    return f"As large as: {'; '.join(each)}{scale}." if each else ""


def candidates(found: Diagnosis) -> Table:
    """Those that ran free with their evidence."""
    ran = ran_free(found)
    chosen = ["", *("chosen" if is_chosen(one, found) else "" for one in ran)]
    columns = {
        "cause": ["baseline, Eq. 9", *(causes_in_words(one.terms) for one in ran)],
        "left": [in_times(one.mean_square) for one in (found.baseline, *ran)],
        "evidence": ["", *(f"{evidence(one):.0f}" for one in ran)],
        "verdict": Column(chosen, head=" "),
    }
    return Table("The candidates that ran free", columns, "Candidates")


def in_times(left: float) -> str:
    """With two decimals, and never as nothing."""
    return f"{left:.2f}" if left >= SMALL else f"{left:.1g}"


def legend(found: Diagnosis) -> str:
    """What the columns of the candidates say."""
    return f"{LEGEND} {CHOSEN}" if is_chosen(found.best, found) else LEGEND
