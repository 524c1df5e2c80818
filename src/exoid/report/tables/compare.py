"""Two saved results side by side: what differs, and by how many standard errors."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot
from typing import Any

from exoid.fitting.result.fit_result import Estimate
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
    def difference(self) -> float | None:
        """The second less the first."""
        if self.first is None or self.second is None:
            return None
        if self.first.value is None or self.second.value is None:
            return None
        return self.second.value - self.first.value

    @property
    def by_prior(self) -> bool:
        """Did the prior set it in both fits?"""
        each = [one for one in (self.first, self.second) if one is not None]
        return len(each) == 2 and all(one.determined_by == "prior" for one in each)

    @property
    def standard_errors(self) -> float | None:
        """The difference over the error of a difference of independent fits."""
        if self.difference is None or self.first is None or self.second is None:
            return None
        one, other = self.first.standard_error, self.second.standard_error
        if one is None or other is None or not hypot(one, other) > 0:
            return None
        return self.difference / hypot(one, other)


@dataclass(frozen=True)
class Comparison:
    """What two fits say of the same quantities, and what was asked of them."""

    quantities: list[ComparedQuantity]
    settings: dict[str, tuple[str, str]]  # those that differ
    same_recordings: bool


def compare(first: SavedResult, second: SavedResult) -> Comparison:
    """Parameters, torque amplitude and ratios of both, and the settings that differ."""
    one, other = quantities(first), quantities(second)
    names = [*one, *(name for name in other if name not in one)]
    rows = []
    for name in names:
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


def quantities(saved: SavedResult) -> dict[str, Estimate]:
    """Everything that two fits of a leg have in common."""
    result = saved.result
    torque = (
        {} if result.torque_amplitude is None else {"torque_amplitude": result.torque_amplitude}
    )
    return {**result.parameters, **torque, **result.ratios, **result.of_terms}


def asked(saved: SavedResult) -> dict[str, Any]:
    """What a fit rests on besides its recordings."""
    result = saved.result
    sidecars = [str(each.get("sidecar_sha256"))[:HASHED] for each in saved.recordings]
    return {
        "exoid": saved.version,
        **saved.settings,
        "sidecars": ", ".join(sidecars),
        "prior taken": result.prior,
        "torque frequency found": result.torque_frequency,
    }


def changed(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, tuple[str, str]]:
    """The entries that differ, as text; one that a fit was saved without is not told."""
    names = [*one, *(name for name in other if name not in one)]
    return {
        name: (shown(one.get(name, ABSENT)), shown(other.get(name, ABSENT)))
        for name in names
        if one.get(name, ABSENT) != other.get(name, ABSENT)
    }


def shown(value: Any) -> str:
    return "none" if value is None else str(value)


def hashes(saved: SavedResult) -> list[str]:
    """Which recordings they were, whatever they were called and in whatever order."""
    return sorted(str(each["sha256"]) for each in saved.recordings)
