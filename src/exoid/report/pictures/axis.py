"""What an axis shows and how its numbers read: limits that keep to the point, short numbers."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.report.pictures.panel import Axis, Range
from exoid.report.words.text import DIMENSIONLESS, exponent

GROWN = 3.0  # times what must be seen, at most
MARGIN = 0.06  # of the view, at either end
CLOSE = 2e-2  # relative half width below which ticks would need more than three digits
PLAIN = (1e-2, 1e4)  # sizes that are read without a power of ten


@dataclass(frozen=True)
class Scale:
    """Ticks count units of 10^power from `origin`, and the label says so."""

    origin: float = 0.0
    power: int = 0
    decimals: int = 0  # of the origin

    def of(self, values):
        return (np.asarray(values, dtype=float) - self.origin) / 10.0**self.power

    def axis(self, name: str, unit: str, seen: Range) -> Axis:
        """name - origin [10^power unit]."""
        power = f"1e{self.power}" if self.power else ""
        unit = unit if not power else power if unit in DIMENSIONLESS else f"{power} {unit}"
        sign = "-+"[self.origin < 0]
        origin = f" {sign} {abs(self.origin):.{self.decimals}f}" if self.origin else ""
        low, high = self.of(seen).tolist()
        return Axis(f"{name}{origin}", unit, (low, high))


def readable(view: Range, centre: float) -> Scale:
    """Deviations from the centre where the view is narrow, a power of ten where the size asks."""
    half, size = (view[1] - view[0]) / 2, max(map(abs, view))
    if half < CLOSE * size:
        digits = 1 - exponent(half)
        return Scale(round(centre, digits), power_of(half), max(digits, 0))
    return Scale(power=power_of(size))


def power_of(size: float) -> int:
    """Zero where the size is read without."""
    return 0 if PLAIN[0] <= size < PLAIN[1] or size == 0 else exponent(size)


def view(needed: list[float], others: Float[np.ndarray, " value"], grown: float = GROWN) -> Range:
    """All that is needed; of the others what lies near enough not to dwarf it: the view is at most
    `grown` times what is needed.
    """
    low, high = min(needed or others), max(needed or others)
    spare = (grown - 1) * (high - low) if high > low else np.inf
    below, above = low - min([low, *others]), max([high, *others]) - high
    if below + above > spare:
        below, above = (
            min(below, max(spare / 2, spare - above)),
            min(above, max(spare / 2, spare - below)),
        )
    low, high = low - below, high + above
    margin = MARGIN * (high - low) or MARGIN * abs(high) or 1.0
    return float(low - margin), float(high + margin)
