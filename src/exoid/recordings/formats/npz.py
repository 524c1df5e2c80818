"""NumPy's .npz: named arrays, never pickled objects."""

import os
from collections.abc import Collection
from pathlib import Path
from typing import BinaryIO
from zipfile import BadZipFile, ZipFile, is_zipfile

import numpy as np

from exoid.files.foreign import MEMORY, MEMORY_PER_BYTE
from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.sheet import Place, Sheet, printable


def read_npz(path: Path, wanted: Collection[str] = ()) -> Sheet:
    """The vectors of one length, `wanted` by their names or not.

    **Raises** `ValueError` where there are none; pickled objects are not opened.
    """
    with path.open("rb") as stream:  # NumPy leaves it open where it fails
        check_archive(stream)
        file = np.load(stream, allow_pickle=False)
        if not isinstance(file, np.lib.npyio.NpzFile):
            raise ValueError("holds one array without names. Save with np.savez(time=..., ...).")
        arrays = {name: opened(file, name) for name in file.files}
    return sheet_of_arrays(arrays, Place("sample"), wanted)


def check_archive(stream: BinaryIO) -> None:
    """Refuse a damaged archive, and one that unpacks to more than a recording can be.

    NumPy reads as much as an array says that it is: what follows, and the checksum behind it, it
    does not look at.
    """
    if not is_zipfile(stream):
        return  # one array, or what NumPy has a word for
    size = stream.seek(0, os.SEEK_END)
    with ZipFile(stream) as archive:
        unpacked = sum(each.file_size for each in archive.infolist())
        if unpacked > MEMORY + MEMORY_PER_BYTE * size:
            raise ValueError(f"unpacks to {unpacked / 1e9:.1f} GB, more than a recording can be.")
        if archive.testzip() is not None:
            raise BadZipFile
    stream.seek(0)


def opened(file: np.lib.npyio.NpzFile, name: str) -> np.ndarray:
    """One array. NumPy hands over whatever else an archive holds as bytes."""
    try:
        found = file[name]
    except ValueError as error:
        if "pickle" in str(error):
            return np.empty(0)  # objects: named among what is not read
        raise
    if not isinstance(found, np.ndarray):
        raise ValueError(f"holds {printable(name)}, which is no array. Save it again.")
    return found
