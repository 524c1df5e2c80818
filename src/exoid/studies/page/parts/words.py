"""What a study found, in sentences: a terminal and a page say the same."""

from collections.abc import Sequence
from math import isfinite

from exoid.files.counted import counted
from exoid.report.words.text import by_reason, capital, in_words, quantity_words, shown_unit
from exoid.studies.page.parts.numbers import number, odds, with_interval
from exoid.studies.page.parts.presence import rests
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answer, Answers, Asked
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import Cause
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import Interval, Untold

SURE = 0.05  # p, below which a difference is called one
# Koo & Li (2016), J Chiropr Med 15: 155-163, of the lower end of the interval.
GRADES = ((0.9, "excellent"), (0.75, "good"), (0.5, "moderate"), (-1.0, "poor"))
# People whose spread, on which an ICC hangs, is known to a factor of two: sqrt(8 / chi2(0.025, 8)).
FEWEST = 9
TOO_FEW = "too few people"


def column_words(column: str) -> str:
    """A column of participants as a sentence has it."""
    return column.removeprefix("participant_").replace("_", " ")


def grade(each: Reliability) -> str:
    """Of the lower end of its interval, which is what is sure; of few people no word is."""
    if each.people < FEWEST:
        return TOO_FEW
    low = each.agreement.low if isfinite(each.agreement.low) else each.agreement.value
    return next(word for least, word in GRADES if low >= least)


def grouped(found: Comparison, corrected: float, count: int) -> str:
    """Whether groups, or doses, differ."""
    what, by = capital(quantity_words(found.quantity)), column_words(found.by)
    p = odds(found.p, corrected, count)
    if found.slope is not None:
        change = with_interval(found.slope, found.unit)
        verb = "changes with" if corrected < SURE else "shows no change that is sure with"
        return f"{what} {verb} {by}: {change} per unit of {by}, {p}."
    if len(found.differences) == 1:
        one = found.differences[0]
        apart = with_interval(Interval(abs(one.effect.value), *span(one.effect)), found.unit)
        more = "higher" if one.effect.value > 0 else "lower"
        if corrected < SURE:
            return f"{what} is {more} by {apart} in {one.second} than in {one.first}, {p}."
        shown = with_interval(one.effect, found.unit)
        return (
            f"{what}: no difference that is sure between {one.first} and {one.second}; "
            f"{one.second} less {one.first} is {shown}, {p}."
        )
    named = "differs" if corrected < SURE else "shows no difference that is sure"
    means = "; ".join(
        f"{each.name} {with_interval(each.mean, found.unit)}" for each in found.groups
    )
    return f"{what} {named} between the groups of {by}, {p}: {means}."


def span(effect: Interval) -> tuple[float, float]:
    """The interval of a size, whatever its sign."""
    return (effect.low, effect.high) if effect.value > 0 else (-effect.high, -effect.low)


def changed(found: Agreement, corrected: float, count: int) -> str:
    """Whether it changed from before to after."""
    pairs = found.pairs
    what, effect = capital(quantity_words(pairs.quantity)), found.difference
    when = f"from {pairs.first} to {pairs.second}"
    p = odds(found.p, corrected, count)
    if corrected < SURE:
        verb = "rose" if effect.value > 0 else "fell"
        size = with_interval(Interval(abs(effect.value), *span(effect)), pairs.unit)
        return f"{what} {verb} by {size} {when}, {p}, in {found.people} people."
    shown = with_interval(effect, pairs.unit)
    return f"{what}: no change that is sure {when}: {shown}, {p}."


def sided(found: Agreement, corrected: float, count: int) -> str:
    """Whether sides differ, on average and in single people."""
    pairs, effect = found.pairs, found.difference
    what = quantity_words(pairs.quantity)
    shown = with_interval(effect, pairs.unit)
    differ = f"sides differ on average, right less left is {shown}"
    if not corrected < SURE:
        may = "cannot be told apart from zero"
        if effect.low > 0 or effect.high < 0:
            may = "may be chance, of so many comparisons,"
        differ = (
            f"right less left is {shown}, which {may} and could be as large as "
            f"{largest(effect, pairs.unit)}"
        )
    return (
        f"{capital(what)}: {differ}, {odds(found.p, corrected, count)}, in {found.people} people; "
        f"in 95 % of people between {limits(found)}."
    )


def largest(effect: Interval, unit: str) -> str:
    """The end of the interval that is farther from zero."""
    size = max(abs(effect.low), abs(effect.high))
    return f"{number(size, (effect.high - effect.low) / 2)} {shown_unit(unit)}".rstrip()


def limits(found: Agreement) -> str:
    """The limits of agreement, and how sure they are of so many people."""
    half, unit = (found.upper.high - found.upper.low) / 2, shown_unit(found.pairs.unit)
    ends = (number(each.value, half) for each in (found.lower, found.upper))
    said = f"{' and '.join(ends)} {unit}".rstrip()
    return f"{said} (each ± {f'{number(half)} {unit}'.rstrip()})"


def repeated(found: Reliability) -> str:
    """How far one day tells people apart, and what change is more than chance."""
    what = quantity_words(found.quantity)
    drops = counted(round(found.drops), "drop")
    change = with_interval(found.change, found.unit)
    graded = f"is {grade(found)} at telling people apart (by the lower end of the interval)"
    if grade(found) == TOO_FEW:
        graded = f"tells people apart by a share that {found.people} people do not tell"
    return (
        f"{capital(what)} of {drops} on one day {graded}: ICC(A,1) "
        f"{with_interval(found.agreement)}. In one leg, only a change of more than {change} is "
        "more than chance."
    )


def told_of(found: Sequence[Reliability]) -> list[str]:
    """What is to be said of them, those of one note together."""
    notes = by_reason((quantity_words(each.quantity), one) for each in found for one in each.notes)
    return [f"{', '.join(names)}: {one}." for one, names in notes.items()]


def cause_words(name: str) -> str:
    """As a table has it, among causes."""
    said = {"none": "nothing was missing", "cannot tell": "cannot be told"}
    return said.get(name, in_words(name))


def shares(each: Cause) -> str:
    one = each.share
    value, low, high = (f"{100 * each:.0f} %" for each in (one.value, one.low, one.high))
    return f"{value} (95 % {low} to {high})"


MANY = 3  # quantities, beyond which a list of all of them says no more than "all"
MAIN = ("change_by_group", "change", "groups")  # findings, the first of which leads


def finding(answers: Answers) -> str:
    """The main one, of the first quantity, on whom it rests, and what is missing; where no primary
    one was named and another is sure, that one.
    """
    if not answers.each:
        return "No quantity has values that recordings told."
    first = answers.each[0] if answers.asked.primary else surest(answers)
    return f"{found_first(first, answers.asked)} {rests(first)}"


def surest(answers: Answers) -> Answer:
    """The first quantity of which the leading kind of finding is sure, else the first that has an
    answer of this kind.
    """
    told = ((kind, each) for kind in MAIN for each in answers.each if kind in each.corrected)
    kind, first = next(told, ("", answers.each[0]))
    sure = (each for each in answers.each if each.corrected.get(kind, 1.0) < SURE)
    return next(sure, first)


def found_first(first: Answer, asked: Asked) -> str:
    """The change by groups, the change, the groups, else how well it repeats."""
    p, among = first.corrected, first.among
    if isinstance(first.change_by_group, Comparison):
        said = grouped(first.change_by_group, p["change_by_group"], among["change_by_group"])
        return f"Change from {asked.before} to {asked.after}. {said}"
    if isinstance(first.change, Agreement):
        return changed(first.change, p["change"], among["change"])
    if isinstance(first.groups, Comparison):
        return grouped(first.groups, p["groups"], among["groups"])
    if isinstance(first.reliability, Reliability):
        return repeated(first.reliability)
    if isinstance(first.sides, Agreement):
        return sided(first.sides, p["sides"], among["sides"])
    return f"{counted(first.values.people, 'person', 'people')}. {first.reliability.why}"


def leading(answers: Answers, kind: str) -> Answer | None:
    """The first quantity that has an answer of this kind."""
    found = (each for each in answers.each if not isinstance(getattr(each, kind), Untold | None))
    return next(found, None)


def silent(answers: Answers) -> list[str]:
    """The quantities without values, those of one reason together."""
    found = by_reason((quantity_words(name), why) for name, why in answers.silent.items())
    return [f"{', '.join(names)}: {why}" for why, names in found.items()]


def why_not(answers: Answers, kind: str) -> dict[str, str]:
    """Why quantities have no answer of this kind, those of one reason together."""
    found: dict[str, list[str]] = {}
    for each in answers.each:
        told = getattr(each, kind)
        if isinstance(told, Untold):
            found.setdefault(told.why, []).append(quantity_words(each.quantity))
    return {names_of(names, len(answers.each)): why for why, names in found.items()}


def reasons(answers: Answers, kind: str) -> list[str]:
    """The same as sentences that begin with the quantities."""
    return [f"{names}: {within(why)}" for names, why in why_not(answers, kind).items()]


def names_of(names: list[str], of: int) -> str:
    """Of some quantities; where it is every one of many, without a list of them."""
    return "all quantities" if len(names) == of > MANY else ", ".join(names)


def within(why: str) -> str:
    """A sentence as it goes on behind a colon: ordinary words begin small."""
    return f"{why[0].lower()}{why[1:]}" if why[1:2].islower() else why
