"""MATLAB's .mat: version 7 and older by SciPy, version 7.3, which is HDF5, by h5py."""

from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays, read_apart
from exoid.recordings.formats.matlab_parts import check_parts
from exoid.recordings.formats.packed import packed, unpacked
from exoid.recordings.tables.arrays import flattened, sheet_of_arrays
from exoid.recordings.tables.sheet import Place, Sheet

HDF5 = b"\x89HDF\r\n\x1a\n"
USER_BLOCK = 512  # bytes that MATLAB writes before the HDF5
OPAQUE = ("__function_workspace__", "#subsystem#")  # where MATLAB keeps what only it reads
DEEPEST = 8  # structs within structs


def read_matlab(path: Path, wanted: Collection[str] = ()) -> Sheet:
    """The vectors of one length, in variables and in structs, `wanted` by their names or not.

    **Raises** `ValueError` where there are none; a `table` or `timetable` of MATLAB cannot be read.
    """
    arrays = unpacked(read_apart(variables, path, "Save it again from MATLAB.", library="scipy.io"))
    plain = {name: each for name, each in arrays.items() if name[:1] not in "_#"}
    if any(name.startswith(OPAQUE) for name in arrays) and not any(
        each.size > 1 for each in plain.values()
    ):
        raise ValueError(
            "holds a table or another object that only MATLAB reads. Save its columns as arrays, "
            "or write it with writetable(T, 'name.csv') or parquetwrite."
        )
    return sheet_of_arrays(plain, Place("sample"), wanted)


def variables(path: Path) -> Arrays:
    """Every array under its path, such as `trial.time`; in a process of its own."""
    with path.open("rb") as file:
        head = file.read(USER_BLOCK + len(HDF5))
    hdf5 = head[USER_BLOCK:] == HDF5 or head.startswith(HDF5)
    if hdf5:
        import h5py

        with h5py.File(path, "r") as content:
            return packed(dict(held(content, "", 0)))
    import scipy.io

    check_parts(path.read_bytes())
    return packed(dict(flattened(scipy.io.loadmat(str(path), simplify_cells=True))))


def held(group: Any, prefix: str, depth: int) -> Iterator[tuple[str, Any]]:
    """What a group holds: structs are groups; text and what refers elsewhere are empty."""
    import h5py

    for name in group:
        link = group.get(name, getlink=True)
        if name == "#refs#" or isinstance(link, h5py.SoftLink | h5py.ExternalLink):
            continue  # MATLAB's own, or elsewhere
        item = group[name]  # `get` would say nothing of one that is damaged
        if isinstance(item, h5py.Group):
            yield f"{prefix}{name}", np.empty(0)
            if depth < DEEPEST:
                yield from held(item, f"{prefix}{name}.", depth + 1)
        elif isinstance(item, h5py.Dataset):
            words = item.attrs.get("MATLAB_class", b"") in (b"char", "char")
            if item.dtype.kind == "f" and item.id.get_type() != h5py.h5t.py_create(item.dtype):
                raise ValueError("its numbers are not written as MATLAB writes them")
            empty = words or item.attrs.get("MATLAB_empty", 0) or item.dtype.kind == "O"
            yield f"{prefix}{name}", np.empty(0) if empty else np.asarray(item[()]).T
