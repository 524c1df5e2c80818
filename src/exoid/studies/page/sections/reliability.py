"""Test and retest, in numbers and in plain words."""

from collections.abc import Iterator

from exoid.report.sections.blocks import Block, Group, element
from exoid.studies.page.parts.part import COMPARED, Told, part
from exoid.studies.page.parts.pictured import pictured
from exoid.studies.page.parts.tables import reliabilities
from exoid.studies.page.parts.words import reasons, repeated, told_of
from exoid.studies.page.pictures.bland_altman import bland_altman
from exoid.studies.page.pictures.intervals import reliabilities as drawn
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.reliability import Reliability

WORDS = {
    "ICC(A,1)": "The share of the differences between values that lasts from one day to another "
    "(McGraw and Wong; ICC(2,1) of Shrout and Fleiss). A shift of everybody between days lowers "
    "it.",
    "ICC(C,1)": "The same without that shift: ICC(3,1) of Shrout and Fleiss.",
    "by its lower end": "The word for the lower end of ICC(A,1)'s interval, which is what is sure: "
    "poor below 0.5, moderate, good from 0.75, excellent from 0.9 (Koo and Li).",
    "SEM": "The standard error of measurement: by so much the mean of a day's drops scatters "
    "about what the leg is.",
    "detectable change": "The minimal detectable change: what a single leg must change by, between "
    "two days, before it is more than the scatter of measuring twice (1.96 √2 SEM).",
    "of one drop": "ICC(A,1) if only one drop were made on a day.",
}


@part("reliability", "Test and retest")
def reliability(told: Told) -> Iterator[Block]:
    """The table, what its columns mean, and differences between days."""
    answers = told.answers
    found = [each.reliability for each in answers.each if isinstance(each.reliability, Reliability)]
    if found:
        yield repeated(found[0])
        yield reliabilities(answers)
        yield Group("details", [element("summary", "What the columns mean"), WORDS])
        yield drawn(found)
    pictures = [
        bland_altman(each.retest, f"retest-{each.quantity}")
        for each in pictured(answers.each)[:COMPARED]
        if isinstance(each.retest, Agreement)
    ]
    yield Group("div", pictures, "grid" if len(pictures) > 1 else "")
    yield told_of(found)
    yield [f"By {how}." for how in {each.how: None for each in found}]
    yield reasons(answers, "reliability")
