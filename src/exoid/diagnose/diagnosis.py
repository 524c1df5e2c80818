"""The answer of a diagnosis."""

from dataclasses import dataclass, field
from typing import Literal

from exoid.diagnose.bench import Bench
from exoid.diagnose.consistency import SensorError
from exoid.diagnose.evidence import Yardstick
from exoid.diagnose.formula import Formula
from exoid.diagnose.locate import Location
from exoid.diagnose.proof import Proof
from exoid.diagnose.search import Found
from exoid.diagnose.settle import Settled
from exoid.fit.result import FitResult
from exoid.physics.library import name_of

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


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """The answer, and what it rests on."""

    verdict: Verdict
    reasons: list[str]  # why not more could be said
    selected: list[str]
    ranking: list[str]
    equivalent: list[str]
    novel: bool  # does something act that the library does not know
    formula: Formula | None  # of it
    parameters: list[Parameter]
    booked: list[Booked]
    location: Location
    proof: Proof
    false_alarm_rate: float
    power: float
    inclusion: float | None  # share of resampled segments that give the same answer
    sensors: list[SensorError]
    best: Settled
    found: Found
    bench: Bench
    fit: FitResult
    advice: list[str] = field(default_factory=list)

    @property
    def excluded(self) -> list[str]:
        """Terms whose derivatives are not finite."""
        return [name_of(term) for term in self.found.failed]

    @property
    def yardstick(self) -> Yardstick:
        return self.found.yardstick
