"""What differs between recordings of one person that should not."""

from collections import defaultdict
from collections.abc import Callable, Iterable

from exoid.recordings.conventions.balance import Balance, middle
from exoid.recordings.conventions.other_leg import apart
from exoid.studies.dataset.check.finding import Findings, error, warning
from exoid.studies.dataset.check.looked import Looked

SAME_RATE = 0.05  # relative; clocks differ by less
CHANGES = {"body_mass": 1.1, "height": 1.02}  # factors beyond which it is not one person


def across(looked: list[Looked]) -> Findings:
    """Of every person: sizes, sampling rates and devices, and legs that are not one."""
    for name, group in grouped(looked, lambda each: each.entry.participant).items():
        yield from two_sizes(name, group)
        yield from mixed(name, group)
    legs = grouped(looked, lambda each: f"{each.entry.participant} {each.entry.side}".strip())
    for name, group in legs.items():
        yield from two_legs(name, group)


def grouped(looked: Iterable[Looked], key: Callable[[Looked], str]) -> dict[str, list[Looked]]:
    found: dict[str, list[Looked]] = defaultdict(list)
    for each in looked:
        if each.entry.participant:
            found[key(each)].append(each)
    return dict(sorted(found.items()))


def two_sizes(name: str, group: list[Looked]) -> Findings:
    for field, factor in CHANGES.items():
        told = {getattr(each.subject, field): each.entry.name for each in group}
        told.pop(None, None)
        if told and max(told) > factor * min(told):
            low, high = min(told), max(told)
            says = f"has the {field.replace('_', ' ')} {low:g} in {told[low]} and {high:g} in "
            yield error("two sizes", name, f"{says}{told[high]}: are they two people?")


def mixed(name: str, group: list[Looked]) -> Findings:
    read = [each.facts for each in group if each.facts is not None]
    rates = [facts.rate for facts in read]
    if rates and max(rates) > (1 + SAME_RATE) * min(rates):
        says = f"was recorded at {min(rates):.3g} and at {max(rates):.3g} Hz."
        yield warning("mixed rates", name, f"{says} Compare with care: noise and errors differ.")
    devices = sorted({facts.device for facts in read})
    if len(devices) > 1:
        says = f"was recorded by {' | '.join(devices)}."
        yield warning("mixed devices", name, f"{says} Compare with care: zero and noise differ.")


def two_legs(name: str, group: list[Looked]) -> Findings:
    """A recording that swings so much slower or faster that it is likely another leg's."""
    pulls = [(each, each.facts.pull) for each in group if each.facts and each.facts.pull]
    known: list[tuple[Looked, Balance]] = [(each, pull) for each, pull in pulls if pull]
    if len(known) < 2:
        return
    usual = middle([pull for _, pull in known])
    for each, pull in known:
        if apart(pull, usual):
            says = (
                f"is drawn to rest by {pull.pull:.3g} 1/s^2, others of {name} by {usual.pull:.3g}"
            )
            yield warning("another leg", each.entry.name, f"{says}: is it of another leg?")
