"""Two saved results side by side: what differs, and by how many standard errors."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot
from typing import Any

from exoid.fitting.errors.profile import named
from exoid.fitting.result.fit_result import Estimate
from exoid.physics.term import name_of
from exoid.report.saved.saved_result import SavedResult

ABSENT = "not told"
HASHED = 12  # digits of a hash that are shown


@dataclass(frozen=True)
class ComparedQuantity:
    """One quantity of both; None where a fit does not have it, or does not tell it."""

    name: str
    symbol: str
    unit: str
    first: Estimate | None
    second: Estimate | None

    @property
    def each(self) -> list[Estimate]:
        """The sides that there are."""
        return [one for one in (self.first, self.second) if one is not None]

    @property
    def values(self) -> list[float]:
        """Those that are told."""
        return [one.value for one in self.each if one.value is not None]

    @property
    def difference(self) -> float | None:
        """The second less the first."""
        return self.values[1] - self.values[0] if len(self.values) == 2 else None

    @property
    def by_prior(self) -> bool:
        """Did the prior set it in both fits?"""
        return [one.determined_by for one in self.each] == ["prior", "prior"]

    @property
    def standard_errors(self) -> float | None:
        """The difference over the error of a difference of independent fits."""
        errors = [one.standard_error for one in self.each if one.standard_error is not None]
        if self.difference is None or len(errors) < 2 or not hypot(*errors) > 0:
            return None
        return self.difference / hypot(*errors)


@dataclass(frozen=True)
class Comparison:
    """What two fits say of the same quantities, and what was asked of them."""

    quantities: list[ComparedQuantity]
    settings: dict[str, tuple[str, str]]  # those that differ
    same_recordings: bool


def compare(first: SavedResult, second: SavedResult) -> Comparison:
    """Parameters, torque amplitude and ratios of both, and the settings that differ."""
    one, other = dict(named(first.result)), dict(named(second.result))
    rows = []
    for name in {**one, **other}:
        known = one.get(name) or other[name]
        rows.append(
            ComparedQuantity(name, known.symbol, known.unit, one.get(name), other.get(name))
        )
    same = hashes(first) == hashes(second) != []
    differ = changed(asked(first), asked(second))
    if not same:  # then the sidecars are others by nature
        differ.pop("sidecars", None)
    if (first.diagnosis is None) != (second.diagnosis is None):  # each command has its options
        differ = {name: pair for name, pair in differ.items() if ABSENT not in pair}
    return Comparison(rows, differ, same)


def asked(saved: SavedResult) -> dict[str, Any]:
    """What a fit rests on besides its recordings."""
    result = saved.result
    sidecars = [str(each.get("sidecar_sha256"))[:HASHED] for each in saved.recordings]
    return {
        "exoid": saved.version,
        **saved.settings,
        "terms": ", ".join(name_of(type(each)) for each in result.fitted_terms) or None,
        "sidecars": ", ".join(sidecars),
        "prior taken": result.prior,
        "torque frequency found": result.torque_frequency,
    }


def changed(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, tuple[str, str]]:
    """The entries that differ, as text; one that a fit was saved without is not told."""
    return {
        name: (shown(one.get(name, ABSENT)), shown(other.get(name, ABSENT)))
        for name in {**one, **other}
        if one.get(name, ABSENT) != other.get(name, ABSENT)
    }


def shown(value: Any) -> str:
    return "none" if value is None else str(value)


def hashes(saved: SavedResult) -> list[str]:
    """Which recordings they were, whatever they were called and in whatever order."""
    return sorted(str(each["sha256"]) for each in saved.recordings)
