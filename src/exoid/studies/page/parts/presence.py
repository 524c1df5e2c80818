"""On whom a finding rests, and who and what is missing, in sentences."""

from collections.abc import Iterator, Mapping

from exoid.studies.statistics.asked import Answer
from exoid.studies.statistics.groups import MOST_GROUPS, Comparison
from exoid.studies.statistics.presence import Count, Presence, Tally

NAMED = 5  # people who are missing; the others are counted


def rests(answer: Answer) -> str:
    """How many people of each group, who is missing, and what that may do to a difference."""
    return " ".join([people(answer.presence, grouped(answer)), *lacking(answer)])


def lacking(answer: Answer) -> Iterator[str]:
    """Recordings and values that are missing, and whether groups or sides differ in them."""
    found, by_group = answer.presence, grouped(answer)
    parts = ("group", "side") if by_group else ("side",)
    if found.recordings.every.missing:
        yield f"{part_of(found.recordings, 'recordings have no value', parts)}."
    if found.values.every.missing:
        why = f"; mostly as here: {found.reason.rstrip('.')}" if found.reason else ""
        yield f"{part_of(found.values, 'values are missing', parts)}{why}."
    tallies = (found.people, found.recordings, found.values)
    uneven = [part for part in parts if any(each.uneven(part) for each in tallies)]
    if uneven:
        yield (
            f"The share that is missing differs between {' and '.join(f'{one}s' for one in uneven)}"
            ", which may bias the difference between them."
        )


def grouped(answer: Answer) -> bool:
    """Are there groups to be told apart? A dose has none."""
    dose = isinstance(answer.groups, Comparison) and answer.groups.kind == "dose"
    return not dose and 1 < len(answer.presence.people.parts["group"]) <= MOST_GROUPS


def people(found: Presence, by_group: bool) -> str:
    """It rests on 10 of 10 control and 3 of 10 spastic people; missing: p01, p03."""
    every = found.people.every
    said = f"{every.told} of {every.of}"
    if by_group:
        parts = found.people.parts["group"].items()
        said = " and ".join(f"{each.told} of {each.of} {name}" for name, each in parts)
    more = len(found.missing) - NAMED
    names = ", ".join(found.missing[:NAMED]) + (f" and {more} more" if more > 0 else "")
    return f"It rests on {said} people{f'; missing: {names}' if names else ''}."


def part_of(tally: Tally, what: str, parts: tuple[str, ...]) -> str:
    """23 of 380 values are missing: control 3 of 190, spastic 20 of 190."""
    said = f"{tally.every.missing} of {tally.every.of} {what}"
    uneven = [listed(tally.parts[each]) for each in parts if tally.uneven(each)]
    return f"{said}: {'; '.join(uneven)}" if uneven else said


def listed(each: Mapping[str, Count]) -> str:
    return ", ".join(f"{name} {one.missing} of {one.of}" for name, one in each.items())
