"""What is to be estimated of whom, when that is enough, and where it is shown."""

from collections.abc import Sequence
from dataclasses import dataclass

from exoid.cli.live.viewing import Views
from exoid.recordings.declared.subject import Subject
from exoid.watching.beside.goals import Goal
from exoid.watching.origin import Origin


@dataclass(frozen=True)
class Wanted:
    """What is to be estimated, when that is enough, and where it is shown."""

    terms: tuple[type, ...]
    goals: Sequence[Goal]
    views: Views
    refine: bool | None

    def origin(self, subject: Subject, **placed) -> Origin:
        return Origin(subject, terms=self.terms, goals=self.goals, **placed)
