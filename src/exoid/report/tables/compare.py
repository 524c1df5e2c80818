"""Two saved results side by side: what differs, and by how many standard errors."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot
from typing import Any

from exoid.fitting.result.estimates.estimate import RIVALS, Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.fitting.result.remarks.zero.leaning import BENT
from exoid.fitting.result.remarks.zero.slack_angle import TOLD
from exoid.physics.term import name_of
from exoid.report.saved.saved_result import SavedResult

ABSENT = "not told"
WITH_INERTIA = ("mass", "inertia", "com_distance", "gravity_moment", "torque_amplitude")
ANEW = TOLD / BENT  # of what the slack angle leaves open, that one leg has anew in every session
HASHED = 12  # digits of a hash that are shown


@dataclass(frozen=True)
class ComparedQuantity:
    """One quantity of both; None where a fit does not have it, or does not tell it."""

    name: str
    symbol: str
    unit: str
    first: Estimate | None
    second: Estimate | None
    assumed: bool = False  # it goes with a J that neither recording tells
    one_leg: bool = False  # whose spring is slack at the same angle in both

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
    def error(self) -> float | None:
        """Of the difference, of independent fits with what a spring slack elsewhere leaves open; of
        what is assumed alike, the difference is no finding and has none.
        """
        errors = [one.standard_error for one in self.each if one.standard_error is not None]
        if self.assumed or self.difference is None or len(errors) < 2:
            return None
        return hypot(*errors, *self.slack) or None

    @property
    def slack(self) -> tuple[float, ...]:
        """What a spring slack elsewhere leaves open of it. Both sides of one leg are off
        alike, but for as much as its slack angle is anew in every session.
        """
        first, second = (slack_of(one) for one in self.each)
        return (second - first, ANEW * first, ANEW * second) if self.one_leg else (first, second)

    @property
    def standard_errors(self) -> float | None:
        """The difference over its error."""
        if self.difference is None or self.error is None:
            return None
        return self.difference / self.error


@dataclass(frozen=True)
class Comparison:
    """What two fits say of the same quantities, and what was asked of them."""

    quantities: list[ComparedQuantity]
    settings: dict[str, tuple[str, str]]  # those that differ
    same_recordings: bool


def slack_of(each: Estimate) -> float:
    """What a spring slack elsewhere leaves open, where errors of a diagnosis do not hold it."""
    return 0.0 if RIVALS in (each.limited_by or {}) else each.if_slack or 0.0


def legs(saved: SavedResult) -> set[tuple[Any, Any]]:
    """Whose legs were recorded, by the id and side of the sidecars; an id that is None is nobody's
    name.
    """
    each = [one.get("subject") or {} for one in saved.recordings]
    return {(one.get("id"), one.get("side")) for one in each}


def is_one_leg(first: SavedResult, second: SavedResult) -> bool:
    """Do the sidecars say that both are of one leg?"""
    both = legs(first) | legs(second)
    return len(both) == 1 and all(name is not None for name, _ in both)


def quantities_of(result: FitResult) -> dict[str, Estimate]:
    """What a fit has a number for, if it follows its recording."""
    result = without_numbers(result)
    torque = result.torque_amplitude
    tau = {} if torque is None else {"torque_amplitude": torque}
    return {**result.of_leg, **tau, **result.ratios, **result.of_terms}


def goes_with_inertia(name: str, every: Mapping[str, Estimate]) -> bool:
    """Is it as large as J is taken to be, so that only its ratio is compared?"""
    scaled = any(f"{name}_{goes}_inertia" in every for goes in ("over", "times"))
    return scaled or name in WITH_INERTIA


def assumes_inertia(result: FitResult) -> bool:
    """Did no recording tell J?"""
    return result.parameters["inertia"].determined_by not in ("data", "both")


def compare(first: SavedResult, second: SavedResult) -> Comparison:
    """Parameters, torque amplitude and ratios of both, and the settings that differ."""
    one, other = (quantities_of(each.result) for each in (first, second))
    alike = all(assumes_inertia(each.result) for each in (first, second))
    one_leg = is_one_leg(first, second)
    rows = []
    for name in {**one, **other}:
        known, sides = one.get(name) or other[name], (one.get(name), other.get(name))
        assumed = alike and goes_with_inertia(name, one | other)
        rows.append(ComparedQuantity(name, known.symbol, known.unit, *sides, assumed, one_leg))
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
