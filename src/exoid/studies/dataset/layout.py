"""What the name of a file says: whose leg, which side, when, and which trial.

`sub-01/ses-2/right_3.csv`, `P01_left_day1.csv`, `P01/post/left/trial2.blf`: words between `_`, `-`,
spaces and folders. A person is told by `sub-`, by the table of participants, by a word of letters
and digits, or by a number in front; a word without a digit could be anything, and tells nobody.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from exoid.files.visible import visible
from exoid.studies.dataset.entry import Entry

PEOPLE = ("sub", "subject", "patient", "participant", "proband")
VISITS = ("ses", "session", "visit")
TIMES = ("day", "week", "month", "year", "t")  # a number of one is not another's: day1, week1
KEYS = {
    **dict.fromkeys(PEOPLE, "participant"),
    **dict.fromkeys((*VISITS, *TIMES), "session"),
    **dict.fromkeys(("side", "leg", "hemi", "acq"), "side"),
    **dict.fromkeys(("run", "trial", "drop", "rep", "repetition", "take", "nr", "no"), "run"),
    "task": "task",
}
SESSIONS = ("pre", "post", "before", "after", "baseline", "followup", "test", "retest")
OF_SIDES = {
    **dict.fromkeys(("left", "l", "links", "li", "gauche", "izquierda", "sinistra"), "left"),
    **dict.fromkeys(("right", "r", "rechts", "re", "droite", "derecha", "destra"), "right"),
}
NOBODY = (  # with a number behind them they count something else
    *("knee", "shank", "imu", "node", "rec", "recording", "data", "file", "log", "version", "v"),
    *("study", "site", "group", "cohort", "batch", "set", "dataset", "arm", "centre", "center"),
    *("clinic", "wave", "phase", "series", "exp", "experiment", "block", "part", "protocol"),
)
KEYED = re.compile(r"([a-z]+)-(.+)", re.IGNORECASE)
NUMBERED = re.compile(r"([a-z]+)(\d+)", re.IGNORECASE)
APART = re.compile(rf"(?<![^\W_])({'|'.join(KEYS)})[ _](?=\d+(?![^\W_]))", re.IGNORECASE)
PERSON = re.compile(r"([^\W\d_]+)\d[^\W_]*")
DATE = re.compile(r"(?<!\d)(?:19|20)\d\d-?[01]\d-?[0-3]\d(?!\d)")
DAY_FIRST = re.compile(r"(?<!\d)([0-3]?\d)\.([01]?\d)\.((?:19|20)\d\d)(?!\d)")
BETWEEN = re.compile(r"[_\s.]+")
MAYBE, NUMBER = "maybe", "number"  # a person, if nothing else tells one; and a trial or a person
V, VISIT = "v", "visit"  # a visit where nothing else tells one: else a version, such as of a format


@dataclass(frozen=True)
class Said:
    """A word of a name, and what it tells."""

    field: str
    value: str


def entry_of(folder: Path, name: str, ids: frozenset[str]) -> Entry:
    """The recording of that name below `folder`; `ids` are those of the table of participants.

    Where a folder and the file in it say different things, it is the file's.
    """
    told: dict[str, Any] = {each.field: visible(each.value) for each in said(name, ids)}
    return Entry(folder / name, visible(name), **told)


def said(name: str, ids: frozenset[str] = frozenset()) -> list[Said]:
    """All that a name says of person, session, side, task and run, folders first."""
    *folders, file = name.split("/")
    found: list[Said] = []
    for part in folders:
        found += of_part(part, ids_after(found, ids))
    found += of_part.__wrapped__(file.rpartition(".")[0] or file, ids_after(found, ids))
    return settled(found)


def ids_after(found: list[Said], ids: frozenset[str]) -> frozenset[str]:
    """Once a person is told, a number further on counts trials, whoever has it for an id."""
    told = any(each.field == "participant" for each in found)
    return without_numbers(ids) if told else ids


@lru_cache(maxsize=4)
def without_numbers(ids: frozenset[str]) -> frozenset[str]:
    return frozenset(each for each in ids if not each.isdecimal())


def settled(found: list[Said]) -> list[Said]:
    """With a person and a trial from the words that may be one, where none is told."""
    fields = {each.field for each in found}
    numbers = [each.value for each in found if each.field == NUMBER]
    people = [each.value for each in found if each.field == MAYBE]
    visits = [each.value for each in found if each.field == VISIT]
    sure = [each for each in found if each.field not in (MAYBE, NUMBER, VISIT)]
    if "session" not in fields and visits:
        sure.append(Said("session", visits[-1]))
    if "participant" not in fields and people:
        sure.append(Said("participant", people[0]))
    elif "participant" not in fields and (len(numbers) > 1 or (numbers and "run" in fields)):
        sure.append(Said("participant", numbers.pop(0)))
    if "run" not in fields and numbers:
        sure.append(Said("run", numbers[-1]))
    return sure


@lru_cache(maxsize=4096)
def of_part(part: str, ids: frozenset[str]) -> tuple[Said, ...]:
    """What a folder or the stem of a file says; of folders it is kept, as they hold many files."""
    found = []
    person = person_in(part, ids)
    if person:
        found.append(Said("participant", part[person]))
        part = part[: person.start] + part[person.stop :]
    part = DAY_FIRST.sub(lambda at: f"{at[3]}-{at[2]:0>2}-{at[1]:0>2}", part)
    date = DATE.search(part)
    if date:
        found.append(Said("session", date[0]))
        part = part.replace(date[0], "", 1)
    words = BETWEEN.split(APART.sub(r"\1", part))
    return (*found, *(each for word in words for each in of_word(word)))


def person_in(part: str, ids: frozenset[str]) -> slice | None:
    """Where the longest id of the table stands in it, as words of its own."""
    if not ids or part.lower().startswith("sub-"):
        return None
    edges = [-1, *(at.start() for at in re.finditer(r"[_\-\s.]", part)), len(part)]
    spans = (slice(a + 1, b) for a in edges for b in edges if a < b)
    found = [each for each in spans if part[each] in ids]
    return max(found, key=lambda each: each.stop - each.start, default=None)


def of_word(word: str) -> Iterator[Said]:
    """What a word between spaces and underlines says; without a key, what its parts say."""
    keyed = KEYED.fullmatch(word)
    if keyed and keyed[1].lower() in KEYS:
        yield from of_key(keyed[1].lower(), keyed[2])
        return
    if word.lower().replace("-", "") in SESSIONS:  # re-test is no right side
        yield Said("session", word)
        return
    for each in word.split("-"):
        low, numbered, person = each.lower(), NUMBERED.fullmatch(each), PERSON.fullmatch(each)
        if low in OF_SIDES:
            yield Said("side", OF_SIDES[low])
        elif low in SESSIONS:
            yield Said("session", each)
        elif numbered and numbered[1].lower() in KEYS:
            yield from of_key(numbered[1].lower(), numbered[2])
        elif numbered and numbered[1].lower() == V:
            yield Said(VISIT, numbered[2])
        elif each.isdecimal():
            yield Said(NUMBER, each)
        elif person and person[1].lower() not in NOBODY:
            yield Said(MAYBE, each)


def of_key(key: str, value: str) -> Iterator[Said]:
    field = KEYS[key]
    if field != "side":
        yield Said(field, f"{key}{value}" if key in TIMES else value)
    elif value.lower() in OF_SIDES:
        yield Said(field, OF_SIDES[value.lower()])
