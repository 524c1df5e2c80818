"""Named arrays on their way from the process that read them: numbers and words, no objects."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays

NAMES = "names"


def packed(arrays: Mapping[str, Any]) -> Arrays:
    """Under numbers, since a name may be anything; what is neither number nor word is empty."""
    plain = [np.asarray(each) for each in arrays.values()]
    safe = [each if each.dtype.kind in "biufUSmM" else np.empty(0) for each in plain]
    return {NAMES: np.array([*arrays], dtype=str)} | {str(at): each for at, each in enumerate(safe)}


def unpacked(arrays: Arrays) -> dict[str, np.ndarray]:
    return {str(name): arrays[str(at)] for at, name in enumerate(arrays[NAMES])}
