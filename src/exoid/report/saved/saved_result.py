"""A fit with what else was found and where it came from, as it is kept in one file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from exoid.fitting.errors.profile import Profile
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.planning.plan import Plan
from exoid.report.parts.case import Origin
from exoid.trust.identifiability import Identifiability

FORMAT = "exoid fit"
FORMAT_VERSION = 2  # of the layout of the file; another one is not read
APART = ("fit", "workings")  # of a diagnosis: the fit has its own groups, workings are not kept


@dataclass(frozen=True, eq=False)
class SavedResult:
    """What `save_result` keeps; None where it was not asked, or not saved.

    `result` has no `basis` and `diagnosis` no `workings`: they print, draw and compare, but to ask
    further (profiles, posterior, plan) takes the fit itself.
    """

    result: FitResult
    told: Identifiability | None
    version: str  # of exoid
    recordings: Sequence[Mapping[str, Any]]  # path, sha256 and segments of every file
    settings: Mapping[str, Any]  # what the user asked for, the seed included
    profiles: Mapping[str, Profile] | None = None
    diagnosis: Diagnosis | None = None
    plan: Plan | None = None
    origin: Origin | None = None
