"""What is in memory becomes a recording, and a recording becomes a data frame, without loss."""

import subprocess
import sys
import warnings

import numpy as np
import pytest

import exoid
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.named import named_recordings
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

TIME = np.arange(300) * 0.01
ANGLE = -90 + 70 * np.exp(-TIME) * np.cos(5 * TIME)  # deg, of a leg let go
LEG = {"kind": "leg", "body_mass": 77, "height_m": 1.8}  # a field, and a sidecar's key


def check(recording):
    (segment,) = recording.segments
    np.testing.assert_allclose(segment.time, TIME, rtol=0, atol=1e-12)
    angle = segment.angle if segment.raw_angle is None else segment.raw_angle
    np.testing.assert_allclose(angle, np.radians(ANGLE), rtol=0, atol=1e-14)


@pytest.mark.parametrize(
    "channels",
    [
        {"time_s": TIME, "raw_angle_deg": ANGLE},
        {"time": TIME.tolist(), "angle_deg": ANGLE.tolist()},
        {"time_ms": TIME * 1000, "raw_angle": np.radians(ANGLE)[:, None]},
        {"time": tuple(TIME), "angle": np.radians(ANGLE)},
    ],
)
def test_arrays_and_lists_by_keyword_are_a_recording(channels):
    recording = exoid.recording(**channels, subject=LEG, protocol={"kind": "passive"})
    check(recording)
    assert recording.subject == Subject(kind="leg", body_mass=77.0, height=1.8)
    assert recording.protocol == Protocol(kind="passive")


def test_what_a_mapping_calls_its_columns_is_understood_and_said():
    with pytest.warns(UserWarning, match="Knee Flexion as raw_angle_rad"):
        check(exoid.recording({"Time (s)": TIME, "Knee Flexion": ANGLE}))


def test_what_is_noticed_of_several_files_is_one_warning(tmp_path):
    time = np.arange(300) * 0.01
    for number in range(3):
        angle = -80 + 50 * np.exp(-0.4 * time) * np.cos(5 * time + number / 10)
        rows = [f"{at:.2f},{one:.3f}" for at, one in zip(time, angle, strict=True)]
        text = "\n".join(["time_s,Knee Angle (deg)", *rows])
        (tmp_path / f"{number}.csv").write_text(text)
    paths = [tmp_path / f"{number}.csv" for number in range(3)]
    with pytest.warns(UserWarning, match="and 2 more") as said:
        named_recordings(paths)
    assert [str(each.message).partition(": ")[0] for each in said] == [
        f"{paths[0]} and 2 more",
        f"{tmp_path / '0.toml'} and 2 more",
    ]
    paths[2].unlink()
    with pytest.raises(OSError, match=r"2\.csv"), pytest.warns(UserWarning, match="and 1 more"):
        named_recordings(paths)


def test_a_warning_names_the_line_that_called_exoid(tmp_path):
    script = tmp_path / "mine.py"
    swing = "{'t': [0, 0.05, 0.1, 0.15], 'knee': [-20, -21, -23, -26]}"
    script.write_text(f"import exoid\n\nexoid.recording({swing})\n")
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, check=True)
    assert f"{script}:3: UserWarning: recording: read t as time_s" in done.stderr


def test_a_keyword_may_name_a_column():
    check(exoid.recording({"b": ANGLE, "time_s": TIME}, raw_angle_deg="b"))
    check(exoid.recording({"b": ANGLE, "time_s": TIME}, columns={"raw_angle_deg": "b"}))


@pytest.mark.filterwarnings("ignore:recording. the")
def test_what_an_angle_means_is_told_as_to_load():
    check(exoid.recording(time=TIME, raw_angle_deg=-ANGLE, flip="angle"))
    check(exoid.recording(time=TIME, raw_angle_deg=ANGLE + 90, zero="hanging"))
    with pytest.raises(ValueError, match='flip="angle"'):
        exoid.recording(time=TIME, raw_angle_deg=-ANGLE)


def test_segments_are_told_apart_by_a_column():
    both = {
        "time_s": [*TIME, *TIME],
        "raw_angle_deg": [*ANGLE, *ANGLE],
        "segment": [0] * 300 + [1] * 300,
    }
    assert [each.time.size for each in exoid.recording(both).segments] == [300, 300]


@pytest.mark.filterwarnings("ignore:recording. read")
def test_data_frames_of_pandas_are_a_recording():
    pandas = pytest.importorskip("pandas")
    delta = pandas.to_timedelta(TIME, unit="s")
    for index in (pandas.Index(TIME, name="time"), delta.rename("time"),
                  (pandas.Timestamp("2026-11-21") + delta).rename("time")):  # fmt: skip
        frame = pandas.DataFrame({"knee_angle": ANGLE}, index=index)
        np.testing.assert_allclose(exoid.recording(frame).segments[0].time, TIME, atol=1e-6)
    frame = pandas.DataFrame({"t": TIME, "knee": ANGLE})
    check(exoid.recording(frame))
    check(exoid.recording(frame, time_s="t", raw_angle_deg="knee"))
    check(exoid.recording(time=frame["t"], raw_angle_deg=frame["knee"]))
    frame.loc[5, "knee"] = None
    assert np.isnan(exoid.recording(frame).segments[0].raw_angle[5])


def test_a_recording_and_its_data_frame_are_the_same():
    pytest.importorskip("pandas")
    segments = (
        Segment(TIME, raw_angle=np.radians(ANGLE), extra_columns={"who": ("me",) * 300}),
        Segment(TIME, raw_angle=np.radians(ANGLE), raw_angular_velocity=np.cos(TIME)),
    )
    recording = Recording(segments, Subject(kind="leg"), sensors=Sensors(encoder_counts=4096.0))
    frame = recording.to_dataframe()
    assert [*frame.columns] == ["time_s", "segment", "raw_angle_rad", "raw_velocity_rad_s", "who"]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # `who` is kept as text
        again = exoid.recording(frame, subject=recording.subject, sensors=recording.sensors)
    for one, other in zip(recording.segments, again.segments, strict=True):
        assert one.channels().keys() == other.channels().keys()
        for name, samples in one.channels().items():
            assert samples.tobytes() == other.channels()[name].tobytes()


@pytest.mark.parametrize(
    ("data", "channels", "said"),
    [
        (None, {}, "nothing was given"),
        (None, {"time_s": TIME}, 'has no angle. It holds: time_s. Name it: raw_angle_deg="..."'),
        (None, {"tim": TIME}, "there is no column tim. Did you mean time?"),
        (
            None,
            {"time": TIME, "angle_deg": ANGLE[:-1]},
            "angle_deg has the shape (299,), where 300",
        ),
        (
            None,
            {"time": TIME, "angle": ANGLE},
            "row 0: angle_rad in segment 0, sample 0 is -20 rad",
        ),
        (None, {"time": TIME[::-1], "angle_deg": ANGLE}, "row 1: time_s must increase"),
        (None, {"time": TIME, "angle_deg": ["x"] * 300}, "row 0, column angle_deg: 'x' is not a"),
        (np.zeros((3, 2)), {}, "ndarray has no names"),
        (3, {}, "int has no names"),
        (None, {"time": TIME, "angle_deg": ANGLE, "subject": {"mass": 3}}, "subject has no mass"),
        (None, {"time": TIME, "angle_deg": ANGLE, "subject": {"height": 180}}, "height_m is 180 m"),
    ],
)
def test_what_is_no_recording_is_one_sentence(data, channels, said):
    with pytest.raises(ValueError, match=r"^(recording|subject|height)") as caught:
        exoid.recording(data, **channels)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


# Everything that takes recordings


def test_a_path_a_loaded_file_and_a_recording_are_the_same_to_everything(tmp_path):
    recording = exoid.recording(time=TIME, raw_angle_deg=ANGLE, subject=LEG)
    path = tmp_path / "leg.csv"
    exoid.write_table(recording, path)
    loaded = exoid.load(path)
    for given in (recording, loaded, path, str(path), [loaded], [("a", str(path))]):
        ((_, found),) = named_recordings(given)
        check(found)
        assert exoid.measure_drops(given).drops[0].reason is None
    names = [name for name, _ in named_recordings([path, loaded, ("b", recording)])]
    assert names == ["leg.csv", "recording 1", "b"]


def test_what_a_reader_noticed_becomes_a_warning(tmp_path):
    path = tmp_path / "leg.csv"
    path.with_suffix(".toml").touch()
    rows = [f"{t};{a}" for t, a in zip(TIME, ANGLE, strict=True)]
    path.write_text("\n".join(["Zeit (s);Kniewinkel (deg)", *rows]))
    with pytest.warns(UserWarning, match="Kniewinkel"):
        exoid.measure_drops(path)


def test_no_recording_at_all_is_refused_with_what_makes_one():
    with pytest.raises(ValueError, match=r"an empty list, .* exoid\.recording\(\.\.\.\) makes one"):
        named_recordings([])


# What the prompt shows


def test_a_recording_is_one_line_and_a_small_table():
    recording = exoid.recording(
        time=TIME, raw_angle_deg=ANGLE, subject=LEG, protocol={"kind": "passive"}
    )
    assert repr(recording) == (
        "<Recording: 1 segment (1 passive), 3.0 s, 300 samples, raw_angle, leg, 77 kg, 1.8 m>"
    )
    assert repr(recording.segments[0]) == "<Segment: 2.99 s, 300 samples, raw_angle>"
    assert "<td>passive</td>" in recording._repr_html_()
    assert len(repr(recording)) < 200
