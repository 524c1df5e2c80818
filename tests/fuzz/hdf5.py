"""HDF5 as pyfive reads it, which is written in Python and shares no line with the HDF5 library."""

import json
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.sheet import Place

from .reading import Rows, Sample
from .tables import numbers_of


def variables_by_pyfive(path: Path) -> Rows:
    """The variables of a .mat of version 7.3."""
    arrays = dict(below(opened(path), ""))
    return numbers_of(sheet_of_arrays(arrays, Place("sample")))


def opened(path: Path) -> Any:
    """From memory: from disk pyfive passes over the block in front of MATLAB's HDF5."""
    import pyfive

    return pyfive.File(BytesIO(path.read_bytes()))


def below(group: Any, prefix: str) -> Iterator[tuple[str, np.ndarray]]:
    import pyfive

    for name in group:
        item = group[name]
        if isinstance(item, pyfive.Group):
            yield from below(item, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", np.asarray(item[()]).T


def values_by_pyfive(path: Path, _sample: Sample) -> Rows:
    """What the fuzzer's small result holds."""
    file = opened(path)
    title, count = json.loads(file.attrs["title"]), np.asarray(file.attrs["count"]).item()
    return {"values": file["values"][()], "title": np.array(title, str), "count": np.array(count)}
