"""MATLAB's .mat: version 7 and older by SciPy, version 7.3, which is HDF5, by h5py."""

from pathlib import Path
from typing import Any

import numpy as np

from exoid.recording.tables.arrays import sheet_of_arrays
from exoid.recording.tables.sheet import Place, Sheet

HDF5 = b"\x89HDF\r\n\x1a\n"
USER_BLOCK = 512  # bytes that MATLAB writes before the HDF5
OBJECTS = "function_workspace"
INTERNAL = ("#refs#", "#subsystem#")


def read_matlab(path: Path) -> Sheet:
    """The vectors of one length, in variables and in structs.

    **Raises** `ValueError` where there are none; a `table` or `timetable` of MATLAB cannot be read.
    """
    with path.open("rb") as file:
        head = file.read(USER_BLOCK + len(HDF5))
    hdf5 = head[USER_BLOCK:] == HDF5 or head.startswith(HDF5)
    variables = in_hdf5(path) if hdf5 else in_version_5(path)
    plain = {name: value for name, value in variables.items() if not name.startswith(("__", "#"))}
    if not plain and (variables.keys() & {f"__{OBJECTS}__", *INTERNAL, "None"}):
        raise ValueError(
            "holds a table or another object that only MATLAB reads. Save its columns as arrays, "
            "or write it with writetable(T, 'name.csv') or parquetwrite."
        )
    return sheet_of_arrays(plain, Place("sample"))


def in_version_5(path: Path) -> dict[str, Any]:
    import scipy.io

    return scipy.io.loadmat(str(path), simplify_cells=True)


def in_hdf5(path: Path) -> dict[str, Any]:
    import h5py

    with h5py.File(path, "r") as file:
        return {name: held(each, file) for name, each in file.items()}


def held(item: Any, file: Any) -> Any:
    """A variable: structs are groups, text is numbers, what refers elsewhere is followed."""
    import h5py

    if isinstance(item, h5py.Group):
        return {name: held(each, file) for name, each in item.items()}
    kind = item.attrs.get("MATLAB_class", b"")
    kind = kind.decode() if isinstance(kind, bytes) else str(kind)
    if kind == "char" or item.attrs.get("MATLAB_empty"):
        return np.empty(0)
    if item.dtype.kind == "O":  # a cell array, or an array of structs
        return np.empty(0)
    return np.asarray(item[()]).T
