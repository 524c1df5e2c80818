"""Any table of somebody else's, by its suffix; what its library says of it becomes a sentence."""

import warnings
from collections.abc import Callable, Collection
from functools import partial
from importlib import import_module
from pathlib import Path

from exoid.files.extras import require
from exoid.files.foreign import ForeignError
from exoid.files.library_faults import is_ours
from exoid.recordings.tables.sheet import Sheet

TEXTS = (".csv", ".tsv", ".txt", ".dat", ".lvm")
# Suffix: the module of its reader, what such a file is called, and the package that it needs.
READERS: dict[str, tuple[str, str | None, str | None]] = {
    **dict.fromkeys(TEXTS, ("delimited", None, None)),
    **dict.fromkeys((".mot", ".sto"), ("opensim", None, None)),
    **dict.fromkeys((".xlsx", ".xlsm"), ("excel", "an Excel workbook", "openpyxl")),
    ".npz": ("npz", "a NumPy archive", None),
    ".mat": ("matlab", "a MATLAB file", None),
    ".c3d": ("c3d", "a C3D file", "ezc3d"),
    ".parquet": ("parquet", "a Parquet file", "pyarrow"),
}
INSTEAD = (
    "Write a recording as .csv or .parquet; a result that exoid saved is for 'exoid report', "
    "'exoid compare' and 'exoid export', and for --model."
)
ELSEWHERE = {
    ".xls": "is in Excel's format of before 2007. Save it as .xlsx or .csv.",
    ".ods": "is an OpenDocument table. Save it as .xlsx or .csv.",
    ".npy": "is one array without names. Save with np.savez(time=..., raw_angle_deg=...).",
    ".feather": "is a Feather file. Write it as .parquet.",
    ".nc": f"is netCDF. {INSTEAD}",
    ".json": f"is JSON. {INSTEAD}",
}


def is_table(path: Path) -> bool:
    """Is this suffix that of a table, readable or not?"""
    return path.suffix.lower() in READERS.keys() | ELSEWHERE.keys()


def read_sheet(path: Path, wanted: Collection[str] = ()) -> Sheet:
    """The table in a file; `wanted` are the columns that a map names.

    **Raises** `ValueError` with one sentence for a file that cannot be read, whatever is the matter
    with it, and for a package that is not installed.
    """
    suffix = path.suffix.lower()
    if suffix in ELSEWHERE:
        raise ValueError(ELSEWHERE[suffix])
    module, called, package = READERS[suffix]
    if package is not None:
        require(package, f"{called} is read")
    if path.is_dir():
        raise ValueError("this is a directory. Name the file in it.")
    if not path.is_file():
        raise ValueError("cannot be read: No such file or directory. Check the name.")
    reader = getattr(import_module(f"exoid.recordings.formats.{module}"), f"read_{module}")
    if suffix in (".c3d", ".mat", ".npz"):
        reader = partial(reader, wanted=wanted)
    return reader(path) if called is None else guarded(reader, path, called)


def guarded(reader: Callable[[Path], Sheet], path: Path, called: str) -> Sheet:
    """What the reader gives; a damaged file in one line, not in the words of its library."""
    damaged = f"is damaged, or not {called}. Export it again."
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the libraries' own, which say nothing about the file
            return reader(path)
    except ForeignError as fault:
        raise ValueError(str(fault).removeprefix(str(path)).lstrip(": ")) from fault
    except MemoryError as fault:
        raise ValueError(f"is damaged, or not {called}: it asks for all memory.") from fault
    except ValueError as fault:
        if is_ours(fault):
            raise
        raise ValueError(damaged) from fault
    except Exception as fault:  # the libraries have no family of exceptions for a bad file
        raise ValueError(damaged) from fault
