"""What a file without a checksum says of itself in two ways is compared, and its parts are counted:
damage that its library reads past is told.
"""

import struct
from typing import Any
from zipfile import ZipFile

import numpy as np
import pytest
from scipy.io import savemat
from test_formats import ANGLE, TIME, c3d

from exoid.recordings.formats.sheets import read_sheet

POINTS, ANALOGS, LAST_FRAME, START, SCALE, RATE = 2, 4, 8, 16, 12, 20  # bytes of a C3D's header


def c3d_with(folder, at, kind, value):
    path = c3d(folder, {"LKneeAngles": ANGLE}, {"gyro_z": np.linspace(-1, 1, 10 * TIME.size)})
    content = bytearray(path.read_bytes())
    struct.pack_into(f"<{kind}", content, at, value)
    path.write_bytes(content)
    return path


def test_a_sound_c3d_says_the_same_twice(tmp_path):
    assert read_sheet(c3d_with(tmp_path, POINTS, "H", 1)).notes == ()


@pytest.mark.parametrize(
    ("at", "kind", "value", "why"),
    [
        (ANALOGS, "H", 0, "announces 0 analog samples a frame, its parameters 10"),
        (LAST_FRAME, "H", 50, "announces 50 frames, and it holds 60"),
        (RATE, "f", 50.0, "announces 50 Hz, its parameters 100"),
        (SCALE, "f", -2.0, "announces -2 as the scale, its parameters -1"),
    ],
)
def test_a_header_that_differs_from_the_parameters_is_told(tmp_path, at, kind, value, why):
    (note,) = read_sheet(c3d_with(tmp_path, at, kind, value)).notes
    assert f"its header {why}. Is the file damaged? Export it again." in note


def test_a_c3d_that_was_cut_says_how_many_frames_are_left(tmp_path):
    path = c3d_with(tmp_path, POINTS, "H", 1)
    path.write_bytes(path.read_bytes()[:-1024])
    (note,) = read_sheet(path).notes
    assert "its header announces 60 frames, and it holds " in note


def test_a_c3d_without_its_samples_is_not_read_as_if_they_were_there(tmp_path):
    """ezc3d gives for them whatever it read last."""
    path = c3d_with(tmp_path, POINTS, "H", 1)
    start = struct.unpack_from("<H", path.read_bytes(), START)[0]
    path.write_bytes(path.read_bytes()[: 512 * (start - 1) - 500])
    (note,) = read_sheet(path).notes
    assert f"it ends {60 * (4 + 10) * 4 + 500} bytes before its last sample." in note


def hdf5(path):
    """A .mat of version 7.3, and where its knee angle is described."""
    import h5py
    import h5py.h5o as objects

    with h5py.File(path, "w", userblock_size=512) as file:
        for name, samples in {"time": TIME, "knee_angle": ANGLE}.items():
            file.create_dataset(name, data=samples[None])
        return 512 + objects.get_info(file["knee_angle"].id).addr


def test_a_variable_that_hdf5_cannot_open_is_not_left_out_without_a_word(tmp_path):
    path = tmp_path / "leg.mat"
    at = hdf5(path)
    content = bytearray(path.read_bytes())
    content[at] ^= 0xFF  # the version of its description
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"cannot be read: it is damaged"):
        read_sheet(path)


def test_a_variable_that_hdf5_does_not_find_by_its_name_is_not_left_out_without_a_word(tmp_path):
    """Names are sought in their order, in which another letter is at another place."""
    path = tmp_path / "leg.mat"
    hdf5(path)
    content = path.read_bytes()
    assert content.count(b"time\0") == 1
    path.write_bytes(content.replace(b"time\0", b"dime\0"))
    with pytest.raises(ValueError, match=r"cannot be read: it is damaged"):
        read_sheet(path)


def test_what_a_mat_refers_to_elsewhere_is_passed_over(tmp_path):
    import h5py

    path = tmp_path / "leg.mat"
    hdf5(path)
    with h5py.File(path, "a") as file:
        file["elsewhere"] = h5py.SoftLink("/nowhere")
    assert sorted(each.name for each in read_sheet(path).columns) == ["knee_angle", "time"]


CELLS = np.array([np.arange(3.0), "word"], object)


@pytest.mark.parametrize("packed", [False, True])
def test_structs_and_cells_are_read_whole(tmp_path, packed):
    trials = np.array([(1.0, "a"), (2.0, "b")], [("n", object), ("of", object)])
    held = {"trial": {"time": TIME, "knee_angle": ANGLE, "of": {"a": {}, "b": []}}}
    several = {"cells": CELLS, "trials": trials, "none": np.empty((0, 0)), "words": ["a", "bc"]}
    savemat(tmp_path / "leg.mat", held | several, do_compression=packed)
    columns = [each.name for each in read_sheet(tmp_path / "leg.mat").columns]
    assert {"trial.time", "trial.knee_angle"} <= {*columns}


LENGTH_OF_NAMES = struct.pack("<2L", 11, 1)  # of a field, then the kind of what follows
SIZES = struct.pack("<2l", 1, 2)  # of the cells


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        (LENGTH_OF_NAMES, struct.pack("<2L", 13, 1), "are not named as MATLAB names"),
        (SIZES, struct.pack("<2l", 1, 1), "announces 1 parts and holds 2"),
    ],
)
def test_a_struct_or_cell_array_that_lost_a_part_is_refused(tmp_path, old, new, why):
    """SciPy reads what is announced, and says nothing of the rest."""
    path = tmp_path / "leg.mat"
    savemat(path, {"trial": {"time": TIME, "knee_angle": ANGLE}, "cells": CELLS})
    content = path.read_bytes()
    assert content.count(old) == 1
    path.write_bytes(content.replace(old, new))
    with pytest.raises(ValueError, match=why):
        read_sheet(path)


def test_numbers_that_are_not_laid_out_as_any_machine_writes_them_are_refused(tmp_path):
    path = tmp_path / "leg.mat"
    hdf5(path)
    layout, other = b"4\x0b\x004\xff\x03\0\0", b"4\x0b\x004\xff\x02\0\0"  # the exponent's bias
    content = path.read_bytes()
    assert layout in content
    path.write_bytes(content.replace(layout, other))
    with pytest.raises(ValueError, match="its numbers are not written as MATLAB writes them"):
        read_sheet(path)


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        (b't="inlineStr"', b't="z"', "a cell has the unknown kind b'z'"),
        (b'<row r="2"', b'<row r="3"', "its rows are not in their order"),
    ],
)
def test_what_openpyxl_would_leave_out_of_a_sheet_is_refused(tmp_path, old, new, why):
    import openpyxl

    book = openpyxl.Workbook()
    sheet: Any = book.active
    for row in [("time", "what"), (0.0, "a"), (0.1, "b"), (0.2, "c")]:
        sheet.append(row)
    book.save(tmp_path / "sound.xlsx")
    assert [*read_sheet(tmp_path / "sound.xlsx").columns[1].cells] == ["a", "b", "c"]
    with ZipFile(tmp_path / "sound.xlsx") as sound, ZipFile(tmp_path / "odd.xlsx", "w") as odd:
        for name in sound.namelist():
            content = sound.read(name)
            if name == "xl/worksheets/sheet1.xml":
                content = content.replace(old, new, 1)
            odd.writestr(name, content)
    with pytest.raises(ValueError, match=why):
        read_sheet(tmp_path / "odd.xlsx")


@pytest.mark.parametrize("told", ["A1:A3", "A1", "A1:B100"])
def test_a_sheet_is_read_whole_whatever_size_it_announces(tmp_path, told):
    import openpyxl

    book = openpyxl.Workbook()
    sheet: Any = book.active
    for row in [("time", "angle"), *zip(TIME.tolist(), ANGLE.tolist(), strict=True)]:
        sheet.append(row)
    book.save(tmp_path / "sound.xlsx")
    with ZipFile(tmp_path / "sound.xlsx") as sound, ZipFile(tmp_path / "odd.xlsx", "w") as odd:
        for name in sound.namelist():
            content = sound.read(name)
            if name == "xl/worksheets/sheet1.xml":
                assert content.count(b'ref="A1:B61"') == 1
                content = content.replace(b'ref="A1:B61"', f'ref="{told}"'.encode())
            odd.writestr(name, content)
    time, angle = read_sheet(tmp_path / "odd.xlsx").columns
    # openpyxl writes 16 digits, which is half of one of them in 1
    np.testing.assert_allclose(time.cells, TIME, rtol=5e-16, atol=0)
    np.testing.assert_allclose(angle.cells, ANGLE, rtol=5e-16, atol=0)


def test_words_of_a_parquet_file_that_are_not_declared_as_such_are_words(tmp_path):
    import pyarrow
    import pyarrow.parquet

    words = pyarrow.array([b"drop", "kn\xe9e".encode(), b"\xff", None], pyarrow.binary())
    table = pyarrow.table({"time": np.arange(4.0), "what": words})
    pyarrow.parquet.write_table(table, tmp_path / "leg.parquet")
    time, what = read_sheet(tmp_path / "leg.parquet").columns
    assert [*what.cells] == ["drop", "kn\xe9e", "\ufffd", ""]
    np.testing.assert_array_equal(time.cells, np.arange(4.0))
