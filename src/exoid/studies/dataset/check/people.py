"""What is wrong with, or missing from, the table of participants."""

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping

from exoid.physics.anatomy.body.doubt import doubts, likely_exchanged
from exoid.recordings.declared.entry import known
from exoid.recordings.declared.subject import Subject
from exoid.recordings.declared.unit_hint import unit_hint
from exoid.studies.dataset.check.finding import Finding, Findings, error, warning
from exoid.studies.dataset.check.looked import Looked
from exoid.studies.dataset.entry import Dataset, Participant

RANGES: Mapping[str, Mapping] = {entry.name: entry.metadata for entry in known(Subject)}


def people(dataset: Dataset, looked: list[Looked]) -> Findings:
    """Of every row of the table, and of the people who have none."""
    told: dict[str, list[Participant | Subject]] = defaultdict(list)
    for each in looked:
        told[each.entry.participant].append(each.subject)
    told.pop("", None)
    if dataset.table is None:
        says = "there is no table of participants: exoid study init writes one to fill in."
        yield warning("no table", "", says)
    yield from near({*told, *dataset.participants})
    for person in dataset.participants.values():
        yield from sizes(person)
        if person.id not in told:
            yield warning(
                "nobody recorded",
                person.id,
                "no recording is of this row. Is the id right?",
            )
    for name in sorted(told):
        row = dataset.participants.get(name)
        if row is None and dataset.table is not None:
            yield warning("not in the table", name, f"no row of {dataset.table.name}: add one.")
        yield from missing(name, [row or Participant(name), *told[name]])


def missing(name: str, told: list[Participant | Subject]) -> Findings:
    """Sizes that neither the table nor a sidecar tells."""
    for size in ("body_mass", "height"):
        if all(getattr(each, size) is None for each in told):
            words = size.replace("_", " ")
            says = f"without a {words} only ratios to the inertia are told, nothing in kg or N m."
            yield warning(f"no {words}", name, says)


def sizes(person: Participant) -> Findings:
    """Numbers that cannot be true of this person."""
    bad: list[Finding] = []
    exchanged = likely_exchanged(person.body_mass, person.height)
    for name in ("body_mass", "height", "age"):
        value, meta = getattr(person, name), RANGES[name]
        low, high = meta["lower"], meta["upper"]
        if value is not None and not low <= value <= high:
            hint = exchanged or unit_hint(meta["key"], meta["unit"], value, (low, high))
            says = f"{meta['key']} is {value:g}; it must lie between {low:g} and {high:g}.{hint}"
            bad.append(error("impossible size", person.id, says))
    yield from bad or builds(person)


def builds(person: Participant) -> Findings:
    for says, impossible in doubts(person.body_mass, person.height, person.age):
        if impossible:
            yield error("impossible size", person.id, says)
        else:
            yield warning("unusual size", person.id, says)


def near(ids: Iterable[str]) -> Findings:
    """P1 and p01 are likely one person."""
    alike: dict[str, list[str]] = defaultdict(list)
    for each in sorted(ids):
        alike[re.sub(r"[\W_]+|(?<!\d)0+(?=\d)", "", each.casefold())].append(each)
    for group in alike.values():
        if len(group) > 1:
            says = "are they one person? Then write one id; else choose ids that differ by more."
            yield warning("ids alike", " and ".join(group), says)
