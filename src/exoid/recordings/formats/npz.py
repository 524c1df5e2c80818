"""NumPy's .npz: named arrays, never pickled objects."""

from pathlib import Path

import numpy as np

from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.sheet import Place, Sheet


def read_npz(path: Path) -> Sheet:
    """The vectors of one length.

    **Raises** `ValueError` where there are none; pickled objects are not opened.
    """
    with path.open("rb") as stream:  # NumPy leaves it open where it fails
        file = np.load(stream, allow_pickle=False)
        if not isinstance(file, np.lib.npyio.NpzFile):
            raise ValueError("holds one array without names. Save with np.savez(time=..., ...).")
        arrays = {name: opened(file, name) for name in file.files}
    return sheet_of_arrays(arrays, Place("sample"))


def opened(file: np.lib.npyio.NpzFile, name: str) -> np.ndarray:
    try:
        return file[name]
    except ValueError as error:
        if "pickle" in str(error):
            return np.empty(0)  # objects: named among what is not read
        raise
