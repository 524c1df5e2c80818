"""Directions in which parameters can move together: without any trace, or with hardly any."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from exoid.fitting.misfit.uncertainty import HELD, Information, determined, inverse_times
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.trust.identifiability import Changes, Direction

SHIFT = 0.10  # relative change by which an exact direction is put into words
TRACE = 1e-3  # of the largest change along a direction; smaller ones are rounding
VISIBLE = 0.05  # of the largest change; smaller ones are left out of the words
GONE = 1.0  # relative change from which on a value may as well be none
NONE_TOLD: Mapping[str, Estimate] = MappingProxyType({})
WEAK = 0.05  # relative standard error from which on a combination counts as hardly told


def null_directions(
    gradients: dict[str, np.ndarray], alone: Information, symbols: dict[str, str]
) -> list[Direction]:
    """The directions in which the parameters move and no sample does.

    The two that hold for every leg come first, as far as this recording leaves them open; what
    else is open is given as it is found.
    """
    values, vectors = np.linalg.eigh(alone.parts[0])
    free = vectors[:, ~determined(values)]
    names = [name for name in gradients if name not in RATIOS]
    moved = np.stack([gradients[name] for name in names]) @ free
    exchange = np.array([{"mass": 1.0, "com_distance": -1.0}.get(name, 0.0) for name in names])
    scaling = np.array([float(name != "com_distance") for name in names])
    found = [pattern for pattern in (exchange, scaling) if within(moved, pattern)]
    rest = moved
    if found:
        known = np.stack(found, axis=1)
        rest = moved - known @ np.linalg.lstsq(known, moved, rcond=None)[0]
    left, sizes, _ = np.linalg.svd(rest, full_matrices=False)
    found += list(left[:, sizes > TRACE].T)
    return [exact(dict(zip(names, map(float, p), strict=True)), symbols) for p in found]


def within(moved: np.ndarray, pattern: np.ndarray) -> bool:
    """Does the null space move the parameters in this pattern?"""
    along = np.linalg.lstsq(moved, pattern, rcond=TRACE)[0]  # rounding moves nothing
    return bool(np.abs(moved @ along - pattern).max() < TRACE)


def exact(changes: Changes, symbols: dict[str, str]) -> Direction:
    words = f"{in_words(changes, SHIFT, symbols)}: the motion stays exactly the same"
    if {name for name, change in changes.items() if change} == {"mass", "com_distance"}:
        return Direction(changes, np.inf, f"{words}; no motion about a fixed axis tells m from l.")
    return Direction(changes, np.inf, f"{words}.")


def weak_directions(
    gradients: dict[str, np.ndarray],
    told: dict[str, Estimate],
    alone: Information,
    symbols: dict[str, str],
) -> list[Direction]:
    """Directions among the combinations along which the data leave more than WEAK, relative."""
    names = [name for name in told if name in gradients and told[name].shares != HELD]
    if not names:
        return []
    rows = np.stack([gradients[name] for name in names])
    covariance = rows @ np.stack([inverse_times(alone.likelihood, row) for row in rows], axis=1)
    sizes, axes = np.linalg.eigh(covariance)
    found = []
    for size, axis in zip(sizes[::-1], axes.T[::-1], strict=True):
        error = float(np.sqrt(max(size, 0.0)))
        if error > WEAK:
            changes = dict(zip(names, map(float, axis), strict=True))
            step = error * max(map(abs, changes.values()))
            room = in_words(changes, step, symbols, told)
            words = f"this recording hardly tells: {room} fits nearly as well."
            found.append(Direction(changes, error, words))
    return found


def in_words(
    changes: Changes, step: float, symbols: dict[str, str], told: Mapping[str, Estimate] = NONE_TOLD
) -> str:
    """The changes where the largest is `step`: what goes up and down, by how much.

    Of what is `told` and may as well be gone, or twice as large, no share is said but how large it
    may be.
    """
    largest = max(changes.values(), key=abs)
    steps = {name: step * change / largest for name, change in changes.items()}
    groups: dict[str, list[str]] = {}
    for name, each in sorted(steps.items(), key=lambda item: -abs(item[1])):
        if abs(each) > VISIBLE * step:
            move = size(told[name], each) if name in told and abs(each) >= GONE else share(each)
            groups.setdefault(move, []).append(symbols[name])
    return ", ".join(f"{listed(each)} {move}" for move, each in groups.items())


def share(change: float) -> str:
    """Of a value, to two digits: 3200 and not 3.2e+03."""
    return f"{'up' if change > 0 else 'down'} {float(f'{100 * abs(change):.2g}'):g} %"


def size(each: Estimate, change: float) -> str:
    """How large it is after a change by more than itself."""
    most = abs(each.value or 0.0) * (1 + abs(change))
    return f"of any size up to {most:.2g} {each.unit}"


def listed(words: list[str]) -> str:
    """a, b and c."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
