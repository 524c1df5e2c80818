"""A fit with what else was found and where it came from, as it is kept in one file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

from exoid.fitting.errors.profile import Profile
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.physics.term import Term
from exoid.planning.planned import Plan
from exoid.report.parts.origin import Origin
from exoid.report.saved.document import read, write
from exoid.report.saved.node import DocumentError
from exoid.trust.identifiability import Identifiability


@dataclass(frozen=True, eq=False)
class SavedResult:
    """What `save_result` keeps; None where it was not asked, or not saved.

    `result` has no `basis` and `diagnosis` no `workings`: they print, draw and compare, but to ask
    further (profiles, posterior, plan) takes the fit itself.

    >>> exoid.save_result(exoid.fit("drops.csv"), "fit.nc", settings={"who": "me"})
    >>> exoid.load_result("fit.nc").settings["who"]
    'me'
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


def save_result(
    result: FitResult,
    path: str | Path,
    *,
    told: Identifiability | None = None,
    recordings: Sequence[Mapping[str, Any]] = (),
    settings: Mapping[str, Any] | None = None,
    **found: Any,
) -> None:
    """Write a fit to netCDF, or to JSON (.json), in full or not at all; `load_result` reads both.

    `found` is what else a `SavedResult` has: `profiles`, `diagnosis` (of this fit), `plan`,
    `origin`. `recordings` has path, sha256 and segments of every file; `settings` what was asked.

    >>> result = exoid.fit("drops.csv")
    >>> exoid.save_result(result, "fit.nc", told=exoid.identify(result))
    """
    about = (version("exoid"), recordings, settings or {})
    write(SavedResult(result, told, *about, **found), Path(path))


def load_result(path: str | Path, *, terms: Sequence[type[Term]] = ()) -> SavedResult:
    """What `save_result`, `exoid fit --save` or `exoid diagnose --save` wrote.

    `terms` are a user's own, as a diagnosis was given them.

    **Raises** `ValueError` (one line) where the file is another one, or not as it was saved;
    `OSError` where there is none.

    >>> exoid.save_result(exoid.fit("drops.csv"), "fit.json")
    >>> exoid.load_result("fit.json").result.follows
    True
    """
    path = Path(path)
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file in it.")
    try:
        found = read(SavedResult, path, own=terms)
    except DocumentError as fault:
        raise ValueError(f"{path}: {fault}") from fault
    return replace(found, result=without_numbers(found.result))
