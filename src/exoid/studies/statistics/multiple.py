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


def corrected(raw: Sequence[float], correction: Correction) -> list[float]:
    """Of each p what it is among all; NaN stays, and counts for none."""
    found, asked = np.array(raw, dtype=float), np.isfinite(raw)
    if asked.any():
        found[asked] = multipletests(found[asked], method=METHODS[correction])[1]
    return found.tolist()
