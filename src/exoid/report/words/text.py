"""Numbers with their errors, tables and sentences, as every report prints them."""

from collections.abc import Iterable
from math import degrees, floor, log10

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from exoid.files.visible import visible

NOT_DETERMINED = "not determined"
MOST_DECIMALS = 6  # beyond them a power of ten is read more easily
MOST_DIGITS = 7  # of a value, however small its error
DIMENSIONLESS = ("-", "1")  # units that are not written


def shown_unit(unit: str) -> str:
    """As a table has it: blank where there is none."""
    return "" if unit in DIMENSIONLESS else unit


def with_error(value: float, error: float) -> str:
    """The error with two digits, the value to the same decimal."""
    if not error > 0:
        return f"{value:z.{MOST_DIGITS}g}"
    last = exponent(error) - 1  # the power of ten of the last digit that is written
    first = max(exponent(value), exponent(error))
    if first - last >= MOST_DIGITS:
        return f"{value:z.{MOST_DIGITS}g} ± {error:.1e}"
    if -MOST_DECIMALS <= last <= 0:
        return f"{value:z.{-last}f} ± {error:.{-last}f}"
    decimals = first - last
    return f"({value / 10**first:z.{decimals}f} ± {error / 10**first:.{decimals}f})e{first:+d}"


def with_digits(value: float, digits: int) -> str:
    """So many digits, zeros at the end too, never as a power of ten unless it is tiny."""
    decimals = digits - 1 - exponent(value)
    if decimals > MOST_DECIMALS:
        return f"{value:.{digits - 1}e}"
    return f"{value:z.{max(decimals, 0)}f}"


def exponent(value: float) -> int:
    """The power of ten of the first digit when two are written."""
    return int(f"{value:.1e}".partition("e")[2]) if value else 0


def capital(words: str) -> str:
    """With a capital at its begin."""
    return words[:1].upper() + words[1:]


def in_words(name: str) -> str:
    """The name of a parameter as a sentence or an axis has it."""
    return name.replace("_", " ").replace(".", ": ")


def causes_in_words(terms: Iterable[str]) -> str:
    """Causes that act together, as a sentence has them."""
    return " + ".join(map(in_words, terms))


def quantity_words(name: str) -> str:
    """A quantity's name in words."""
    return in_words(name.replace("_over_inertia", " / J"))


def in_degrees(angle: float) -> str:
    """rad as degrees with three digits, never as a power of ten."""
    value = degrees(angle)
    decimals = 3 if value == 0 else min(max(2 - floor(log10(abs(value))), 0), 9)
    return f"{value:.{decimals}f}"


def shortened(name: str, widest: int) -> str:
    """A long name without its middle: the end tells segments apart."""
    if len(name) <= widest:
        return name
    kept = widest - 1
    return f"{name[: kept // 3]}…{name[len(name) - kept + kept // 3 :]}"


def heading(console: Console, title: str) -> None:
    console.print()
    console.print(Text(visible(title), style="bold"))


def say(console: Console, sentence: str, hanging: int = 0) -> None:
    """A sentence, broken between words; a hanging indent for lists."""
    lines = Text(visible(sentence, "\n")).wrap(console, max(console.width - hanging, 20))
    for number, line in enumerate(lines):
        line.rstrip()
        console.print(Padding.indent(line, hanging) if number and hanging else line)


def by_reason(reasons: Iterable[tuple[str, str | None]]) -> dict[str, list[str]]:
    """The names that share a reason, together; none of one that has no reason."""
    found: dict[str, list[str]] = {}
    for name, reason in reasons:
        if reason:
            found.setdefault(reason, []).append(name)
    return found


def note(console: Console, sentences: Iterable[str], title: str = "Notes") -> None:
    """A list under its title; nothing where it is empty."""
    said = list(sentences)
    if said:
        heading(console, title)
    for sentence in said:
        say(console, f"- {sentence}", hanging=2)


def aligned(console: Console, lines: dict[str, str]) -> None:
    """Names and what they are, in two columns."""
    grid = Table.grid(padding=(0, 2))
    grid.add_column(no_wrap=True)
    grid.add_column()
    for name, what in lines.items():
        grid.add_row(Text(visible(name)), Text(visible(what, "\n")))
    console.print(grid)
