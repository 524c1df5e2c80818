"""The study on half a page: its clearest answers first, in plain words."""

from collections.abc import Iterator

from exoid.files.counted import counted
from exoid.report.sections.blocks import Block, Group, card, element
from exoid.report.words.text import capital, quantity_words
from exoid.studies.page.parts.correction import tested
from exoid.studies.page.parts.opening import opening
from exoid.studies.page.parts.part import Told, part
from exoid.studies.page.parts.tables import values
from exoid.studies.page.parts.words import (
    SURE,
    TOO_FEW,
    cause_words,
    changed,
    column_words,
    grade,
    grouped,
    leading,
    repeated,
    shares,
    sided,
    silent,
)
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answer, Answers
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import NOTHING
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import Untold


@part("summary", "Summary")
def summary(told: Told) -> Iterator[Block]:
    """What was found, how far to trust it, and what the study is."""
    answers = told.answers
    first, *more = opening(answers)
    yield element("p", first, "verdict")
    yield more
    asked = (whole, parted, moved, trusted, alike, missing)
    cards = (each(answers) for each in asked)
    yield Group("div", [each for each in cards if each is not None], "cards")
    yield values(answers.each)
    if answers.silent:
        yield Group("details", [element("summary", "Quantities without values"), silent(answers)])


def amount(answers: Answers) -> str:
    """People and recordings."""
    read = answers.study.read
    people = read.loc[read["participant"] != "", "participant"].nunique()
    return f"{counted(people, 'person', 'people')}, {counted(len(read), 'recording')} read"


def whole(answers: Answers) -> Group:
    """How many recordings there are, and how many failed."""
    study = answers.study
    unread, twice = len(study.once) - len(study.read), len(study.recordings) - len(study.once)
    failed = study.read[study.read["status"] == "failed"]
    partly = int(failed["recording"].isin(study.measured).sum())
    nothing = len(failed) - partly
    question = "Were all recordings read?"
    said = f"{amount(answers)}."
    lost = [f"{counted(unread, 'recording')} could not be read"] * bool(unread)
    lost += [f"of {counted(partly, 'recording')} a step failed, the others count"] * bool(partly)
    lost += [f"of {counted(nothing, 'recording')} nothing was measured"] * bool(nothing)
    lost += [f"{twice} more are the same as another and count once"] * bool(twice)
    if not lost:
        return card(question, "good", "Yes.", said)
    failing = "Yes, but not all were measured." if nothing else "Yes, but a step failed."
    answer = "Not all of them." if unread else failing if len(failed) else "Yes."
    why = f"{said} {capital('; '.join(lost))}."
    return card(question, "care" if unread or len(failed) else "good", answer, why)


def trusted(answers: Answers) -> Group:
    """Test and retest of the first quantity."""
    question = "How far does one day tell people apart?"
    first = leading(answers, "reliability")
    if first is None or isinstance(first.reliability, Untold):
        why = answers.each[0].reliability if answers.each else Untold("There are no values.")
        return card(question, "open", "Not told.", why.why if isinstance(why, Untold) else "")
    found: Reliability = first.reliability
    if grade(found) == TOO_FEW:
        return card(question, "open", f"Not told by {found.people} people.", repeated(found))
    good = grade(found) in ("good", "excellent")
    return card(
        question,
        "good" if good else "care",
        f"{capital(grade(found))}, by the lower end of the interval.",
        repeated(found),
    )


def parted(answers: Answers) -> Group | None:
    """The groups, or what goes with a dose."""
    each = tested([one for one in answers.each if isinstance(one.groups, Comparison)])
    if not each:
        return None
    sure = [one for one in each if one.corrected["groups"] < SURE]
    dose = isinstance(each[0].groups, Comparison) and each[0].groups.slope is not None
    by = column_words(answers.asked.by)
    apart = "Do groups differ?" if by == "group" else f"Do the groups of {by} differ?"
    question = f"Does anything change with {by}?" if dose else apart
    if not sure:
        why = f"No difference is sure in any of {counted(len(each), 'quantity', 'quantities')}."
        return card(question, "open", "Not surely.", why)
    named = sentence(sure)
    answer = f"Yes, in {len(sure)} of {counted(len(each), 'quantity', 'quantities')}."
    return card(question, "good", answer, named)


def sentence(sure: list[Answer]) -> str:
    """The first of those that differ, and the names of the others."""
    first, found = sure[0], sure[0].groups
    assert isinstance(found, Comparison)
    said = grouped(found, first.corrected["groups"], first.among["groups"])
    others = ", ".join(quantity_words(one.quantity) for one in sure[1:])
    return f"{said} Also: {others}." if others else said


def alike(answers: Answers) -> Group | None:
    """Left against right."""
    first = leading(answers, "sides")
    if first is None or not isinstance(first.sides, Agreement):
        return None
    p = first.corrected["sides"]
    differ = p < SURE
    answer = "Not on average." if differ else "Not told: no difference is sure."
    return card(
        "Are both sides alike?",
        "care" if differ else "open",
        answer,
        sided(first.sides, p, first.among["sides"]),
    )


def moved(answers: Answers) -> Group | None:
    """Before against after."""
    first = leading(answers, "change")
    if first is None or not isinstance(first.change, Agreement):
        return None
    p = first.corrected["change"]
    question = f"Did it change from {answers.asked.before} to {answers.asked.after}?"
    sure = p < SURE
    answer = "Yes." if sure else "Not surely."
    return card(
        question,
        "good" if sure else "open",
        answer,
        changed(first.change, p, first.among["change"]),
    )


def missing(answers: Answers) -> Group | None:
    """Which physics was missing most often."""
    if isinstance(answers.physics, Untold):
        return None
    found = [each for each in answers.physics if each.group == "all"]
    named = [each for each in found if each.name not in NOTHING]
    question = "What was the model missing?"
    if not named:
        told = all(each.name == "none" for each in found)
        answer = "Nothing that has a name." if told else "Not told."
        return card(question, "good" if told else "open", answer, f"{amount(answers)}.")
    most = named[0]
    why = f"Found in a recording of {most.people} of {most.of_people} people, {shares(most)}."
    return card(question, "care", f"{capital(cause_words(most.name))}, most often.", why)
