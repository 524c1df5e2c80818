"""Files of other programs, made by the libraries that own the format, hold the motion they hold."""

import random
import subprocess
import sys

import numpy as np
import pytest

from exoid.files.extras import EXTRAS
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

TIME = np.arange(60) * 0.01
ANGLE = -90 + 70 * np.exp(-TIME) * np.cos(5 * TIME)  # deg, of a leg let go
SINGLE = 2e-6  # rad: C3D holds float32, 3.8e-6 deg apart near 90 deg... and OpenSim's text 6 digits


def check(path, tolerance=1e-14, **options):
    """The one segment of a file, which holds the motion above; and what was said."""
    loaded = load(path, **options)
    (segment,) = loaded.recording.segments
    np.testing.assert_allclose(segment.time, TIME, rtol=0, atol=1e-12)
    np.testing.assert_allclose(segment.raw_angle, np.radians(ANGLE), rtol=0, atol=tolerance)
    return segment, "\n".join(loaded.notes)


def mot(folder, name="leg.mot", degrees="yes", column="knee_angle_r", angle=ANGLE):
    rows = [f"{t:.8f}\t0.5\t{a:.8f}" for t, a in zip(TIME, angle, strict=True)]
    head = ["Coordinates", "version=1", f"nRows={TIME.size}", "nColumns=3",
            f"inDegrees={degrees}", "", "Units are S.I. units (second, meters, Newtons, ...)",
            "", "endheader", f"time\tpelvis_tx\t{column}"]  # fmt: skip
    (folder / name).write_text("\n".join([*head, *rows]) + "\n")
    return folder / name


def c3d(folder, points, analogs=(), name="leg.c3d"):
    """Points at 100 Hz as {label: (frames,)} in X, analog channels at 1000 Hz."""
    ezc3d = pytest.importorskip("ezc3d")
    file = ezc3d.c3d()
    parameters = file["parameters"]
    parameters["POINT"]["RATE"]["value"] = [100]
    parameters["POINT"]["LABELS"]["value"] = tuple(points)
    parameters["POINT"]["UNITS"]["value"] = ("mm",)
    data = np.zeros((4, len(points), TIME.size))
    for number, samples in enumerate(points.values()):
        data[0, number] = samples
    file["data"]["points"] = data
    if analogs:
        parameters["ANALOG"]["RATE"]["value"] = [1000]
        parameters["ANALOG"]["LABELS"]["value"] = tuple(analogs)
        parameters["ANALOG"]["UNITS"]["value"] = tuple("deg/s" for _ in analogs)
        file["data"]["analogs"] = np.array([[*analogs.values()]])
    file.write(str(folder / name))
    return folder / name


# OpenSim


def test_an_opensim_motion_is_read_in_the_unit_of_its_header(tmp_path):
    _, said = check(mot(tmp_path), tolerance=1e-9)
    assert "knee_angle_r as raw_angle_rad (in deg)" in said
    assert "not read: pelvis_tx" in said
    check(mot(tmp_path, degrees="no", angle=np.radians(ANGLE)), tolerance=1e-8)


def test_an_opensim_storage_of_states_gives_the_angle_not_its_derivative(tmp_path):
    name = "/jointset/knee_r/knee_angle_r/value"
    path = mot(tmp_path, "leg.sto", "no", name, np.radians(ANGLE))
    check(path, tolerance=1e-8)
    text = path.read_text().replace("pelvis_tx", "/jointset/knee_r/knee_angle_r/speed")
    path.write_text(text)
    segment, said = check(path, tolerance=1e-8)
    assert segment.raw_angular_velocity is None
    assert "not read: /jointset/knee_r/knee_angle_r/speed" in said


def test_a_storage_without_its_header_is_refused(tmp_path):
    (tmp_path / "leg.sto").write_text("time\tknee_angle_r\n0\t1\n")
    with pytest.raises(ValueError, match=r"leg\.sto: has no line endheader"):
        load(tmp_path / "leg.sto")


# C3D


def test_a_model_angle_among_the_points_of_a_c3d_is_found(tmp_path):
    _, said = check(c3d(tmp_path, {"LKneeAngles": ANGLE, "LANK": TIME}), SINGLE)
    assert "LKneeAngles.X as raw_angle_rad (in deg)" in said
    assert "samples are taken 100 times a second" in said


def test_analog_channels_of_a_c3d_come_with_the_frames_of_its_points(tmp_path):
    fast = np.repeat(np.arange(TIME.size, dtype=float), 10)  # ten samples a frame, all alike
    path = c3d(tmp_path, {"LKneeAngles": ANGLE}, {"gyro_z": fast})
    segment, _ = check(path, SINGLE)
    np.testing.assert_allclose(segment.raw_angular_velocity, np.radians(np.arange(60)), rtol=1e-6)


def test_an_angle_among_the_analog_channels_comes_at_their_rate(tmp_path):
    path = c3d(tmp_path, {"LANK": ANGLE}, {"Voltage.1": np.linspace(-90, -20, 600)})
    columns = {"raw_angle_deg": "Voltage.1"}
    (segment,) = load(path, columns=columns).recording.segments
    assert segment.time.size == 600
    assert segment.time[1] == 1e-3


def test_a_c3d_without_a_knee_angle_says_what_it_holds(tmp_path):
    path = c3d(tmp_path, {"LANK": ANGLE, "LKNE": ANGLE}, {"EMG1": np.zeros(600)})
    with pytest.raises(ValueError, match="has no knee angle by its name") as caught:
        load(path)
    assert "points are LANK, LKNE, its analog channels EMG1" in str(caught.value)
    with pytest.raises(ValueError, match=r"has no column 'LANK' .* It holds: LANK\.X"):
        load(path, columns={"raw_angle_deg": "LANK"})


# MATLAB, NumPy


def test_matlab_variables_and_structs_are_read(tmp_path):
    io = pytest.importorskip("scipy.io")
    path = tmp_path / "leg.mat"
    io.savemat(path, {"t": TIME, "knee_angle": ANGLE[:, None], "note": "left", "fs": 100})
    check(path)
    io.savemat(path, {"trial": {"t": TIME, "knee": ANGLE, "gyr": np.zeros((60, 3))}})
    _, said = check(path)
    assert "trial.knee as raw_angle_rad" in said
    assert "trial.gyr.1, trial.gyr.2" in said
    io.savemat(path, {"data": np.column_stack([TIME, ANGLE])})
    check(path, columns={"time_s": "data.1", "raw_angle_deg": "data.2"})


COUNTS = (60, 70, 65)


def trials(*, emg=False):
    """Of other lengths and heights each; the EMG is ten times as fast."""
    for number, count in enumerate(COUNTS):
        time = np.arange(count) * 0.01
        angle = -90 + (70 - 5 * number) * np.exp(-time) * np.cos(5 * time)
        yield {"t": time, "knee": angle, **({"emg": np.zeros(10 * count)} if emg else {})}


def in_structs(how, each):
    """As MATLAB has them: a struct array, a cell of structs, or a struct for each."""
    if how == "array":
        array = np.empty((1, len(each)), [(name, object) for name in each[0]])
        for number, one in enumerate(each):
            array[0, number] = tuple(one.values())
        return {"trial": array}
    if how == "cell":
        cell = np.empty(len(each), object)
        cell[:] = each
        return {"trials": cell}
    named = {f"Drop_{number:02d}": one for number, one in enumerate(each, 1)}
    return named if how == "structs" else {"data": named}


@pytest.mark.parametrize("emg", [False, True])
@pytest.mark.parametrize("how", ["array", "cell", "structs", "nested"])
def test_the_trials_of_a_matlab_file_are_the_segments_of_a_recording(tmp_path, how, emg):
    io = pytest.importorskip("scipy.io")
    each = [*trials(emg=emg)]
    io.savemat(tmp_path / "leg.mat", in_structs(how, each))
    loaded = load(tmp_path / "leg.mat")
    assert [one.time.size for one in loaded.recording.segments] == [*COUNTS]
    for segment, one in zip(loaded.recording.segments, each, strict=True):
        np.testing.assert_allclose(segment.raw_angle, np.radians(one["knee"]), rtol=0, atol=1e-14)
        np.testing.assert_allclose(segment.time, one["t"], rtol=0, atol=1e-12)
    said = "\n".join(loaded.notes)
    assert "1 to 3: 3 segments of one recording" in said
    assert (".emg" in said) == emg  # of other lengths, not read


def test_one_of_several_trials_is_read_where_it_is_named(tmp_path):
    io = pytest.importorskip("scipy.io")
    each = [*trials()]
    io.savemat(tmp_path / "leg.mat", {f"trial{number}": one for number, one in enumerate(each, 1)})
    named = {"time_s": "trial2.t", "raw_angle_deg": "trial2.knee"}
    (segment,) = load(tmp_path / "leg.mat", columns=named).recording.segments
    np.testing.assert_allclose(segment.raw_angle, np.radians(each[1]["knee"]), rtol=0, atol=1e-14)


def test_structs_that_are_numbered_but_no_trials_stay_apart(tmp_path):
    """Two encoders, say: nobody knows what of them is the knee's."""
    io = pytest.importorskip("scipy.io")
    first, second, _ = trials()
    alike = {name: one[: first["t"].size] for name, one in second.items()}
    io.savemat(tmp_path / "leg.mat", {"encoder1": first, "encoder2": alike})
    with pytest.raises(ValueError, match=r"several columns can be the time: encoder1\.t, encoder2"):
        load(tmp_path / "leg.mat")


def test_a_rate_among_the_variables_takes_the_place_of_a_time(tmp_path):
    io = pytest.importorskip("scipy.io")
    io.savemat(tmp_path / "leg.mat", {"knee": ANGLE, "Fs": 100.0})
    check(tmp_path / "leg.mat")


def test_matlab_version_7_3_is_read(tmp_path):
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "leg.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        group = file.create_group("trial")
        for name, samples in (("t", TIME), ("knee", ANGLE)):
            group[name] = samples[None]  # MATLAB's n x 1, as HDF5 holds it
        file["who"] = np.array([[76], [101]], np.uint16)
        file["who"].attrs["MATLAB_class"] = np.bytes_("char")
    content = bytearray(path.read_bytes())
    content[:19] = b"MATLAB 7.3 MAT-file"
    path.write_bytes(content)
    check(path)


def test_numpy_archives_are_read_and_pickles_are_not(tmp_path):
    path = tmp_path / "leg.npz"
    np.savez(path, time=TIME, knee_angle=ANGLE)
    check(path)
    np.savez(path, time=TIME, knee_angle=ANGLE, what=np.array([{}, 1], object))
    check(path)
    np.savez(path, what=np.array([{}, 1], object))
    with pytest.raises(ValueError, match=r"holds no vector of numbers\. It holds: what"):
        load(path)


# Data frames on disk


def test_excel_is_read_below_a_title_with_units_and_dates(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.active.append(["Only words here"])
    sheet = book.create_sheet("Messung")
    for row in (["Pendeltest", None, 12], [], ["Zeit", "Kniewinkel", "Kommentar"], ["s", "°"]):
        sheet.append(row)
    for time, angle in zip(TIME, ANGLE, strict=True):
        sheet.append([float(time), float(angle)])
    sheet["C6"] = "released"
    book.save(tmp_path / "leg.xlsx")
    _, said = check(tmp_path / "leg.xlsx")
    assert "sheet Messung of 2 is read" in said
    sheet["B10"] = "left"
    book.save(tmp_path / "leg.xlsx")
    with pytest.raises(ValueError, match="row 10, column Kniewinkel: 'left' is not a number"):
        load(tmp_path / "leg.xlsx")


def test_what_pandas_writes_is_read(tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    pytest.importorskip("openpyxl")
    moments = pandas.Timestamp("2026-11-21 10:00") + pandas.to_timedelta(TIME, unit="s")
    for time in (TIME, pandas.to_timedelta(TIME, unit="s"), moments):
        frame = pandas.DataFrame({"Time": time, "Knee Flexion (deg)": ANGLE, "who": "me"})
        frame.to_parquet(tmp_path / "leg.parquet")
        check(tmp_path / "leg.parquet", SINGLE)
    frame = pandas.DataFrame({"Time": TIME, "Knee Flexion (deg)": ANGLE})
    frame.to_excel(tmp_path / "leg.xlsx")
    check(tmp_path / "leg.xlsx")
    frame.to_csv(tmp_path / "leg.csv", sep=";", decimal=",")
    check(tmp_path / "leg.csv")


def test_a_table_of_exoid_as_parquet_is_read_back_to_the_last_bit(tmp_path):
    pytest.importorskip("pyarrow")
    segments = tuple(
        Segment(
            TIME,
            raw_angle=np.radians(ANGLE) / scale,
            raw_angular_velocity=np.where(TIME > 0.3, np.nan, TIME) if scale == 1 else None,
            extra_columns={"marker": tuple("ab" * 30)},
        )
        for scale in (1, 3)
    )
    subject = Subject(kind="leg", height=1.8)
    recording = Recording(segments, subject, Protocol(kind="passive"), Sensors())
    write_table(recording, tmp_path / "leg.parquet")
    again = load(tmp_path / "leg.parquet").recording
    assert again.subject == subject
    for one, other in zip(recording.segments, again.segments, strict=True):
        assert one.channels().keys() == other.channels().keys()
        for name, samples in one.channels().items():
            assert samples.tobytes() == other.channels()[name].tobytes()
        assert one.extra_columns == other.extra_columns


# What is missing or damaged


@pytest.mark.parametrize(("name", "package"), [("leg.c3d", "ezc3d"), ("leg.xlsx", "openpyxl"),
                                               ("leg.parquet", "pyarrow")])  # fmt: skip
def test_a_missing_package_is_named_with_its_extra(tmp_path, monkeypatch, name, package):
    monkeypatch.setattr("exoid.files.extras.find_spec", lambda _: None)
    (tmp_path / name).write_bytes(b"x")
    with pytest.raises(ValueError, match=rf"{package}, which is missing: in a clone of exoid") as e:
        load(tmp_path / name)
    assert str(e.value).endswith(f"install '.[{EXTRAS[package]}]'")


@pytest.mark.parametrize("name", ["leg.xls", "leg.ods", "leg.npy", "leg.json", "leg.feather"])
def test_a_format_that_is_not_read_says_what_to_save_instead(tmp_path, name):
    (tmp_path / name).write_bytes(b"x")
    with pytest.raises(ValueError, match=r"(Save|Write) "):
        load(tmp_path / name)


def sound(folder, suffix):
    """A small sound file of each binary format."""
    import pandas
    import scipy.io

    path = folder / f"sound{suffix}"
    frame = pandas.DataFrame({"time": TIME, "knee_angle": ANGLE})
    makers = {
        ".npz": lambda: np.savez(path, time=TIME, knee_angle=ANGLE),
        ".mat": lambda: scipy.io.savemat(path, {"time": TIME, "knee_angle": ANGLE}),
        ".parquet": lambda: frame.to_parquet(path),
        ".xlsx": lambda: frame.to_excel(path),
        ".c3d": lambda: c3d(folder, {"LKneeAngles": ANGLE}, name=path.name),
    }
    makers[suffix]()
    return path


def refusal(path):
    """What is said of a file that cannot be read; nothing where it can."""
    try:
        load(path)
    except ValueError as fault:
        return str(fault)
    return ""


@pytest.mark.parametrize("suffix", [".npz", ".mat", ".parquet", ".xlsx", ".c3d"])
def test_a_damaged_file_is_read_or_is_one_sentence(tmp_path, suffix):
    content = sound(tmp_path, suffix).read_bytes()
    damage = random.Random(suffix)
    path = tmp_path / f"leg{suffix}"
    for kind in ("cut", "flip", "flip", "other", "empty"):
        broken = bytearray(content)
        if kind == "cut":
            broken = broken[: damage.randrange(1, len(broken))]
        elif kind == "flip":
            for _ in range(4):
                broken[damage.randrange(len(broken))] ^= 1 << damage.randrange(8)
        elif kind == "other":
            broken = bytearray(b"This is no such file.\n" * 20)
        path.write_bytes(b"" if kind == "empty" else broken)
        said = refusal(path)
        assert said.startswith(f"{path}: ") or kind == "flip", kind
        assert "\n" not in said


def test_reading_a_table_loads_no_library_that_it_does_not_need():
    heavy = "{'jax', 'pandas', 'pyarrow', 'openpyxl', 'ezc3d', 'h5py'}"
    code = f"import sys, exoid.recordings.loading.load; sys.exit(len({heavy} & sys.modules.keys()))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
