"""`{effects}`: every effect of the library, read off its class."""

from inspect import cleandoc
from math import degrees

from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from exoid.physics.library import library
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import SensorTerm, Term, name_of

GROUPS = {
    "Leg and exoskeleton": lambda term: not term.voluntary and not issubclass(term, SensorTerm),
    "The muscle's torque in a voluntary cycle": lambda term: term.voluntary,
    "Sensors": lambda term: issubclass(term, SensorTerm),
}


class Effects(SphinxDirective):
    """An overview and a section for each effect, by group."""

    def run(self):
        parts = []
        for title, belongs in GROUPS.items():
            terms = [term for term in library() if belongs(term)]
            parts += [f"## {title}", *map(section, terms)]
        return self.parse_text_to_nodes("\n\n".join(parts), allow_section_headings=True)


def section(term: type[Term]) -> str:
    """Title, equation, explanation, parameters, what isolates it, and the source."""
    return "\n\n".join(
        [
            f"### {capital(term.title)}",
            f"`{name_of(term)}`. {term.explanation}",
            f"```text\n{cleandoc(term.__doc__ or '')}\n```",
            "\n".join(row(*each) for each in declarations(term)),
            f"Isolated by\n: {term.isolate}",
            f"Source\n: {term.reference}",
        ]
    )


def row(name: str, declared: Declaration) -> str:
    """One parameter in a line: name, symbol, what it is, unit and range, angles also in degrees."""
    unit = "" if declared.unit == "1" else f" {declared.unit}"
    ends = f"{declared.lower:g} to {declared.upper:g}{unit}"
    if declared.unit == "rad":
        ends += f" ({degrees(declared.lower):.3g} to {degrees(declared.upper):.3g} deg)"
    return f"- `{name}`, `{declared.symbol}`: {declared.title}, {ends}"


def capital(words: str) -> str:
    return words[0].upper() + words[1:]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("effects", Effects)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
