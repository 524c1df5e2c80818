"""Motion-BIDS: what is written is read back, and what others wrote is understood."""

import json
from dataclasses import replace

import numpy as np
import pytest

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.studies.dataset.motion_bids.read_motion import read_motion
from exoid.studies.dataset.motion_bids.write_motion import write_motion
from study_folders import same

NAME = "sub-01_task-knee_tracksys-knee_acq-left_motion.tsv"
NAN = float("nan")


@pytest.fixture
def path(tmp_path):
    folder = tmp_path / "sub-01" / "motion"
    folder.mkdir(parents=True)
    return folder / NAME


def swing(seconds: float, top: float, rate: float = 100.0) -> Segment:
    time = np.arange(round(seconds * rate)) / rate
    angle = -np.pi / 2 + top * np.exp(-0.4 * time) * np.cos(5 * time)
    return Segment(time, raw_angle=angle, raw_angular_velocity=np.gradient(angle, time))


def everything() -> Recording:
    """Three segments: a gap, a torque in one alone, unknown columns and keys, lists with nan."""
    one, two, three = swing(3, 1.2), swing(2, 0.9), swing(4, 1.1)
    assert two.raw_angular_velocity is not None
    two.raw_angular_velocity[7] = np.nan
    notes = {"note": ("1e3", "", "a word", *[""] * (one.time.size - 3))}
    empty = {"note": ("",) * two.time.size}
    torque = np.linspace(0, 1, three.time.size) / 3
    segments = (
        replace(one, extra_columns=notes),
        replace(two, extra_columns=empty, begins=10.5),
        replace(three, extra_columns={"note": ("",) * three.time.size}, applied_torque=torque),
    )
    return Recording(
        segments,
        Subject(kind="leg", id="01", side="left", body_mass=77.1, added_mass=(0.0, 1.5, NAN)),
        Protocol(kind=("passive", "passive", "measured"), cycle_period=(NAN, NAN, 1.8)),
        Sensors(encoder_counts=4096.0, extra_keys={"maker": "somebody"}),
        {"fit": {"inertia": {"fixed": 0.4}}},
    )


def test_a_recording_that_is_written_and_read_is_the_same(path):
    write_motion(everything(), path, "knee")
    same(read_motion(path)[0], everything())


def test_the_segments_are_events_on_one_clock(path):
    write_motion(everything(), path, "knee")
    events = path.with_name(NAME.replace("_motion.tsv", "_events.tsv")).read_text().splitlines()
    assert events[0].split("\t") == ["onset", "duration", "trial_type", "sample"]
    rows = [line.split("\t") for line in events[1:]]
    assert [row[2:] for row in rows] == [["passive", "0"], ["passive", "300"], ["measured", "500"]]
    latency = np.array([float(line.split("\t")[0]) for line in path.read_text().splitlines()])
    assert latency[0] == 0.0
    assert (np.diff(latency) > 0).all()
    assert [float(row[0]) for row in rows] == [latency[int(row[3])] for row in rows]


def test_segments_cut_from_a_log_stay_where_they_lay_in_it(path):
    segments = (replace(swing(1, 1.2), begins=4.0), replace(swing(1, 1.0), begins=20.0))
    write_motion(Recording(segments), path, "knee")
    latency = [float(line.split("\t")[0]) for line in path.read_text().splitlines()]
    assert latency[100] == 16.0  # 20 - 4, exact in binary


def test_units_and_what_is_missing_are_stated(path):
    write_motion(everything(), path, "knee")
    told = json.loads(path.with_suffix(".json").read_text())
    assert (told["SamplingFrequency"], told["MissingValues"]) == (pytest.approx(100.0), "n/a")
    assert told["JNTANGChannelCount"] == 1
    channels = path.with_name(NAME.replace("_motion", "_channels")).read_text().splitlines()
    rows = {line.split("\t")[0]: line.split("\t") for line in channels}
    assert rows["raw_velocity_rad_s"][1:5] == ["y", "GYRO", "LeftKnee", "rad/s"]
    assert rows["torque_nm"][4] == "N m"
    assert "n/a" in path.read_text()


def write_others(path, channels, samples, told=None):
    """A data set by another's hand."""
    rows = [["name", "component", "type", "tracked_point", "units"], *channels]
    beside = path.with_name(path.name.replace("_motion", "_channels"))
    beside.write_text("\n".join("\t".join(row) for row in rows) + "\n")
    path.write_text("\n".join("\t".join(f"{x:.9g}" for x in row) for row in samples) + "\n")
    path.with_suffix(".json").write_text(json.dumps(told or {"SamplingFrequency": 100}))


def test_anothers_joint_angle_in_degrees_is_understood(path):
    leg = swing(3, 1.2)
    hip = ["hip", "n/a", "JNTANG", "LeftHip", "deg"]
    knee = ["flex", "n/a", "JNTANG", "LeftKnee", "deg"]
    samples = np.column_stack([np.zeros(300), np.degrees(leg.best_angle)])
    write_others(path, [hip, knee], samples)
    recording = read_motion(path)[0]
    (segment,) = recording.segments
    assert segment.raw_angle is not None
    np.testing.assert_allclose(segment.raw_angle, leg.best_angle, atol=1e-8)  # nine digits written
    np.testing.assert_allclose(segment.time, leg.time, atol=1e-12)


def test_anothers_latency_is_the_time_and_what_holds_for_all_stands_above(path):
    leg = swing(3, 1.2)
    late = leg.time * 1.5
    samples = np.column_stack([late, leg.best_angle])
    names = [["t0", "n/a", "LATENCY", "n/a", "s"], ["k", "n/a", "JNTANG", "RKnee", "rad"]]
    write_others(path, names, samples)
    path.with_suffix(".json").unlink()
    above = path.parents[2] / "task-knee_motion.json"
    above.write_text(json.dumps({"exoid": {"subject": {"side": "right"}}}))
    recording = read_motion(path)[0]
    np.testing.assert_allclose(recording.segments[0].time, late, atol=1e-8)
    assert recording.subject.side == "right"


def test_of_two_knees_the_one_of_the_side_that_is_told_is_taken(path):
    knees = [[side, "n/a", "JNTANG", f"{side}Knee", "rad"] for side in ("Right", "Left")]
    right, left = swing(3, 1.1), swing(3, 1.2)
    write_others(path, knees, np.column_stack([right.best_angle, left.best_angle]))
    (segment,) = read_motion(path)[0].segments
    np.testing.assert_allclose(segment.best_angle, left.best_angle, atol=1e-8)  # of acq-left
    untold = path.with_name(NAME.replace("_acq-left", ""))
    for ending in ("_motion.tsv", "_channels.tsv", "_motion.json"):
        named = path.with_name(path.name.replace("_motion.tsv", ending))
        named.rename(untold.with_name(untold.name.replace("_motion.tsv", ending)))
    with pytest.raises(ValueError, match=r"has no angle\. It holds: Right, Left") as refused:
        read_motion(untold)
    assert "call it raw_angle_deg in _channels.tsv" in str(refused.value)


@pytest.mark.parametrize(
    ("ending", "text", "said"),
    [
        ("_channels.tsv", None, "no _channels.tsv beside it names its columns"),
        ("_channels.tsv", "name\ttype\nlatency\tLATENCY\n", "line 1 has 4 cells, but _channels"),
        ("_channels.tsv", "name\ttype\n\tMISC\n", "line 2 has no name"),
        ("_motion.tsv", "", "holds no samples"),
        ("_motion.tsv", "0.0\t0.0\tx\t1.0\n", "line 1, column raw_angle_rad: 'x' is not a number"),
        ("_motion.json", "{", "is not valid JSON"),
        ("_motion.json", "[]", "holds no JSON object"),
        ("_motion.json", '{"exoid": []}', '"exoid" must be an object'),
        ("_motion.json", '{"exoid": {"subject": {"side": "up"}}}', "side is 'up'"),
        ("_events.tsv", "onset\tduration\tsample\n0\t1\t5\n", "begin at the samples [5] of 300"),
    ],
)
def test_what_cannot_be_read_is_said_in_a_line(path, ending, text, said):
    write_motion(Recording((swing(3, 1.2),)), path, "knee")
    damaged = path.with_name(NAME.replace("_motion.tsv", ending))
    damaged.unlink() if text is None else damaged.write_text(text)
    with pytest.raises(ValueError, match="sub-01") as refused:
        read_motion(path)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)
