"""Do two saved results look like one leg?"""

from collections.abc import Callable

from exoid.report.saved.saved_result import SavedResult
from exoid.report.tables.compare import ComparedQuantity, Comparison
from exoid.trust.legs import COMMON, LARGE, SURPRISE

FAR = 20.0  # errors, from which on their number says nothing more


def strangers(found: Comparison, sides: list[SavedResult]) -> list[str]:
    """Sentences on what tells that they are not; none of one recording that was analysed twice."""
    if found.same_recordings:
        return []
    told = [*differing("people", names, sides), *differing("legs", legs, sides)]
    said = [*told, *differing("bodies", bodies, sides)]
    if told:  # legs that are known to be two may differ
        return said
    apart = [each for each in found.quantities if each.name in COMMON and far_apart(each)]
    if apart:
        worst = max(apart, key=lambda each: abs(each.standard_errors or 0.0))
        values = " and ".join(f"{value:.3g}" for value in worst.values)
        said.append(
            f"They do not look like one leg, or it changed: {worst.symbol} = {values} "
            f"{worst.unit}, {how_far(abs(worst.standard_errors or 0.0))}."
        )
    return said


def differing(
    what: str, of: Callable[[SavedResult], list[str]], sides: list[SavedResult]
) -> list[str]:
    """That the sidecars tell of two, where both tell."""
    one, other = (" and ".join(of(side)) for side in sides)
    if not (one and other) or one == other:
        return []
    return [f"The recordings are of different {what}: {one}, against {other}."]


def how_far(errors: float) -> str:
    """How many errors apart, as long as that is a number for a person."""
    if errors > FAR:
        return "farther apart than errors can be"
    return f"{errors:.0f} standard errors apart"


def names(saved: SavedResult) -> list[str]:
    """Everybody that was recorded, by the id of the sidecar."""
    each = [(one.get("subject") or {}).get("id") for one in saved.recordings]
    return list(dict.fromkeys(str(one) for one in each if one))


def legs(saved: SavedResult) -> list[str]:
    """The legs that were recorded, by the side of the sidecar."""
    each = [(one.get("subject") or {}).get("side") for one in saved.recordings]
    return list(dict.fromkeys(str(one) for one in each if one))


def bodies(saved: SavedResult) -> list[str]:
    """Mass and height of everybody that was recorded, where they are known."""
    each = [(one.get("body_mass_kg"), one.get("height_m")) for one in saved.recordings]
    return list(dict.fromkeys(f"{mass:g} kg, {tall:g} m" for mass, tall in each if mass and tall))


def far_apart(each: ComparedQuantity) -> bool:
    """By the rule for recordings that are fitted together, of one ratio at a time."""
    errors = each.standard_errors
    if each.difference is None or errors is None or errors**2 < SURPRISE:
        return False
    size = sum(map(abs, each.values)) / 2
    return abs(each.difference) > LARGE * size
