"""Named arrays as a table: what MATLAB, NumPy and Python hold in memory."""

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from exoid.recordings.tables.names import main_size
from exoid.recordings.tables.sheet import Column, Place, Sheet, listed, printable
from exoid.recordings.tables.trials import below_each_other
from exoid.recordings.tables.units import parted

RATES = {"fs", "rate", "sample_rate", "samplerate", "sampling_rate", "samplingrate", "freq",
         "frequency", "framerate", "frame_rate", "sf"}  # fmt: skip
DEEPEST = 8  # structs within structs


def sheet_of_arrays(arrays: Mapping[str, Any], place: Place, wanted: Collection[str] = ()) -> Sheet:
    """The vectors of one length: that of the time, else that of most; of those `wanted`, if any.

    A matrix is taken column by column, `data(:,2)` as `data.2`; a struct by its fields, `trial.t`;
    trials in numbered structs one below the other, unless one of them is `wanted` by its name.

    **Raises** `ValueError` where there is no vector of numbers.
    """
    flat = [(name, value) for name, value in flattened(arrays) if value is not None]
    rates = [
        float(value.reshape(-1)[0])
        for name, value in flat
        if value.size == 1 and value.dtype.kind in "iuf" and name.split(".")[-1].lower() in RATES
    ]
    vectors = [column for name, value in flat for column in columns_of(name, value)]
    if not vectors:
        names = listed([name for name, _ in flat]) or "nothing"
        raise ValueError(f"holds no vector of numbers. It holds: {names}.")
    named = [each for each in vectors if each.name in wanted]
    vectors, said = (vectors, ()) if named else below_each_other(vectors)
    size = main_size(named or vectors)
    others = [each.name for each in vectors if len(each.cells) != size]
    notes = (*said, f"of other lengths, not read: {listed(others)}.") if others else said
    alike = tuple(each for each in vectors if len(each.cells) == size)
    return Sheet(alike, place, rate=rates[0] if rates and rates[0] > 0 else None, notes=notes)


def flattened(
    arrays: Mapping[str, Any], prefix: str = "", depth: int = 0
) -> Iterator[tuple[str, Any]]:
    """Every array under its path."""
    for key, value in arrays.items():
        name = f"{prefix}{printable(key)}"
        if isinstance(value, Mapping):
            if depth < DEEPEST:
                yield from flattened(value, f"{name}.", depth + 1)
        elif structs := structs_in(value):
            yield from flattened(structs, name, depth)
        elif (array := as_array(value)).dtype.names:
            parts = {field: array[field] for field in array.dtype.names}
            yield from flattened(parts, f"{name}." if array.ndim == 1 and prefix else "", depth + 1)
        else:
            yield name, array


def structs_in(value: Any) -> dict[str, Mapping[str, Any]]:
    """By their numbers in MATLAB, the structs of an array or of a cell; none of anything else."""
    each = value.tolist() if isinstance(value, np.ndarray) and value.dtype == object else value
    if not isinstance(each, list) or not all(isinstance(one, Mapping) for one in each):
        return {}
    return {f"({number})": one for number, one in enumerate(each, 1)}


def as_array(value: Any) -> np.ndarray:
    """Anything that holds one value a sample: lists, Series, tensors."""
    try:
        return np.asarray(value)
    except (ValueError, TypeError):  # a ragged list
        return np.empty(0)


def columns_of(name: str, value: np.ndarray) -> list[Column]:
    """A vector, or the columns of a matrix, whichever way it lies."""
    if value.ndim == 2 and 1 in value.shape:
        value = value.reshape(-1)
    if value.ndim == 1:
        return (
            [Column(name, cells, parted(name)[1])] if (cells := cells_of(value)) is not None else []
        )
    if value.ndim != 2 or value.dtype.kind not in "iuf":
        return []
    tall = value if value.shape[0] >= value.shape[1] else value.T
    return [
        Column(f"{name}.{number}", np.asarray(column, np.float64))
        for number, column in enumerate(tall.T, 1)
    ]


def cells_of(vector: np.ndarray):
    """Numbers, or the texts of dates and words; None for anything else."""
    if vector.size < 2:
        return None
    if vector.dtype.kind in "iufb":
        return vector.astype(np.float64)
    if vector.dtype.kind == "m":
        return vector / np.timedelta64(1, "s")
    if vector.dtype.kind in "MUS":
        return tuple(str(cell) if cell == cell else "" for cell in vector.astype(str).tolist())
    if vector.dtype.kind == "O":
        return mixed(vector.tolist())
    return None


def mixed(cells: list[Any]):
    """Python objects: numbers and None, or words."""
    try:
        numbers = [np.nan if each is None else float(each) for each in cells]
    except (TypeError, ValueError):
        plain = all(isinstance(each, str | None | float) for each in cells)
        return tuple(str(each or "") if each == each else "" for each in cells) if plain else None
    return np.array(numbers, dtype=np.float64)
