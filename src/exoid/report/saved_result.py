"""A fit with where it came from, as it is kept in one file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from exoid.diagnose.identifiability import Identifiability
from exoid.fit.result import FitResult

FORMAT = "exoid fit"
FORMAT_VERSION = 1  # of the layout of the file; another one is not read


@dataclass(frozen=True, eq=False)
class SavedResult:
    """What `save_result` keeps. `result` has no `basis`: it prints and compares, but to ask further
    (profiles, posterior, plan) takes the fit itself.
    """

    result: FitResult
    told: Identifiability | None  # None where it was not asked
    version: str  # of exoid
    recordings: Sequence[Mapping[str, Any]]  # path, sha256 and segments of every file
    settings: Mapping[str, Any]  # what the user asked for, the seed included
