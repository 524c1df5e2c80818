"""On whom a finding rests, and who and what is missing, in sentences."""

from collections.abc import Iterator, Mapping, Sequence

from exoid.report.words.text import capital, quantity_words
from exoid.studies.statistics.asked import Answer
from exoid.studies.statistics.groups import MOST_GROUPS, Comparison
from exoid.studies.statistics.presence import Count, Presence, Tally

RECORDINGS, VALUES = "recordings without a value", "values are missing"
INCOMPLETE = "values are of fits whose model misses something"
REMEDY = (
    "--steps drops,fit,diagnose of 'exoid study run' asks what they miss, and --with has a cause "
    "in the model of all"
)
NAMED = 5  # people who are missing; the others are counted


def rests(answer: Answer) -> str:
    """How many people of each group, who is missing, and what that may do to a difference."""
    found, parts = answer.presence, parts_of(answer)
    each = {RECORDINGS: found.recordings, VALUES: found.values}
    counts = [
        f"{part_of(tally, what, parts)}." for what, tally in each.items() if uneven([tally], parts)
    ]
    said = [people(found, grouped(answer)), *counts, *biased(answer)]
    return " ".join([*said, *(incomplete(answer) if grouped(answer) else ())])


def whose(answer: Answer) -> str:
    """How many people of each group have a value, who has none, and why."""
    found, quantity = answer.presence, capital(quantity_words(answer.quantity))
    if not found.missing:
        return ""
    why = f", mostly as here: {found.reason.rstrip('.')}" if found.reason else ""
    known = of_people(found, grouped(answer))
    return f"{quantity} is known of {known}, and not of {named(found)}{why}."


def lacking(answer: Answer) -> Iterator[str]:
    """Recordings and values that are missing, and whether groups or sides differ in them."""
    found, parts = answer.presence, parts_of(answer)
    if found.recordings.every.missing:
        yield f"{part_of(found.recordings, RECORDINGS, parts)}."
    if found.values.every.missing:
        why = f"; mostly as here: {found.reason.rstrip('.')}" if found.reason else ""
        yield f"{part_of(found.values, VALUES, parts)}{why}."
    yield from biased(answer)
    yield from incomplete(answer) if grouped(answer) else ()


def biased(answer: Answer) -> Iterator[str]:
    """Whether what is missing may make groups or sides differ."""
    found = answer.presence
    apart = uneven([found.people, found.recordings, found.values], parts_of(answer))
    if apart:
        yield (
            f"The share that is missing differs between {' and '.join(f'{one}s' for one in apart)}"
            ", which may bias the difference between them."
        )


def incomplete(answer: Answer) -> Iterator[str]:
    """Values that may be off by more than they say, and unlike in the groups."""
    found = answer.presence.complete
    if found.uneven("group"):
        yield (
            f"{part_of(found, INCOMPLETE, ('group',))}, which may bias the difference between "
            f"groups: {REMEDY}."
        )


def uneven(tallies: Sequence[Tally], parts: Sequence[str]) -> list[str]:
    """The parts between which one of these differs."""
    return [part for part in parts if any(each.uneven(part) for each in tallies)]


def parts_of(answer: Answer) -> tuple[str, ...]:
    """Between what something may differ."""
    return ("group", "side") if grouped(answer) else ("side",)


def grouped(answer: Answer) -> bool:
    """Are there groups to be told apart? A dose has none."""
    dose = isinstance(answer.groups, Comparison) and answer.groups.kind == "dose"
    return not dose and 1 < len(answer.presence.people.parts["group"]) <= MOST_GROUPS


def people(found: Presence, by_group: bool) -> str:
    """It rests on 10 of 10 control and 3 of 10 spastic people; missing: p01, p03."""
    missing = f"; missing: {named(found)}" if found.missing else ""
    return f"It rests on {of_people(found, by_group)}{missing}."


def of_people(found: Presence, by_group: bool) -> str:
    """10 of 10 control and 3 of 10 spastic people."""
    every = found.people.every
    said = f"{every.told} of {every.of}"
    if by_group:
        parts = found.people.parts["group"].items()
        said = " and ".join(f"{each.told} of {each.of} {name}" for name, each in parts)
    return f"{said} people"


def named(found: Presence) -> str:
    """Those who are missing; of many the first, and how many more."""
    more = len(found.missing) - NAMED
    return ", ".join(found.missing[:NAMED]) + (f" and {more} more" if more > 0 else "")


def part_of(tally: Tally, what: str, parts: Sequence[str]) -> str:
    """23 of 380 values are missing: control 3 of 190, spastic 20 of 190."""
    said = f"{tally.every.missing} of {tally.every.of} {what}"
    apart = [listed(tally.parts[each]) for each in uneven([tally], parts)]
    return f"{said}: {'; '.join(apart)}" if apart else said


def listed(each: Mapping[str, Count]) -> str:
    return ", ".join(f"{name} {one.missing} of {one.of}" for name, one in each.items())
