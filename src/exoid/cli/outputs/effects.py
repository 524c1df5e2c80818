"""The effects that a model may have beside Eq. 9: all of them in lines, one in full."""

from collections.abc import Sequence
from inspect import cleandoc

from rich.console import Console

from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import SensorTerm, Term, name_of
from exoid.report.tables.table import Table, print_table
from exoid.report.words.text import aligned, capital, heading, say, shown_unit

MORE = (
    "exoid effects NAME says more of one; exoid fit --with NAME has it in the model, but for those "
    "that only a diagnosis tries: where one of them explains as much as a cause with a name, that "
    "is not claimed."
)


def print_effects(
    terms: Sequence[type[Term]], simple: Sequence[type[Term]], console: Console
) -> None:
    """A line of each: its name, what it is, and its values with their units."""
    sensors = [term for term in terms if issubclass(term, SensorTerm)]
    torques = [term for term in terms if term not in sensors]
    for title, each in (
        ("Torques on the leg", torques),
        ("Errors of sensors", sensors),
        ("Simple torques that only a diagnosis tries", simple),
    ):
        columns = {
            "name": [name_of(term) for term in each],
            "what it is": [term.title for term in each],
            "values": [values(term) for term in each],
        }
        print_table(Table("", columns, title), console)
    say(console, MORE)


def explain_effect(term: type[Term], console: Console) -> None:
    """One of them: its equation, values with their ranges, what isolates it, and its source."""
    heading(console, f"{name_of(term)}: {term.title}")
    say(console, term.explanation)
    console.print()
    for paragraph in cleandoc(term.__doc__ or "").split("\n\n"):
        say(console, " ".join(paragraph.split()))
    console.print()
    aligned(console, {name: ranged(each) for name, each in declarations(term)})
    say(console, f"Isolated by: {term.isolate}.")
    say(console, f"Source: {term.reference}.")


def values(term: type[Term]) -> str:
    """As `--with NAME=...` takes them: level [N m], at [rad]."""
    units = {name: shown_unit(each.unit) for name, each in declarations(term)}
    return ", ".join(f"{name} [{unit}]" if unit else name for name, unit in units.items())


def ranged(each: Declaration) -> str:
    """What it is, and from where to where it may be."""
    ends = f"{each.lower:g} to {each.upper:g} {shown_unit(each.unit)}".rstrip()
    return f"{each.symbol}: {capital(each.title)}, {ends}"
