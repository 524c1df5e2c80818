"""The names of recordings in another layout: one for each, whatever the old ones were."""

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import replace
from itertools import count

from exoid.studies.dataset.entry import Entry
from exoid.studies.dataset.motion_bids.labels import label, motion_file

TASK = "knee"
SYSTEM = "knee"  # of BIDS' tracksys
Leg = tuple[str, str, str, str]


def numbered(entries: Iterable[Entry]) -> list[Entry]:
    """The entries with labels in place of their words, and runs such that no two are alike.

    A run that is told stays where it is free; the others take the next number. **Raises**
    `ValueError` for a recording of nobody, and for people whose ids become one.
    """
    legs: dict[Leg, list[int]] = defaultdict(list)
    found = [labelled(entry) for entry in entries]
    check_people(found, entries)
    for at, each in enumerate(found):
        legs[each.participant, each.session, each.side, each.task].append(at)
    for group in legs.values():
        if len(group) > 1 or found[group[0]].run:
            for at, run in zip(group, runs([found[at].run for at in group]), strict=True):
                found[at] = replace(found[at], run=str(run))
    return found


def runs(told: list[str]) -> list[int]:
    """A number for each trial, all different: the one that is told, for the first who tells it."""
    first: dict[int, int] = {}
    for at, run in enumerate(told):
        if run.isdecimal():
            first.setdefault(int(run), at)
    taken = {at: run for run, at in first.items()}
    free = (run for run in count(1) if run not in first)
    return [taken[at] if at in taken else next(free) for at in range(len(told))]


def labelled(entry: Entry) -> Entry:
    if not label(entry.participant):
        raise ValueError(
            f"{entry.name} tells nobody. Put an id into its name or its sidecar; exoid study check "
            "names all such recordings."
        )
    words = {name: label(getattr(entry, name)) for name in ("participant", "session", "side")}
    return replace(entry, **words, task=label(entry.task) or TASK)


def check_people(found: list[Entry], entries: Iterable[Entry]) -> None:
    """Refuse ids that differ by signs or capitals alone: as names of folders they would be one."""
    people: dict[str, str] = {}
    for each, entry in zip(found, entries, strict=True):
        other = people.setdefault(each.participant.casefold(), entry.participant)
        if other != entry.participant:
            raise ValueError(
                f"{other} and {entry.participant} would be one person, sub-{each.participant}: "
                "choose ids that differ by more than signs or capitals."
            )


def bids_name(entry: Entry) -> str:
    return motion_file(
        {
            "sub": entry.participant,
            "ses": entry.session,
            "task": entry.task,
            "tracksys": SYSTEM,
            "acq": entry.side,
            "run": entry.run,
        }
    )


def plain_name(entry: Entry) -> str:
    """As `layout.py` reads it again: a folder for each person."""
    told = {
        "sub": entry.participant,
        "ses": entry.session,
        "side": entry.side,
        "task": entry.task,
        "run": entry.run,
    }
    words = [f"{key}-{each}" for key, each in told.items() if each]
    return f"{words[0]}/{'_'.join(words)}.csv"
