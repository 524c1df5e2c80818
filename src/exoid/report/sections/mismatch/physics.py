"""Which physics was left out: the verdict, its evidence, and what else it may be."""

from collections.abc import Iterator

from markupsafe import Markup

from exoid.mismatch.answer.diagnosis import Parameter
from exoid.mismatch.answer.over_inertia import parameters_shown
from exoid.report.parts.case import Case
from exoid.report.pictures.mismatch.causes import show_causes
from exoid.report.sections.blocks import Block, element
from exoid.report.sections.section import section
from exoid.report.tables.leg import before_and_after
from exoid.report.tables.mismatch.candidates import candidates, legend, suspects
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis.cause import value
from exoid.report.words.diagnosis.leg import beside
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.verdict import verdict
from exoid.report.words.text import in_words

SAID = (
    "Missing",
    "Found",
    "How sure",
    "Changed",
    "Remains",
    "Why",
    "Note",
    "Suspected",
    "The leg",
    "The rig",
    "Sensors",
    "Trust",
)  # others have their place
EFFECT = Markup("<p>{} <cite>{}</cite></p>")


@section("physics", "Which physics was left out")
def physics(case: Case) -> Iterator[Block]:
    """The verdict in sentences, what was found with its numbers, and every candidate."""
    found = case.diagnosis
    if found is None:
        return
    shown = parameters_shown(found, found.parameters)
    yield element("p", verdict(found), "verdict")
    yield {title: line for title, line in sentences(found).items() if title in SAID}
    for effect in found.findings:
        yield element("h3", effect.title)
        yield EFFECT.format(effect.explanation, effect.reference)
    yield parameters(shown if found.verdict == "mismatch" else [])
    if found.after is not None:
        yield before_and_after(found.before, found.after)
        for each in beside(found):
            yield element("p", each, "small")
    if found.suspected:
        yield suspects(found)
    yield show_causes(found)
    yield candidates(found)
    yield element("p", legend(found), "small")
    if found.excluded:
        excluded = ", ".join(map(in_words, found.excluded))
        yield element("p", f"Not tested, because they cannot be differentiated: {excluded}.")


def parameters(each: list[Parameter]) -> Table:
    """Their numbers."""
    columns = {
        "effect": [one.name.partition(".")[0].replace("_", " ") for one in each],
        "parameter": [one.name.rpartition(".")[2].replace("_", " ") for one in each],
        "value": [value(one) for one in each],
    }
    return Table("What was found in numbers; ± is one standard error", columns)
