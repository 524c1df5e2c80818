"""Binary tables: npz, mat, c3d, xlsx and parquet, as the libraries that own them write them."""

from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from zipfile import ZipFile

import numpy as np

from exoid.recordings.formats.parquet import as_parquet
from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.sheet import Place

from .inside import in_mat, in_zip, zipped
from .mat5 import variables_by_hand
from .others import channels_by_c3d, columns_by_duckdb, rows_by_calamine
from .reading import Format, Rows, Sample
from .tables import ANGLE, TIME, numbers_of, read_columns_of

COLUMNS = {"time": TIME, "knee_angle": ANGLE}
DATED = ("docProps/core.xml",)  # of a workbook: when it was saved


def saved(suffix: str, write: Callable[[str], Any]) -> Sample:
    """What `write` writes to a path."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"table{suffix}"
        write(str(path))
        return Sample(path.read_bytes())


def npz_samples() -> tuple[Sample, ...]:
    return (
        saved(".npz", lambda path: np.savez(path, **COLUMNS)),
        saved(".npz", lambda path: np.savez_compressed(path, fs=100.0, knee=ANGLE, of=TIME > 0)),
    )


def arrays_by_zip(path: Path, _sample: Sample) -> Rows:
    """Every file of the archive in full, with its checksum, and the array that it holds."""
    with ZipFile(path) as archive:
        whole = {name: archive.read(name) for name in archive.namelist()}
    arrays = {
        name.removesuffix(".npy"): np.lib.format.read_array(BytesIO(each))
        for name, each in whole.items()
    }
    return numbers_of(sheet_of_arrays(arrays, Place()))


def mat_samples() -> tuple[Sample, ...]:
    from scipy.io import savemat

    def hdf5(path: str) -> None:
        import h5py

        with h5py.File(path, "w", userblock_size=512, track_order=False) as file:
            for name, samples in COLUMNS.items():
                file.create_dataset(name, data=samples[None], track_times=False)

    packed = saved(".mat", lambda path: savemat(path, COLUMNS, do_compression=True))
    plain = saved(".mat", lambda path: savemat(path, {"trial": COLUMNS, "fs": 100.0}))
    return undated(packed), undated(plain), saved(".mat", hdf5)


def undated(sample: Sample) -> Sample:
    """A .mat without the time in its first line."""
    return Sample(b"MATLAB 5.0 MAT-file".ljust(116) + sample.content[116:])


def c3d_samples() -> tuple[Sample, ...]:
    import ezc3d

    file = ezc3d.c3d()
    file["parameters"]["POINT"]["RATE"]["value"] = [100]
    file["parameters"]["POINT"]["LABELS"]["value"] = ("LKneeAngles", "LANK")
    file["parameters"]["POINT"]["UNITS"]["value"] = ("mm",)
    file["parameters"]["ANALOG"]["RATE"]["value"] = [200]
    file["parameters"]["ANALOG"]["LABELS"]["value"] = ("gyro", "tilt")
    file["data"]["points"] = np.stack([np.tile(ANGLE, (2, 1))] * 4)
    file["data"]["analogs"] = np.linspace([-1, 0], [1, 9], 2 * ANGLE.size).T[None]
    return (saved(".c3d", file.write),)


def xlsx_samples() -> tuple[Sample, ...]:
    import openpyxl

    book = openpyxl.Workbook()
    sheet: Any = book.active
    sheet.append(["Time [s]", "Knee angle [deg]", "what"])
    for number, row in enumerate(zip(TIME.tolist(), ANGLE.tolist(), strict=True)):
        sheet.append([*row, f"note {number}"])
    book.create_sheet("second").append(["nothing"])
    with ZipFile(BytesIO(saved(".xlsx", book.save).content)) as archive:
        files = {n: archive.read(n) for n in archive.namelist() if n not in DATED}
    return (Sample(zipped(files)),)


def parquet_samples() -> tuple[Sample, ...]:
    import pyarrow

    own = as_parquet({"time_s": TIME, "raw_angle_rad": np.radians(ANGLE), "what": ["a"] * 12})
    table = pyarrow.table({**COLUMNS, "n": pyarrow.array(range(12), pyarrow.int32())})

    def write(path: str) -> None:
        import pyarrow.parquet

        pyarrow.parquet.write_table(table, path, compression="none", use_dictionary=False)

    return Sample(own), saved(".parquet", write)


def archive_formats() -> dict[str, Format]:
    read = read_columns_of
    return {
        "npz": Format(".npz", npz_samples(), read, arrays_by_zip, in_zip),
        "mat": Format(".mat", mat_samples(), read, variables_by_hand, in_mat, stricter=True),
        "c3d": Format(".c3d", c3d_samples(), read, channels_by_c3d, stricter=True),
        "xlsx": Format(".xlsx", xlsx_samples(), read, rows_by_calamine, in_zip, stricter=True),
        "parquet": Format(".parquet", parquet_samples(), read, columns_by_duckdb, stricter=True),
    }
