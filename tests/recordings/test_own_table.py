"""Recordings on disk: nothing is lost, and whatever is wrong is named by file, line and column."""

import stat
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import read_table, write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import read_sidecar, write_sidecar

DATA = Path(__file__).parents[3] / "shared" / "data"
REAL = ["knee-drop", "motor-ringing", "motor-swing", "servo-drop"]
CONCEALED = ["p0582c", "p324de", "p44f4d", "pfab5a"]
SAMPLES = "0.00,-0.1\n0.01,-0.2\n0.02,-0.3\n"


@pytest.fixture
def write(tmp_path):
    """Puts a table and, where given, its sidecar on disk; returns the table's path."""

    def write(csv, toml=None):
        path = tmp_path / "swing.csv"
        path.write_bytes(csv if isinstance(csv, bytes) else csv.encode())
        if toml is not None:
            content = toml if isinstance(toml, bytes) else toml.encode()
            path.with_suffix(".toml").write_bytes(content)
        return path

    return write


def assert_same(one, other):
    """Every float to the last bit (-0.0 included), every key, every unknown column."""
    assert len(one.segments) == len(other.segments)
    for a, b in zip(one.segments, other.segments, strict=True):
        assert list(a.channels()) == list(b.channels())
        for name, samples in a.channels().items():
            assert samples.tobytes() == b.channels()[name].tobytes(), name
        assert a.extra_columns == b.extra_columns
    assert (one.subject, one.protocol, one.sensors) == (
        other.subject,
        other.protocol,
        other.sensors,
    )
    assert one.extra_tables == other.extra_tables


# What a file can hold


@pytest.mark.parametrize(
    "name", [f"real/{n}" for n in REAL] + [f"concealed/{n}" for n in CONCEALED]
)
def test_measured_and_concealed_recordings_read_without_a_note(name, tmp_path):
    path = DATA / f"{name}.csv"
    if not path.exists():
        pytest.skip(f"{path} is absent")
    recording, notes = read_table(path)
    rows = path.read_text().count("\n") - 1
    assert sum(segment.time.size for segment in recording.segments) == rows
    assert notes == ()
    write_table(recording, tmp_path / "copy.csv")
    assert_same(recording, read_table(tmp_path / "copy.csv")[0])


def one_of(entry):
    """Values that the field's metadata allow."""
    if "lower" in entry.metadata:
        return st.floats(entry.metadata["lower"], entry.metadata["upper"])
    return st.sampled_from(entry.metadata.get("choices") or (True, False))


def metadata(kind, segments, lists=()):
    """One table of the sidecar, each key present or not, lists where segments may differ."""
    values = {"extra_keys": st.dictionaries(st.just("mine"), st.integers())}
    for entry in known(kind):
        free = entry.metadata.get("choices", ()) is None
        value = st.text() if free else one_of(entry)
        many = st.tuples(*[value] * segments)
        if entry.name in ("segment_start", "segment_end"):
            value = many
        elif entry.name in lists:
            value = value | many
        values[entry.name] = st.none() | value
    return st.fixed_dictionaries(values)


@st.composite
def channels(draw, columns):
    """The fields of one segment: some of the channels, some samples missing."""
    times = draw(st.lists(st.floats(0, 1e6), min_size=2, max_size=6, unique=True))
    size = len(times)
    cell = st.text(st.characters(blacklist_categories=("C", "Zl", "Zp")))
    found = {"time": np.array(sorted(times))}
    for entry in known(Segment)[1:]:
        # An angle that jumps by a turn has turns added.
        upper = min(entry.metadata["upper"], 3.0 if "angle" in entry.name else 14.0)
        value = st.floats(-upper, upper) | st.just(np.nan)
        samples = np.array(draw(st.lists(value, min_size=size, max_size=size)))
        if entry.name == "angle" or draw(st.booleans()):
            samples[draw(st.integers(0, size - 1))] = -0.0
            found[entry.name] = samples
    cells = {c: tuple(draw(st.lists(cell, min_size=size, max_size=size))) for c in columns}
    return {**found, "extra_columns": cells}


@st.composite
def recordings(draw):
    """The fields of a recording: its segments, its three tables, unknown tables."""
    count = draw(st.integers(1, 3))
    columns = draw(st.lists(st.sampled_from(["a note", "marker"]), unique=True))
    subject = draw(metadata(Subject, count, ("added_mass",)))
    return (
        [draw(channels(columns)) for _ in range(count)],
        {**subject, "kind": "rig", "added_mass_distance": None},
        draw(metadata(Protocol, count, ("kind", "cycle_period", "thigh_angle"))),
        draw(metadata(Sensors, count)),
        draw(st.dictionaries(st.just("lab"), st.just({"room": 3, "tags": ["x", 1.5]}))),
    )


@settings(max_examples=60, deadline=None)
@given(recordings())
def test_what_was_written_is_read_back_to_the_last_bit(tmp_path_factory, drawn):
    segments, subject, protocol, sensors, tables = drawn
    recording = Recording(
        tuple(Segment(**fields) for fields in segments),
        Subject(**subject),
        Protocol(**protocol),
        Sensors(**sensors),
        tables,
    )
    path = tmp_path_factory.mktemp("trip") / "trip.csv"
    write_table(recording, path)
    assert_same(recording, read_table(path)[0])


def test_degrees_become_radians(write):
    path = write("time_s,angle_deg,velocity_deg_s,acceleration_deg_s2\n0,-90,180,360\n1,0,0,0\n")
    segment = read_table(path)[0].segments[0]
    assert segment.angle[0] == -np.pi / 2
    assert segment.angular_velocity[0] == np.pi
    assert segment.angular_acceleration[0] == 2 * np.pi


def test_empty_cells_are_missing_samples(write):
    path = write("time_s,angle_rad,velocity_rad_s,torque_nm\n0,,,\n1,,2,\n2,-0.5,,3\n3,-0.6,,\n")
    segment = read_table(path)[0].segments[0]
    np.testing.assert_array_equal(segment.angle, [np.nan, np.nan, -0.5, -0.6])
    np.testing.assert_array_equal(segment.angular_velocity, [np.nan, 2, np.nan, np.nan])
    np.testing.assert_array_equal(segment.applied_torque, [np.nan, np.nan, 3, np.nan])


def test_a_channel_that_is_empty_throughout_a_segment_was_not_measured_in_it(write):
    rows = "0,0,-0.1,\n1,0,-0.2,\n0,1,-0.1,4\n1,1,-0.2,5\n"
    first, second = read_table(write(f"time_s,segment,angle_rad,torque_nm\n{rows}"))[0].segments
    assert first.applied_torque is None
    np.testing.assert_array_equal(second.applied_torque, [4, 5])


def test_a_column_that_is_empty_throughout_is_left_out_and_named(write):
    recording, notes = read_table(write("time_s,angle_rad,torque_nm\n0,-0.1,\n1,-0.2,\n", ""))
    assert recording.segments[0].applied_torque is None
    assert len(notes) == 1
    assert "column torque_nm holds no number and is left out" in notes[0]


@pytest.mark.parametrize(
    "content",
    [
        b"\xef\xbb\xbftime_s,angle_rad\n0,-1\n1,-2\n",
        b"time_s,angle_rad\r\n0,-1\r\n1,-2\r\n",
        b"time_s,angle_rad\r0,-1\r1,-2",
        b'"time_s", "angle_rad"\n0, -1\n 1 , -2\n',
        b"time_s,angle_rad\n0,-1\n1,-2\n\n\n",
        b"angle_rad,time_s\n-1.0e0,.0\n-2.,+1E0\n",
        b"time_s,angle_rad,note\n0,-1,a\n1,-2,b\n\n",
    ],
)
def test_other_programs_ways_of_writing_a_csv_are_read(write, content):
    segment = read_table(write(content))[0].segments[0]
    np.testing.assert_array_equal(segment.time, [0, 1])
    np.testing.assert_array_equal(segment.angle, [-1, -2])


def test_unknown_columns_and_keys_are_kept_and_named_with_the_nearest_known(write, tmp_path):
    csv = 'time_s,angle_rad,velocity_rads,who\n0,-0.1,1.50,"a, b"\n1,-0.2,,c\n'
    subject = '[subject]\nhieght_m = 1.8\nweight_kg = 75\nmood = "good"\n'
    toml = subject + "[sensor]\nx = [1]\n[protocol]\nheight_m = 2\n"
    path = write(csv, toml)
    recording, notes = read_table(path)
    assert recording.segments[0].extra_columns == {
        "velocity_rads": ("1.50", ""),
        "who": ("a, b", "c"),
    }
    assert recording.subject.extra_keys == {"hieght_m": 1.8, "weight_kg": 75, "mood": "good"}
    assert recording.extra_tables == {"sensor": {"x": [1]}}
    said = "\n".join(notes)
    assert "column velocity_rads is kept as text. Did you mean velocity_rad_s?" in said
    assert "hieght_m in [subject] is kept, but not used. Did you mean height_m?" in said
    assert "weight_kg in [subject] is kept, but not used. Did you mean body_mass_kg?" in said
    assert "[sensor] is kept, but not used. Did you mean sensors?" in said
    assert "height_m in [protocol] is kept, but not used. It belongs in [subject]." in said
    assert len(notes) == 7
    write_table(recording, tmp_path / "copy.csv")
    assert_same(recording, read_table(tmp_path / "copy.csv")[0])


def test_keys_of_older_sidecars_are_kept_without_a_word(write):
    toml = (
        "[subject]\nshank_length_m = 0.42\nshank_radius_m = 0.06\n[protocol]\ntorque_known = true\n"
    )
    recording, notes = read_table(write(f"time_s,angle_rad\n{SAMPLES}", toml))
    assert recording.subject.shank_length == 0.42
    assert recording.subject.extra_keys == {"shank_radius_m": 0.06}
    assert recording.protocol.torque_known is True
    assert notes == ()


def test_a_word_in_the_place_of_true_or_false_is_refused(write):
    toml = '[protocol]\ntorque_known = "no"\n'
    with pytest.raises(ValueError, match="it must be true or false, without quotes"):
        read_table(write(f"time_s,angle_rad\n{SAMPLES}", toml))


def test_a_clock_that_does_not_restart_is_kept_and_named(write):
    rows = "0,0,-0.1\n1,0,-0.2\n2,1,-0.1\n3,1,-0.2\n"
    recording, notes = read_table(write(f"time_s,segment,angle_rad\n{rows}", ""))
    np.testing.assert_array_equal(recording.segments[1].time, [2, 3])
    assert len(notes) == 1
    assert "time_s starts at 2 s, not at 0, in segment 1" in notes[0]


def test_a_missing_sidecar_means_that_nothing_is_known(write):
    recording, notes = read_table(write(f"time_s,angle_rad\n{SAMPLES}"))
    assert recording.subject == Subject()
    assert recording.protocol == Protocol()
    assert len(notes) == 1
    assert "swing.toml: there is none" in notes[0]


def test_keys_take_a_list_where_segments_may_differ(write):
    toml = """
    [subject]
    added_mass_kg = [0.0, 1]
    added_mass_distance_m = [0.3, 0.4]
    [protocol]
    kind = ["passive", "active"]
    cycle_period_s = [2.0, 3.0]
    """
    rows = "0,0,-0.1\n1,0,-0.2\n0,1,-0.1\n1,1,-0.2\n"
    recording, _ = read_table(write(f"time_s,segment,angle_rad\n{rows}", toml))
    assert recording.subject.added_mass == (0.0, 1.0)
    assert recording.subject.added_mass_distance == (0.3, 0.4)
    assert recording.protocol.kind == ("passive", "active")
    assert recording.cycle_period(1) == 3.0


def test_a_recording_not_yet_split_at_its_marks_is_read_back(tmp_path):
    protocol = Protocol(cycle_period=(float("nan"), 2.0), segment_start=(0.0, 0.1))
    write_table(drop(protocol=protocol), tmp_path / "swing.csv")
    recording, notes = read_table(tmp_path / "swing.csv")
    assert repr(recording.protocol) == repr(protocol)  # nan is not equal to itself
    assert notes == ()


def test_a_sidecar_is_read_and_written_without_a_table(tmp_path):
    path = tmp_path / "log.toml"
    subject = Subject(height=1.8, added_mass=np.float64(0.5), extra_keys={"shoe": 43})
    protocol = Protocol(
        kind=("passive", "active"), segment_start=(0.0, 9.0), segment_end=(8.0, 17.0)
    )
    write_sidecar(subject, protocol, Sensors(encoder_counts=4096.0), path)
    *tables, notes = read_sidecar(path)
    assert tables == [subject, protocol, Sensors(encoder_counts=4096.0)]
    assert len(notes) == 1
    assert "unknown shoe in [subject]" in notes[0]


# What is refused


def refusal(path):
    with pytest.raises(ValueError, match="swing") as caught:
        read_table(path)
    message = str(caught.value)
    assert "\n" not in message
    assert message.startswith(str(path.with_suffix("")))
    return message


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "the file is empty"),
        (b"time_s,angle_rad\n", "holds a header but no samples"),
        (b"time_s,angle_rad\n\n\n", "holds a header but no samples"),
        (b"x" * 200_000, "holds no table of numbers"),
        (b"time_s," + b"x" * 200_000, "holds no table of numbers"),
        (b"angle_rad\n0\n", "has no time"),
        (b"0,-0.1\n1,-0.2\n", "has no time. It holds: 1, 2. Name it: columns="),
        (b"time_s,velocity_rad_s\n0,1\n", "has no angle"),
        (b"time_s,angle_rad\n0,0,-0,1\n0,1,-0,2\n", "line 2 has 4 cells, but the header names 2"),
        (b"time_s,angle_rad\n0,-0.1\n1\n", "line 3 has 1 cells"),
        (b"time_s,angle_rad\n0,-0.1\n1,-0.2,\n", "line 3 has 3 cells"),
        (b"time_s,angle_rad,x\n0,-0.1,a\n1,-0.2\n", "line 3 has 2 cells"),
        (b"time_s,angle_rad\n0,-0.1\n\n1,-0.2\n", "line 3 is empty"),
        (b"time_s,angle_rad\n\n0,-0.1\n1,-0.2\n", "line 2 is empty"),
        (b",time_s,angle_rad\n0,0,-0.1\n", "column 1 has no name"),
        (b"time_s,angle_rad,angle_rad\n0,1,1\n", "column angle_rad is there twice"),
        (b"time_s,angle_rad,angle_deg\n0,1,1\n", "angle_deg and angle_rad are the same quantity"),
        (b"time_s,angle_rad\n0,-0.1\n1,left\n", "line 3, column angle_rad: 'left' is not a number"),
        (b"time_s,angle_rad\n0,-0.1\n1,-0.2x\n", "line 3, column angle_rad: '-0.2x'"),
        (b"time_s,angle_rad\n0,-0.1\n1,1-2\n", "line 3, column angle_rad: '1-2'"),
        (b"time_s,angle_rad\n0,-0.1\n1, 1 2\n", "line 3, column angle_rad: ' 1 2'"),
        (b"time_s,angle_rad\n0,-0.1\n1,inf\n", "Leave the cell empty where a sample is missing"),
        (b"time_s,angle_rad\n0,-0.1\n1,-Infinity\n", "'-Infinity' is not a number"),
        (b"time_s,angle_rad,x\n0,-0.1,a\n1,oops,b\n", "line 3, column angle_rad: 'oops'"),
        (b"time_s,angle_rad\n0,-0.1\n1,1_0\n", "'1_0' is not a number"),
        (b"time_s,angle_rad\n0,-0.1\n1,1e999\n", "line 3: angle_rad in segment 0, sample 1 is inf"),
        (b'time_s,angle_rad,x\n0,-0.1,"a\n1,-0.2,b\n', "Check the quotes"),
        (b"time_s,angle_rad\n0,-0.1\n\xff\xfe,1\n", "is not UTF-8 text (byte 0xff at 24)"),
        (b"PK\x03\x04\x00\x00time", "holds binary data"),
        (b"time_s,angle_rad\n0,-0.1\n0.2,-0.1\n0.1,-0.2\n", "line 4: time_s must increase"),
        (b"time_s,angle_rad\n0,-0.1\n,-0.2\n", "line 3: time_s is missing in segment 0, sample 1"),
        (b"time_s,angle_rad\n0,0\n1,-90\n", "line 3: angle_rad in segment 0, sample 1 is -90 rad"),
        (b"time_s,angle_rad\n0,0\n1,-3.7\n", "name the column angle_deg, or say columns="),
        (b"time_s,angle_deg\n0,0\n1,2048\n", "(angle_deg: read as degrees.)"),
        (b"time_s,angle_rad\n0,-0.1\n", "at least 2 are needed"),
        (b"time_s,angle_rad\n,-0.1\n,-0.2\n", "line 2: time_s is missing"),
        (b"time_s,angle_rad\n0,\n1,\n", "has no angle"),
        (
            b"time_s,segment,angle_rad\n0,2,0\n1,2,0\n",
            "line 2, column segment: 2, where 0 is expected",
        ),
        (
            b"time_s,segment,angle_rad\n0,1,0\n1,1,0\n0,3,0\n1,3,0\n",
            "line 4, column segment: 3, where 2 or 1 is expected",
        ),
        (
            b"time_s,segment,angle_rad\n0,0,0\n1,0,0\n0,2,0\n1,2,0\n",
            "line 4, column segment: 2, where 1",
        ),
        (
            b"time_s,segment,angle_rad\n0,0,0\n0,1,0\n1,0,0\n1,1,0\n",
            "line 4, column segment: 0, where 2",
        ),
        (b"time_s,segment,angle_rad\n0,0,0\n1,0.5,0\n", "line 3, column segment: 0.5"),
        (b"time_s,segment,angle_rad\n0,0,0\n1,,0\n", "line 3, column segment: empty"),
    ],
)
def test_a_bad_table_is_refused_by_file_and_line(write, content, message):
    assert message in refusal(write(content, ""))


def test_segments_may_count_from_one(write):
    rows = "0,{0},-0.1\n1,{0},-0.2\n0,{1},-0.3\n1,{1},-0.4\n"
    table = "time_s,segment,angle_rad\n" + rows
    usual, _ = read_table(write(table.format(0, 1)))
    found, notes = read_table(write(table.format(1, 2)))
    assert_same(found, usual)
    assert "segments count from 1 in this file" in notes[0]


def test_a_bad_sample_of_a_later_segment_is_named_by_its_line(write):
    rows = "0,0,-0.1\n1,0,-0.2\n0,1,-0.1\n1,1,-50\n"
    message = refusal(write(f"time_s,segment,angle_rad\n{rows}"))
    assert "line 5: angle_rad in segment 1, sample 1 is -50 rad" in message


@pytest.mark.parametrize(
    ("toml", "message"),
    [
        ("[subject]\nheight_m 1.8\n", "is not valid TOML: Expected '='"),
        ("[subject\n", "is not valid TOML"),
        ("[subject]\nbody_mass_kg = 77,5\n", "no comma: body_mass_kg = 77.5"),
        ("[subject]\nkind = leg\n", 'Words stand in quotes: kind = "leg".'),
        ('[subject]\nid = "a"\nside = left # or right\n', 'Words stand in quotes: side = "left".'),
        (b"\xff[subject]", "is not UTF-8 text"),
        ("subject = 3\n", "subject must be a table: write [subject]"),
        ('[subject]\nheight_m = "1.8"\n', "height_m in [subject] is '1.8'; it must be a number"),
        ("[subject]\nheight_m = true\n", "height_m in [subject] is True; it must be a number"),
        ("[subject]\nheight_m = 180\n", "height_m is 180 m; it must lie between 0.4 and 2.6"),
        ("[subject]\nheight_m = nan\n", "height_m is nan m"),
        (f"[subject]\nheight_m = {10**400}\n", "height_m is 1e+300 m"),
        ("[subject]\nheight_m = [1.8]\n", "height_m in [subject] is a list; it takes one value"),
        ("[subject]\nkind = 1\n", "kind in [subject] is 1; it must be a text in quotes"),
        ('[subject]\nkind = "dog"\n', "kind is 'dog'; it can be leg or rig"),
        ("[subject]\nadded_mass_kg = []\n", "added_mass_kg in [subject] is an empty list"),
        ("[subject]\nadded_mass_distance_m = 0.3\n", "without added_mass_kg"),
        ('[protocol]\nkind = "resting"\n', "it can be passive or active or measured"),
        ("[protocol]\ncycle_period_s = [2.0, 2.0]\n", "cycle_period_s lists 2 values for 1"),
        ('[protocol]\ncycle_period_s = ["2"]\n', "cycle_period_s in [protocol] is '2'"),
        ("[protocol]\nsegment_start_s = 1.0\n", "segment_start_s in [protocol] takes a list"),
        ("[sensors]\nencoder_counts = -1\n", "encoder_counts is -1 counts per turn"),
    ],
)
def test_a_bad_sidecar_is_refused_by_file_and_key(write, toml, message):
    said = refusal(write(f"time_s,angle_rad\n{SAMPLES}", toml))
    assert message in said
    assert "swing.toml: " in said


def test_a_sidecar_with_a_byte_order_mark_is_read(write):
    path = write(f"time_s,angle_rad\n{SAMPLES}", b"\xef\xbb\xbf[subject]\r\nheight_m = 1.8\r\n")
    assert read_table(path)[0].subject.height == 1.8


def test_what_is_no_file_is_refused(tmp_path):
    assert "No such file or directory. Check the name." in refusal(tmp_path / "swing.csv")
    (tmp_path / "swing.csv").mkdir()
    assert "this is a directory" in refusal(tmp_path / "swing.csv")
    assert "Name the .csv beside it" in refusal(tmp_path / "swing.toml")
    with pytest.raises(ValueError, match=r"absent\.toml: cannot be read"):
        read_sidecar(tmp_path / "absent.toml")


# What writing leaves behind


def drop(**tables):
    return Recording((Segment(np.arange(3) * 0.1, angle=np.array([-0.1, -0.2, -0.3])),), **tables)


def test_a_failure_leaves_the_files_that_were_there(tmp_path, monkeypatch):
    path = tmp_path / "swing.csv"
    write_table(drop(subject=Subject(height=1.8)), path)
    before = {file: file.read_bytes() for file in tmp_path.iterdir()}

    def full(*_):
        raise OSError("no space left on device")

    monkeypatch.setattr("exoid.files.replacing.os.fsync", full)
    with pytest.raises(OSError, match="no space left"):
        write_table(drop(), path)
    assert {file: file.read_bytes() for file in tmp_path.iterdir()} == before


def test_a_rewritten_recording_keeps_nothing_of_the_old_sidecar(tmp_path):
    path = tmp_path / "swing.csv"
    write_table(drop(subject=Subject(height=1.8)), path)
    write_table(drop(), path)
    assert read_table(path)[0].subject == Subject()


def test_a_written_file_can_be_read_by_whom_the_umask_allows(tmp_path):
    (tmp_path / "other").touch()
    write_table(drop(), tmp_path / "swing.csv")
    modes = {stat.S_IMODE(file.stat().st_mode) for file in tmp_path.iterdir()}
    assert len(modes) == 1


@pytest.mark.parametrize("name", ["swing.toml", "swing", "swing.txt"])
def test_a_recording_is_written_to_a_csv_only(tmp_path, name):
    with pytest.raises(ValueError, match=r"ends in \.csv"):
        write_table(drop(), tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_column_may_not_take_a_known_name(tmp_path):
    segment = Segment(np.arange(2.0), angle=np.zeros(2), extra_columns={"angle_rad": ("1", "2")})
    with pytest.raises(ValueError, match="column angle_rad is there twice"):
        write_table(Recording((segment,)), tmp_path / "swing.csv")
    assert list(tmp_path.iterdir()) == []


# What it costs


def test_a_large_table_is_read_in_c_not_in_python(write):
    rows = 100_000
    samples = np.column_stack([np.arange(rows) * 0.01, np.sin(np.arange(rows))])
    lines = "\n".join(f"{t!r},{angle!r}" for t, angle in samples.tolist())
    path = write(f"time_s,angle_rad\n{lines}\n")
    before = time.process_time()
    segment = read_table(path)[0].segments[0]
    assert time.process_time() - before < 2.0  # 0.1 s here; a loop over cells takes longer
    np.testing.assert_array_equal(segment.angle, samples[:, 1])


def test_reading_a_file_does_not_load_jax():
    code = "import sys, exoid.recordings.formats.own_table; sys.exit('jax' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_nan_is_a_missing_sample_as_an_empty_cell_is(tmp_path):
    rows = ["0.0,-0.1,nan,nan", "0.1,NaN,0.2,", "0.2,-0.3, nan,so"]
    path = tmp_path / "numpy.csv"
    path.write_text("\n".join(["time_s,raw_angle_rad,raw_velocity_rad_s,note", *rows]) + "\n")
    (segment,) = load(path).recording.segments
    assert np.isnan(segment.raw_angle).tolist() == [False, True, False]
    assert np.isnan(segment.raw_angular_velocity).tolist() == [True, False, True]
    assert segment.extra_columns["note"] == ("nan", "", "so")
