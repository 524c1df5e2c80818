"""The answer of a diagnosis: numbers, names and sentences, and nothing that a file cannot keep."""

from dataclasses import dataclass, field
from typing import Annotated, Literal

from exoid.fitting.result.agreement import roughly
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer import summary
from exoid.mismatch.evidence.location import Location
from exoid.mismatch.evidence.prediction import Proof
from exoid.mismatch.evidence.yardstick import UNEXPLAINED
from exoid.mismatch.search.found import Workings
from exoid.mismatch.sensors.agreement import SensorError

Verdict = Literal["none", "mismatch", "cannot_tell"]


@dataclass(frozen=True)
class Parameter:
    """A parameter of what was found."""

    name: str
    value: float
    unit: str
    standard_error: float | None


@dataclass(frozen=True)
class Booked:
    """What the baseline had made of it."""

    name: str
    before: float
    after: float
    unit: str


@dataclass(frozen=True)
class Finding:
    """An effect that is missing, in a user's words."""

    name: str
    title: str
    explanation: str
    reference: str


@dataclass(frozen=True)
class Tested:
    """A cause, and what it leaves: no terms, one, two, or a formula."""

    terms: list[str]
    mean_square: Annotated[float, "1"]  # of what is left over the noise: 1 is the noise itself
    evidence: Annotated[float | None, "1"]  # against the baseline; None where it did not run free
    chosen: bool = False


@dataclass(frozen=True)
class NovelTorque:
    """A torque that the library does not know, as a formula."""

    words: str
    explained: Annotated[float, "1"]  # share of the missing torque's variance
    known: Annotated[float, "1"]  # share of it that is in the library already
    # From when to when nearly all of it acts, where every segment has it once: place or moment?
    once: Annotated[tuple[float, float] | None, "s"] = None
    over_inertia: str = ""  # the same words for the torque over J; empty in older files
    simple: str = ""  # the simple torque of `exoid effects` that it is, if any


@dataclass(frozen=True)
class Suspect:
    """What a cause that it may be would make of the leg's numbers, and its own."""

    terms: list[str]
    numbers: list[Booked]
    parameters: list[Parameter] = field(default_factory=list)  # none in older files


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """The answer, and what it rests on.

    >>> found = exoid.diagnose("drops.csv", multistart=4)
    >>> found.verdict, found.fit is found.before
    ('none', True)
    """

    verdict: Verdict
    reasons: list[str]  # why not more could be said
    findings: list[Finding]
    ranking: list[str]
    equivalent: list[str]
    novel: bool  # does something act that the library does not know
    formula: NovelTorque | None  # of it
    parameters: list[Parameter]
    inertia: Annotated[float, "kg m^2"]  # that torques among them go with
    booked: list[Booked]
    location: Location
    proof: Proof
    baseline: Tested
    best: Tested  # explanation that holds on held-out data; the baseline where none does
    singles: list[Tested]  # running free, best first
    pairs: list[Tested]
    pinned: list[Tested]  # every term at first sight
    excluded: list[str]  # terms whose derivatives are not finite
    false_alarm_rate: Annotated[float, "1"]
    power: Annotated[float, "1"]
    inclusion: Annotated[float | None, "1"]  # share of resamples that give the same answer
    sensors: list[SensorError]
    before: FitResult  # of Eq. 9 alone
    after: FitResult | None = None  # with what was found; None where nothing was
    # share of the weight of all explanations that those hold which have what is named, or the best
    weight: Annotated[float | None, "1"] = None
    suspected: list[Suspect] = field(default_factory=list)  # what it may be, where more than one
    advice: list[str] = field(default_factory=list)
    twins: list[Parameter] = field(default_factory=list)  # of what would look exactly alike
    but_ends: bool = False  # is nothing missing but where movements begin or end?
    # names of causes that all have which explain it, where what acts besides is open
    in_all: list[str] = field(default_factory=list)
    # None where it was read from a file
    workings: Workings | None = field(default=None, metadata={"saved": False})

    def __repr__(self) -> str:
        return summary.lines(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    @property
    def fit(self) -> FitResult:
        """The fit to use: with what was found, or of Eq. 9 where nothing was."""
        return self.before if self.after is None else self.after

    @property
    def selected(self) -> list[str]:
        """The names of what is missing."""
        return [each.name for each in self.findings]

    @property
    def changed(self) -> bool:
        """Was anything added to the model?"""
        return bool(self.best.terms)

    @property
    def follows(self) -> bool:
        """Does the model follow the recording, as it is or with what was found?"""
        return self.fit.follows or (
            self.changed and roughly(self.proof.after.total, self.before.segments)
        )

    @property
    def explained(self) -> bool:
        """Is what the best explanation leaves hardly more than noise?"""
        return self.best.mean_square < UNEXPLAINED


def just_made(found: Diagnosis) -> Workings:
    """What a diagnosis rests on that was not read from a file."""
    assert found.workings is not None
    return found.workings
