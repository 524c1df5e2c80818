"""The tables of a study."""

from collections.abc import Sequence

from exoid.report.tables.table import Column, Table
from exoid.report.words.text import quantity_words, shown_unit
from exoid.studies.page.parts.numbers import in_brackets, number, p_cell, tells
from exoid.studies.page.parts.words import cause_words, column_words, grade, limits, shares
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answer, Answers
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import Cause
from exoid.studies.statistics.presence import Count, without_numbers
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.frames import Column as Cells
from exoid.studies.statistics.tables.frames import Frame

FEWEST_SLOPED = 10  # people, below which a slope over the size is chance
NAMED = 5  # recordings with one reason; the rest is counted
SHOWN = 200  # rows of a list of recordings; the rest is counted


def reliabilities(answers: Answers) -> Table:
    """One row per quantity that came twice."""
    each = [one for one in answers.each if isinstance(one.reliability, Reliability)]
    found = [one.reliability for one in each if isinstance(one.reliability, Reliability)]
    columns = {
        "quantity": [quantity_words(one.quantity) for one in found],
        "people": [str(one.people) for one in found],
        "ICC(A,1)": [in_brackets(one.agreement) for one in found],
        "ICC(C,1)": Column([in_brackets(one.consistency) for one in found], only="page"),
        "by its lower end": [grade(one) for one in found],
        "SEM": Column([in_brackets(one.sem, one.unit) for one in found], only="page"),
        "detectable change": [in_brackets(one.change, one.unit) for one in found],
        "of one drop": Column(
            ["" if one.one_drop is None else in_brackets(one.one_drop) for one in found],
            only="page",
        ),
    }
    title = "Test and retest"
    return Table(
        "How well one day of one leg tells people apart; 95 % intervals in brackets", columns, title
    )


def comparisons(answers: Answers, kind: str, title: str) -> Table:
    """Every pair of groups of every quantity, or the slope over a dose."""
    rows = [
        row
        for each in answers.each
        if isinstance(found := getattr(each, kind), Comparison)
        for row in pairs(found, each.corrected[kind])
    ]
    heads = ("quantity", "compared", "difference", "Hedges g", "p", "corrected p")
    return Table(f"{title}; 95 % intervals in brackets", columns(heads, rows), title)


def pairs(found: Comparison, corrected: float) -> list[tuple[str, ...]]:
    """Two groups have one p; of more, the corrected one asks whether there is any difference."""
    name, by = quantity_words(found.quantity), column_words(found.by)
    if found.slope is not None:
        effect = in_brackets(found.slope, found.unit)
        return [(name, f"per unit of {by}", effect, "", p_cell(found.p), p_cell(corrected))]
    return [
        (
            name if not at else "",
            f"{one.second} - {one.first}",
            in_brackets(one.effect, found.unit),
            in_brackets(one.g) if tells(one.g) else "not told",
            p_cell(one.p),
            p_cell(corrected) if not at else "",
        )
        for at, one in enumerate(found.differences)
    ]


def agreements(answers: Answers, kind: str, title: str) -> Table:
    """Differences of pairs, and their limits."""
    rows = [
        (
            quantity_words(each.quantity),
            str(found.people),
            in_brackets(found.difference, found.pairs.unit),
            limits(found),
            grown(found),
            "" if found.by_error is None else f"{found.by_error:.0%}",
            p_cell(found.p),
            p_cell(each.corrected.get(kind, float("nan"))),
        )
        for each in answers.each
        if isinstance(found := getattr(each, kind), Agreement)
    ]
    heads = (
        *("quantity", "people", "mean difference", "95 % of people between"),
        *("grows with size", "due to errors", "p", "corrected p"),
    )
    made = columns(heads, rows)
    ends = made["95 % of people between"]
    made["95 % of people between"] = Column([between(each) for each in ends], on_page=ends)
    for head in ("grows with size", "due to errors"):
        made[head] = Column(made[head], only="page")
    return Table(f"{title}; 95 % intervals in brackets", made, title)


def between(ends: str) -> str:
    """Limits without how sure they are, for which a terminal has no room."""
    return ends.partition(" (")[0]


def grown(found: Agreement) -> str:
    """Proportional bias, where it is sure, of people enough for a slope."""
    if found.people < FEWEST_SLOPED:
        return ""
    if not found.slope_p < 0.05:
        return "no"
    verb = "grows" if found.slope.value > 0 else "falls"
    unit = shown_unit(found.pairs.unit) or "unit"
    return f"{verb} by {number(abs(found.slope.value))} per {unit}"


def causes(found: Sequence[Cause], groups: Sequence[str]) -> Table:
    """Missing physics, by group."""
    kept = [each for each in found if each.group in groups]
    made = {
        "cause": [cause_words(each.name) for each in kept],
        "group": [each.group if len(groups) > 1 else "" for each in kept],
        "recordings": [f"{each.recordings} of {each.of_recordings}" for each in kept],
        "people": Column(
            [f"{each.people} of {each.of_people}" for each in kept],
            head="people\nwith any",
        ),
        "share of people": [shares(each) for each in kept],
    }
    return Table("Which physics was missing", made, "Missing physics")


def failures(recordings: Frame) -> Table:
    """Reasons, the most frequent first; of those that differ in their numbers alone the first."""
    failed = recordings[recordings["status"] == "failed"]
    failed = failed.assign(kind=failed["reason"].map(without_numbers))
    count = failed["kind"].value_counts()
    first = failed.drop_duplicates("kind").set_index("kind")
    names = failed.groupby("kind")["name"].agg(some)
    kept = list(count.index[:SHOWN])
    made = {
        "recordings": [str(count[each]) for each in kept],
        "which": [str(names[each]) for each in kept],
        "its reason": [str(first["reason"][each]) or "no reason is kept" for each in kept],
    }
    return Table("Recordings that failed", made, "Recordings that failed")


def some(names: Cells) -> str:
    """The first of them, and how many more."""
    more = len(names) - NAMED
    return ", ".join(names[:NAMED]) + (f" and {more} more" if more > 0 else "")


def values(answers: Sequence[Answer]) -> Table:
    """How much there is of each quantity."""
    made = {
        "quantity": [quantity_words(each.quantity) for each in answers],
        "unit": [shown_unit(each.values.unit) for each in answers],
        "people": [out_of(each.presence.people.every) for each in answers],
        "values": [out_of(each.presence.values.every) for each in answers],
        "median": [median(each) for each in answers],
    }
    return Table("Quantities that recordings told", made, "Quantities")


def out_of(each: Count) -> str:
    """How many, and of how many where some are missing."""
    return f"{each.told} of {each.of}" if each.missing else str(each.told)


def median(each: Answer) -> str:
    value = float(each.values.frame["value"].median())
    return number(value, value / 10)


def columns(heads: Sequence[str], rows: Sequence[tuple[str, ...]]) -> dict:
    return {head: [row[at] for row in rows] for at, head in enumerate(heads)}
