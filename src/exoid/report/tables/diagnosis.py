"""A diagnosis as a person reads it in a terminal."""

from rich.console import Console

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.summary import quantities
from exoid.mismatch.answer.diagnosis import Diagnosis, Tested
from exoid.report.tables.fit import in_print
from exoid.report.words.diagnosis import headline, sentences
from exoid.report.words.text import capital, heading, say, table, width, written

MOST = 8  # candidates that are listed
MARGIN = 15  # characters, as wide as the longest heading


def print_diagnosis(found: Diagnosis, console: Console) -> None:
    """The answer, then the candidates with their evidence."""
    if not found.follows:
        heading(console, "No model here follows this recording")
        say(console, capital(found.fit.notes[0]))
    heading(console, headline(found))
    for title, sentence in sentences(found).items():
        say(console, f"{title + ':':{MARGIN}s}{sentence}", MARGIN)
    print_numbers(found, console)
    heading(console, "Candidates")
    console.print(table(candidates(found)))
    say(
        console,
        "left: mean square of what is left over the noise, 1.00 is the noise itself; evidence: log "
        "odds times two against the baseline, after the price of the parameters.",
    )
    console.print()


def print_numbers(found: Diagnosis, console: Console) -> None:
    """The leg with what was found beside the leg without, or what every suspect makes of it."""
    if found.after is not None:
        heading(console, "The leg, with what was found")
        columns = both(found.before, found.after)
        if width(columns) > console.width:
            del columns["set by"]
        console.print(table(columns))
        say(console, "± one standard error, with the part for what is still missing.")
    if found.suspected:
        heading(console, "What each suspected cause would make of the leg")
        console.print(table(suspects(found)))
        say(console, "No error bar holds this: until the cause is known, it is the model's own.")


def both(before: FitResult, after: FitResult) -> dict[str, list[str]]:
    """The columns of the table: every number of the model, and that of Eq. 9 alone."""
    old = quantities(before)
    rows = [(name, in_print(each), old.get(name)) for name, each in quantities(after).items()]
    return {
        "quantity": [label(name) for name, *_ in rows],
        "with it": [written(each) for _, each, _ in rows],
        "Eq. 9 alone": ["" if one is None else written(in_print(one)) for *_, one in rows],
        "unit": [each.unit for _, each, _ in rows],
        "set by": [each.set_by or "" for _, each, _ in rows],
    }


def label(name: str) -> str:
    """A quantity's name in words."""
    return name.replace("_over_inertia", " / J").replace("_", " ").replace(".", ": ")


def suspects(found: Diagnosis) -> dict[str, list[str]]:
    """The columns of the table: a number, what it is by Eq. 9 alone, and with each cause."""
    first = found.suspected[0].numbers
    columns = {
        "quantity": [label(one.name) for one in first],
        "Eq. 9\nalone": [f"{one.before:.3g}" for one in first],
    }
    for each in found.suspected:
        name = "\n+ ".join(each.terms).replace("_", "\n")
        columns[name] = [f"{one.after:.3g}" for one in each.numbers]
    return {**columns, "unit": [one.unit for one in first]}


def candidates(found: Diagnosis) -> dict[str, list[str]]:
    """The columns of the table: those that ran free, then the rest as they were first seen."""
    rows = [("baseline, Eq. 9", found.baseline.mean_square, "", "")]
    ran = sorted([*found.pairs, *found.singles], key=evidence, reverse=True)[:MOST]
    for one in [*ran, *([found.best] if found.formula is not None else [])]:
        label = " + ".join(one.terms).replace("_", " ")
        mark = "chosen" if one.chosen else ""
        rows.append((label, one.mean_square, f"{one.evidence:.0f}", mark))
    return {
        "cause": [row[0] for row in rows],
        "left": [f"{row[1]:.2f}" for row in rows],
        "evidence": [row[2] for row in rows],
        " ": [row[3] for row in rows],
    }


def evidence(one: Tested) -> float:
    assert one.evidence is not None  # it ran free
    return one.evidence
