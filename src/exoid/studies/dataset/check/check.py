"""A data set before it is run: what is there, what is missing, what does not agree."""

from collections import Counter
from dataclasses import dataclass

from exoid.studies.dataset.check.across import across
from exoid.studies.dataset.check.finding import Finding, error, warning
from exoid.studies.dataset.check.look import Progress, look
from exoid.studies.dataset.check.looked import Looked
from exoid.studies.dataset.check.people import people
from exoid.studies.dataset.check.recordings import recordings
from exoid.studies.dataset.entry import Dataset

NO_TABLE = "is a text without a table of numbers, and taken for no recording."
UNTOLD = ("no body mass", "no height")


@dataclass(frozen=True)
class Checked:
    """What was found; counts are of recordings unless they say otherwise."""

    layout: str
    recordings: int
    read: int
    people: int
    sessions: dict[str, int]
    sides: dict[str, int]
    devices: dict[str, int]  # of those that were read, with their rates
    drops: int  # of those that were read, with a passive drop
    readable: int  # of those that were read
    ratios_only: int  # people of whom body mass or height is not told
    findings: tuple[Finding, ...]

    @property
    def errors(self) -> int:
        return sum(each.level == "error" for each in self.findings)


def check_dataset(dataset: Dataset, most: int, say: Progress) -> Checked:
    """Look at a data set; `most` of its recordings are read, the sidecars of all.

    The time is that of reading so many recordings, and of listing the rest.
    """
    looked = look(dataset, most, say)
    say("comparing what the recordings hold")
    findings = [error("layout", "", each) for each in dataset.problems]
    findings += [warning("left aside", each, NO_TABLE) for each in dataset.aside]
    findings += [*people(dataset, looked), *recordings(dataset, looked), *across(looked)]
    findings.sort(key=lambda each: each.level)
    return summed(dataset, looked, tuple(findings), min(most, len(looked)))


def summed(
    dataset: Dataset, looked: list[Looked], findings: tuple[Finding, ...], read: int
) -> Checked:
    facts = [each.facts for each in looked if each.facts is not None]
    entries = [each.entry for each in looked]
    return Checked(
        layout="Motion-BIDS" if dataset.bids else "plain",
        recordings=len(looked),
        read=read,
        people=len({each.participant for each in entries} - {""}),
        sessions=counted(each.session for each in entries),
        sides=counted(each.side for each in entries),
        devices=counted(f"{each.device}, {each.rate:.3g} Hz" for each in facts),
        drops=sum(each.drops > 0 for each in facts),
        readable=len(facts),
        ratios_only=len({each.where for each in findings if each.kind in UNTOLD}),
        findings=findings,
    )


def counted(words) -> dict[str, int]:
    return dict(Counter(sorted(words)))
