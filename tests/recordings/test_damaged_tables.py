"""What a damaged table or sidecar says is refused or right, and no more than a machine can hold."""

import re
import subprocess
from io import BytesIO
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
import pytest
from test_formats import ANGLE, TIME, mot, sound

from exoid.files import foreign
from exoid.files.text_file import naming
from exoid.files.visible import visible
from exoid.recordings.formats import npz
from exoid.recordings.formats.own_table import read_table
from exoid.recordings.formats.parquet import as_parquet
from exoid.recordings.sidecar import DEEPEST, read_keys


def archive(path, **changed):
    """An .npz of a motion in which some files hold other bytes; all checksums are right."""
    whole = BytesIO()
    np.savez(whole, time=TIME, knee_angle=ANGLE, gyro=np.zeros(TIME.size))
    with ZipFile(whole) as old, ZipFile(path, "w", ZIP_DEFLATED) as new:
        for name in old.namelist():
            change = changed.get(name.removesuffix(".npy"), bytes)
            new.writestr(name, change(old.read(name)))
    return path


def test_an_array_that_says_it_is_shorter_than_it_is_is_checked_to_its_end(tmp_path):
    """NumPy would read a third of the numbers and never come to the checksum, which is wrong."""
    path, whole, time = tmp_path / "leg.npz", BytesIO(), np.arange(6000) * 0.01
    np.savez(whole, time=time, knee_angle=np.cos(time))
    path.write_bytes(whole.getvalue())
    assert len(read_table(path)[0].segments[0].time) == time.size
    assert whole.getvalue().count(b"(6000,)") == 2
    path.write_bytes(whole.getvalue().replace(b"(6000,)", b"(2000,)"))
    with pytest.raises(ValueError, match=r"leg\.npz: is damaged, or not a NumPy archive"):
        read_table(path)


def test_a_column_of_an_archive_is_never_left_out_without_a_word(tmp_path):
    """NumPy hands over as bytes what does not begin as an array does."""
    path = archive(tmp_path / "leg.npz", gyro=lambda old: b"\x00" + old[1:])
    with pytest.raises(ValueError, match=r"holds gyro, which is no array"):
        read_table(path)


def test_an_archive_that_unpacks_to_too_much_is_not_unpacked(tmp_path, monkeypatch):
    monkeypatch.setattr(npz, "MEMORY", 1 << 20)
    path = archive(tmp_path / "leg.npz", gyro=lambda _: bytes(200 << 20))
    with pytest.raises(ValueError, match=r"unpacks to 0\.2 GB, more than a recording can be"):
        read_table(path)


def test_a_changed_byte_of_exoids_own_parquet_is_noticed(tmp_path):
    path = tmp_path / "leg.parquet"
    whole = as_parquet({"time_s": TIME, "raw_angle_rad": np.radians(ANGLE)})
    path.write_bytes(whole)
    assert len(read_table(path)[0].segments[0].time) == TIME.size
    at = whole.index(np.radians(ANGLE)[30].tobytes()[:6])  # packed, its bytes stay as they are
    path.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
    with pytest.raises(ValueError, match=r"leg\.parquet: cannot be read: it is damaged"):
        read_table(path)


@pytest.mark.parametrize("suffix", [".mat", ".parquet", ".xlsx", ".c3d"])
def test_what_a_library_parses_is_limited_in_time_and_memory(tmp_path, monkeypatch, suffix):
    """The limits themselves are tried in test_foreign.py: here, that no format is without them."""

    def late(call, timeout, **_):
        raise subprocess.TimeoutExpired(call, timeout)

    path = sound(tmp_path, suffix)
    monkeypatch.setattr(foreign.subprocess, "run", late)
    with pytest.raises(ValueError, match="reading it took longer than 63 s"):
        read_table(path)


@pytest.mark.parametrize("cell", ["1_0", "inf", "1e5_0", "٣", "0x1F", "infinity"])
@pytest.mark.parametrize("separator", [";", "\t"])
def test_only_what_every_program_takes_for_a_number_is_one(tmp_path, cell, separator):
    path = tmp_path / "leg.csv"
    rows = [separator.join((f"{t:.2f}", f"{a:.3f}")) for t, a in zip(TIME, ANGLE, strict=True)]
    rows[7] = separator.join(("0.07", cell))
    path.write_text("\n".join([separator.join(("time", "knee angle")), *rows]), encoding="utf-8")
    with pytest.raises(ValueError, match=r"is not a number|has no angle"):
        read_table(path)


def test_a_damaged_cell_of_a_column_that_is_not_read_is_told(tmp_path):
    """Lines that were joined in it are a sample of two others."""
    path = tmp_path / "leg.csv"
    rows = [f"{t:.2f};0.5;{a:.3f}" for t, a in zip(TIME, ANGLE, strict=True)]
    path.write_text("\n".join(["time;pelvis;knee angle", *rows]))
    whole = read_table(path)[1]
    path.write_text("\n".join(["time;pelvis;knee angle", *rows[:7], "0.07;0.50.5;-31", *rows[8:]]))
    (said,) = {*read_table(path)[1]} - {*whole}
    assert "line 9, column pelvis holds '0.50.5', where the other lines hold numbers" in said


def test_a_motion_that_was_cut_says_how_many_rows_are_missing(tmp_path):
    path = mot(tmp_path)
    whole = read_table(path)[1]
    lines = path.read_text().splitlines(keepends=True)
    path.write_text("".join(lines[:-20]))
    (said,) = {*read_table(path)[1]} - {*whole}
    assert said.endswith("its header announces 60 rows, and it holds 40.")


NESTED = {
    "lists": "x = " + "[" * 100_000,
    "closed lists": "x = " + "[" * 400 + "]" * 400,
    "keys": ".".join("a" * 3000) + " = 1",
    "tables": f"[{'.'.join('b' * 3000)}]\nc = 1",
    "in lists": "x = " + "[{a = " * 30 + "1" + "}]" * 30,
}


@pytest.mark.parametrize("nested", NESTED)
def test_a_sidecar_that_nests_too_deep_is_one_sentence(tmp_path, nested):
    path = tmp_path / "leg.toml"
    path.write_text(NESTED[nested])
    with pytest.raises(ValueError, match=f"nests tables or lists more than {DEEPEST} deep"):
        read_keys(path)


def test_a_sidecar_may_nest_as_deep_as_anybody_needs(tmp_path):
    path = tmp_path / "leg.toml"
    path.write_text("x = " + "[" * (DEEPEST - 1) + "]" * (DEEPEST - 1))
    assert "x" in read_keys(path)[1]


def test_words_of_a_file_are_shown_and_none_is_obeyed():
    said = "a\x1b[31m\x07 b\nc\u202ed\x9b2J \ud800 é ½\u202f°"
    assert visible(said) == r"a\u001b[31m\u0007 b\nc\u202ed\u009b2J \ud800 é ½" + "\u202f°"
    assert visible(said, "\n").count("\n") == 1
    assert visible(visible(said)) == visible(said)


def test_what_is_wrong_in_a_file_is_told_without_its_control_characters(tmp_path):
    with pytest.raises(ValueError, match=r"^a\\u001b\.csv: column \\u009b is there twice$"):  # noqa: SIM117
        with naming(tmp_path.__class__("a\x1b.csv")):
            raise ValueError("column \x9b is there twice")


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        ('"cut', "line 4: a quote that opens a cell does not close at its end. Check the quotes."),
        ("long" * 40_000, "line 3: a cell is longer than 131072 characters."),
    ],
    ids=["open", "long"],
)
def test_a_cell_that_no_reader_of_csv_takes_is_told_in_our_own_words(tmp_path, cell, said):
    path = tmp_path / "leg.csv"
    path.write_text(f"time_s,angle_rad,note\n0,0,a\n0.01,0,{cell}\n0.02,0,b\n")
    with pytest.raises(ValueError, match=re.escape(said)):
        read_table(path)
