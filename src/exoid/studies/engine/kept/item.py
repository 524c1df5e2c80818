"""A recording of a run by its content."""

from dataclasses import dataclass
from typing import Literal

from exoid.studies.dataset.entry import Entry, Participant

Status = Literal["ok", "failed", "duplicate"]


@dataclass(frozen=True)
class Item:
    """A recording, and the keys under which its results are found again."""

    entry: Entry
    participant: Participant
    recording: str  # hash of the file
    key: str  # hash of all that is known of it, on which its results hang
    size: int  # bytes


@dataclass(frozen=True)
class Unread:
    """A recording whose files cannot be read, and why."""

    entry: Entry
    reason: str
