"""What is known of a recording that was looked at."""

from dataclasses import dataclass

from exoid.recordings.conventions.balance import Balance
from exoid.recordings.declared.subject import Subject
from exoid.studies.dataset.entry import Entry


@dataclass(frozen=True)
class Facts:
    """What the samples of a recording say."""

    device: str
    rate: float  # Hz
    segments: int
    drops: int  # of the segments, passive
    pull: Balance | None  # that draws the leg to rest
    gyro_unread: bool = False  # is there a column that may be one, under a name of its own?


@dataclass(frozen=True)
class Looked:
    """A recording as its sidecar has it; why it cannot be read; its facts, where it was read."""

    entry: Entry
    subject: Subject
    named: Entry  # as its name alone has it
    fault: str = ""
    facts: Facts | None = None
