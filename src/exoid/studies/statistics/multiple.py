"""Several tests at once: how small a p is by chance somewhere among them."""

from collections.abc import Callable, Sequence
from typing import Literal

import numpy as np
from scipy.stats import false_discovery_control

Correction = Literal["holm", "benjamini-hochberg"]
WORDS: dict[Correction, str] = {
    "holm": "Holm: the chance of any false finding among all stays below 5 %",
    "benjamini-hochberg": "Benjamini-Hochberg: of what is found, 5 % on average is false",
}


COPIES = {"normalised_relaxation_index": "relaxation_index"}  # but for a factor


def tested_as(quantities: Sequence[str]) -> list[int]:
    """Of each the place of that whose test it has: its own, or that of which it is a copy."""
    place = {each: at for at, each in enumerate(quantities)}
    return [place.get(COPIES.get(each, ""), at) for at, each in enumerate(quantities)]


def corrected(raw: Sequence[float], correction: Correction) -> list[float]:
    """Of each p what it is among all; NaN stays, and counts for none."""
    found, asked = np.array(raw, dtype=float), np.isfinite(raw)
    found[asked] = CORRECTED[correction](found[asked])
    return found.tolist()


def holm(raw: np.ndarray) -> np.ndarray:
    """Holm (1979): the k-th smallest of n times n + 1 - k, and none below a smaller one's."""
    order = np.argsort(raw)
    found = np.empty_like(raw)
    found[order] = np.maximum.accumulate(np.arange(len(raw), 0, -1) * raw[order]).clip(max=1.0)
    return found


CORRECTED: dict[Correction, Callable[[np.ndarray], np.ndarray]] = {
    "holm": holm,
    "benjamini-hochberg": false_discovery_control,
}
