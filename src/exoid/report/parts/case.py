"""All that a report is made of: what was read, what was found in it, and how to do it again."""

from dataclasses import dataclass

from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.planning.planned import Plan
from exoid.recordings.can.quality import LogQuality
from exoid.recordings.recording import Recording
from exoid.report.parts.origin import Origin
from exoid.report.words.person import people
from exoid.trust.identifiability import Identifiability


@dataclass(frozen=True, eq=False)
class Source:
    """A recording as it was analysed, and what its reader noticed."""

    name: str
    recording: Recording
    notes: tuple[str, ...] = ()
    quality: LogQuality | None = None  # of a CAN log


@dataclass(frozen=True, eq=False)
class Case:
    """One leg, or rig, as a report tells of it; None where that was not asked."""

    sources: tuple[Source, ...]  # empty where the recordings are not at hand
    fit: FitResult
    origin: Origin
    told: Identifiability | None = None
    diagnosis: Diagnosis | None = None
    plan: Plan | None = None
    absent: tuple[str, ...] = ()  # recordings that are not at hand

    @property
    def who(self) -> str:
        """Person, side and session, as the sidecars say; empty where they do not."""
        return people(source.recording.subject for source in self.sources)

    @property
    def title(self) -> str:
        """Who it is, where that is said, and the names of the recordings."""
        names = ", ".join((*(source.name for source in self.sources), *self.absent))
        return f"{self.who}: {names}" if self.who else names
