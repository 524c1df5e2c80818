"""Who it is, which leg, and which session: what stands over every table of a person."""

from collections.abc import Iterable, Mapping
from typing import Any

from exoid.recordings.declared.subject import Subject

KEYS = ("id", "side", "session")


def identity(subject: Subject) -> dict[str, str | None]:
    """What the sidecar says, for machines."""
    return {key: getattr(subject, key) for key in KEYS}


def person(said: Mapping[str, Any]) -> str:
    """In words; empty where nothing is said."""
    words = {"id": "{}", "side": "{} leg", "session": "session {}"}
    return ", ".join(words[key].format(said[key]) for key in KEYS if said.get(key))


def people(subjects: Iterable[Subject]) -> str:
    """Of several recordings: each of them once."""
    each = dict.fromkeys(person(identity(subject)) for subject in subjects)
    return "; ".join(one for one in each if one)
