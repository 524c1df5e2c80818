"""Several tests at once: how small a p is by chance somewhere among them."""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from statsmodels.stats.multitest import multipletests

Correction = Literal["holm", "benjamini-hochberg"]
METHODS: dict[Correction, str] = {"holm": "holm", "benjamini-hochberg": "fdr_bh"}
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
    if asked.any():
        found[asked] = multipletests(found[asked], method=METHODS[correction])[1]
    return found.tolist()
