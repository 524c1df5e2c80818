"""Which physics was left out: the verdict, its evidence, and what else it may be."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.mismatch.answer.diagnosis import Finding, Parameter
from exoid.report.parts.case import Case
from exoid.report.pictures.mismatch.causes import show_causes
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.diagnosis import candidates, suspects
from exoid.report.tables.leg import before_and_after
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis import sentences, value, verdict

SAID = (
    "Missing",
    "New",
    "Unexplained",
    "Or",
    "Why",
    "Suspected",
    "Sensors",
    "Trust",
)  # others have their place


@dataclass(frozen=True, eq=False)
class Physics(Section):
    """The verdict in sentences, what was found with its numbers, and every candidate."""

    name: ClassVar[str] = "physics"
    title: ClassVar[str] = "Which physics was left out"

    headline: str
    sentences: dict[str, str]
    effects: tuple[Finding, ...]
    parameters: Table
    numbers: Table  # of the leg, where something was found
    suspected: Table
    figure: Picture
    candidates: Table
    excluded: str

    @classmethod
    def of(cls, case: Case) -> "Physics | None":
        found = case.diagnosis
        if found is None:
            return None
        lines, after = sentences(found), found.after
        return cls(
            headline=verdict(found),
            sentences={title: lines[title] for title in SAID if title in lines},
            effects=tuple(found.findings),
            parameters=parameters(found.parameters if found.verdict == "mismatch" else []),
            numbers=Table("", {}) if after is None else before_and_after(found.before, after),
            suspected=suspects(found) if found.suspected else Table("", {}),
            figure=show_causes(found),
            candidates=candidates(found),
            excluded=", ".join(found.excluded).replace("_", " "),
        )


def parameters(each: list[Parameter]) -> Table:
    """Their numbers."""
    columns = {
        "effect": [one.name.partition(".")[0].replace("_", " ") for one in each],
        "parameter": [one.name.rpartition(".")[2].replace("_", " ") for one in each],
        "value": [value(one) for one in each],
    }
    return Table("What was found in numbers; ± is one standard error", columns)
