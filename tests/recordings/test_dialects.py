"""A table in any dialect says what its numbers say; how it was understood is said."""

import csv
import io
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exoid.recordings.loading.load import load

TIME = np.arange(40) * 0.01
ANGLE = np.round(-90 + 70 * np.exp(-TIME) * np.cos(5 * TIME), 3)  # deg, of a leg let go
RATE = np.round(-70 * np.exp(-TIME) * (np.cos(5 * TIME) + 5 * np.sin(5 * TIME)), 3)  # deg/s
GERMAN = (("Zeit (s)", "Kniewinkel (°)"), ("Zeit", "Kniewinkel"))
ENGLISH = (("Time (s)", "Knee Flexion (deg)"), ("time", "knee_angle_r"))
UNITS = ("s", "deg")


@pytest.fixture
def write(tmp_path):
    """Puts the content of a table on disk; returns its path."""

    def write(content, name="leg.csv", sidecar=None):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        if sidecar is not None:
            path.with_suffix(".toml").write_text(sidecar)
        return path

    return write


def lines(columns, separator=",", decimal="."):
    rows = zip(*columns, strict=True)
    return [separator.join(f"{each}".replace(".", decimal) for each in row) for row in rows]


def check(path, **options):
    """The one segment of a file, which holds the motion above."""
    loaded = load(path, **options)
    (segment,) = loaded.recording.segments
    np.testing.assert_allclose(segment.time, TIME, rtol=0, atol=1e-12)  # rounding of a division
    np.testing.assert_allclose(segment.raw_angle, np.radians(ANGLE), rtol=1e-15)  # one product
    return segment, "\n".join(loaded.notes)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-8", "cp1252", "utf-16"])
@pytest.mark.parametrize("ends", ["\n", "\r\n"])
def test_what_a_german_excel_exports_is_read(write, encoding, ends):
    rows = ["Zeit (s);Kniewinkel (°)", *lines((TIME, ANGLE), ";", ",")]
    _, said = check(write((ends.join(rows) + ends).encode(encoding)))
    assert "Zeit (s) as time_s (in s); Kniewinkel (°) as raw_angle_rad (in °)" in said


def test_times_of_day_do_not_hide_the_semicolon(write):
    clock = [f"2026-03-02 10:11:{12 + each:.6f}" for each in TIME]
    check(write("\n".join(["Zeit;Kniewinkel (°)", *lines((clock, ANGLE), ";", ",")])))


def test_points_of_thousands_are_read(write):
    clock = [f"{1000 * each + 990:,.1f}".translate({44: ".", 46: ","}) for each in TIME]
    rows = map(";".join, zip(clock, lines((ANGLE,), ";", ","), strict=True))
    loaded = load(write("\n".join(["Zeit (ms);Kniewinkel (°)", *rows])))
    np.testing.assert_allclose(loaded.recording.segments[0].time, TIME + 0.99, atol=1e-12)


@pytest.mark.parametrize("decimal", [".", ","])
def test_one_column_alone_is_read_with_the_rate_of_its_sidecar(write, decimal):
    rows = ["Kniewinkel links (Grad)", *lines((ANGLE,), ";", decimal)]
    rate = float(1 / np.diff(TIME).mean())
    path = write("\n".join(rows), sidecar=f"[sensors]\nsample_rate_hz = {rate!r}\n")
    _, said = check(path)
    assert "Kniewinkel links (Grad) as raw_angle_rad (in deg)" in said


@st.composite
def dialects(draw):
    """A way of writing the table, and whether its numbers can be told from its separators."""
    decimal = draw(st.sampled_from(".,"))
    separator = draw(st.sampled_from([";", "\t", "|", ","]))
    quoted = draw(st.booleans()) or separator == decimal
    return {
        "decimal": decimal,
        "separator": separator,
        "quoting": csv.QUOTE_ALL if quoted else csv.QUOTE_MINIMAL,
        "ends": draw(st.sampled_from(["\n", "\r\n", "\r"])),
        "encoding": draw(st.sampled_from(["utf-8", "utf-8-sig", "cp1252", "utf-16"])),
        "names": draw(st.sampled_from([*GERMAN, *ENGLISH])),
        "units": draw(st.booleans()),
        "preamble": draw(
            st.lists(st.sampled_from(["Trial 3", "Subject;12;", "", "rate,100", "x"]))
        ),
        "blank": draw(st.integers(0, 2)),
        "extra": draw(st.booleans()),
        "trailing": draw(st.booleans()),
        "missing": draw(st.sampled_from(["", "NaN", "n/a"])),
    }


@settings(max_examples=200)
@given(dialects())
def test_every_dialect_gives_the_same_recording(tmp_path_factory, way):
    text = io.StringIO()
    writer = csv.writer(
        text, delimiter=way["separator"], lineterminator="\n", quoting=way["quoting"]
    )
    end = [""] if way["trailing"] else []
    writer.writerow([*way["names"], *(["Remark"] if way["extra"] else []), *end])
    if way["units"]:
        writer.writerow([*UNITS, *([""] if way["extra"] else []), *end])
    for number, row in enumerate(zip(TIME, ANGLE, strict=True)):
        cells = [repr(float(each)).replace(".", way["decimal"]) for each in row]
        if number == 7:
            cells[1] = way["missing"]
        writer.writerow([*cells, *(["left"] if way["extra"] else []), *end])
    content = "\n".join([*way["preamble"], text.getvalue()]) + "\n" * way["blank"]
    path = tmp_path_factory.mktemp("dialect") / "leg.csv"
    path.write_bytes(content.replace("\n", way["ends"]).encode(way["encoding"]))
    (segment,) = load(path).recording.segments
    expected = np.radians(ANGLE)
    expected[7] = np.nan
    np.testing.assert_array_equal(segment.time, TIME)
    np.testing.assert_array_equal(segment.raw_angle, expected)


def test_columns_are_separated_by_blanks_below_a_comment(write):
    rows = ["# time knee_angle gyro_z", *lines((TIME, ANGLE, RATE), "   ")]
    segment, said = check(write("\n".join(rows), "leg.txt"))
    np.testing.assert_allclose(segment.raw_angular_velocity, np.radians(RATE), rtol=1e-15)
    assert "gyro_z as raw_velocity_rad_s (in deg/s by its size)" in said


def test_radians_are_told_from_degrees_by_their_size_and_it_is_said(write):
    rows = ["t,knee", *lines((TIME, np.radians(ANGLE)))]
    _, said = check(write("\n".join(rows)))
    assert "knee as raw_angle_rad (in rad by its size)" in said


@pytest.mark.parametrize(
    ("name", "cells"),
    [
        ("Time (ms)", [f"{each * 1000:.0f}" for each in TIME]),
        ("time_ms", [f"{each * 1000:.0f}" for each in TIME]),
        ("timestamp [us]", [f"{each * 1e6:.0f}" for each in TIME]),
        ("timestamp", [f"2026-11-21T10:00:{each:09.6f}" for each in TIME]),
        ("timestamp", [f"21.11.2026 10:00:{each:06.3f}" for each in TIME]),
        ("timestamp", [f"2026-11-21T10:00:{each:09.6f}+01:00" for each in TIME]),
        ("timestamp", [f"2026-11-21 10:00:{each:09.6f} UTC" for each in TIME]),
        (
            "timestamp",
            [
                f"2026-10-25T{2 - (at > 9)}:00:{TIME[at]:06.3f}+0{2 - (at > 9)}".replace("T", "T0")
                for at in range(40)
            ],
        ),
        ("Uhrzeit", [f"9:59:{59 + each:06.3f}" if each < 1 else "" for each in TIME]),
        ("Uhrzeit", [f"10:00:{each:06.3f}-0530" for each in TIME]),
    ],
)
def test_times_come_in_seconds_whatever_they_were(write, name, cells):
    rows = [f"{name};knee", *lines((cells, ANGLE), ";")]
    check(write("\n".join(rows)))


@pytest.mark.parametrize("head", ["{}", "{} +02:00"])
def test_a_night_runs_on_over_midnight_and_it_is_said(write, head):
    clock = [f"23:59:{59.8 + at:06.3f}" if at < 0.195 else f"00:00:{at - 0.2:06.3f}" for at in TIME]
    rows = ["time;knee", *lines(([head.format(each) for each in clock], ANGLE), ";")]
    _, said = check(write("\n".join(rows)))
    assert "time as time_s (in s since the first, over midnight at line 22)" in said


def test_times_that_go_back_by_less_than_half_a_day_are_no_midnight(write):
    clock = [f"10:00:{at:06.3f}" if at < 0.195 else f"09:00:{at:06.3f}" for at in TIME]
    with pytest.raises(ValueError, match="line 22: time_s must increase"):
        load(write("\n".join(["time;knee", *lines((clock, ANGLE), ";")])))


@pytest.mark.parametrize(
    ("usual", "other", "said"),
    [
        ("2026-11-21T10:00:{}", "2026-11-21T10:00:{}Z", "tells a time zone, but line 2 tells none"),
        ("2026-11-21T10:00:{}Z", "2026-11-21T10:00:{}", "tells no time zone, but line 2 tells one"),
        ("10:00:{}", "10:00:{}+01:00", "tells a time zone, but line 2 tells none"),
        ("10:00:{}", "2026-11-21T10:00:{}", "tells a date, but line 2 tells none"),
        ("10:00:{}", "10:00:{}x", "is no time, but line 2 holds '10:00:00.000'"),
    ],
)
def test_a_time_unlike_the_first_is_refused_by_its_line(write, usual, other, said):
    clock = [(other if at > 0.295 else usual).format(f"{at:06.3f}") for at in TIME]
    with pytest.raises(ValueError, match=rf"line 32, column time: '{re.escape(clock[30])}' {said}"):
        load(write("\n".join(["time;knee", *lines((clock, ANGLE), ";")])))


def test_a_file_without_a_time_takes_the_rate_of_its_sidecar(write):
    path = write("\n".join(["frame,knee_angle", *lines((range(40), ANGLE))]))
    with pytest.raises(ValueError, match=r"has no time\. It holds: frame, knee_angle"):
        load(path)
    path.with_suffix(".toml").write_text("[sensors]\nsample_rate_hz = 100\n")
    assert "samples are taken 100 times a second" in check(path)[1]


def test_motion_capture_repeats_names_below_its_groups(write):
    head = ["Joints", "100", ",,LKneeAngles,,", "Frame,Sub Frame,X,Y,Z", ",,deg,deg,deg"]
    rows = lines((range(40), [0] * 40, ANGLE, ANGLE, ANGLE))
    path = write("\n".join([*head, *rows]), sidecar="[sensors]\nsample_rate_hz = 100\n")
    assert "LKneeAngles.X as raw_angle_rad (in deg)" in check(path)[1]


def test_trials_of_any_name_become_segments(write):
    rows = [f"{t},{a},{'first' if n < 20 else 'second'}"
            for n, (t, a) in enumerate(zip(TIME, ANGLE, strict=True))]  # fmt: skip
    recording = load(write("\n".join(["t,knee,trial", *rows]))).recording
    assert [each.time.size for each in recording.segments] == [20, 20]


def test_what_follows_an_empty_line_is_left_out_and_said(write):
    rows = ["t,knee", *lines((TIME, ANGLE)), "", "mean,std", "1,2"]
    _, said = check(write("\n".join(rows)))
    assert "the samples end at the empty line 42; what follows it is left out" in said


# A map of columns


def test_a_map_names_columns_on_the_command_and_in_the_sidecar(write):
    content = "\n".join(["a,b,knee", *lines((TIME, ANGLE, np.zeros(40)))])
    check(write(content), columns={"time_s": "a", "raw_angle_deg": "b"})
    path = write(content, sidecar='[columns]\ntime_s = "a"\nraw_angle_deg = "b"\n')
    _, said = check(path)
    assert "not read: knee" in said
    assert "columns" not in load(path).recording.extra_tables


def test_columns_without_names_are_named_by_their_numbers(write):
    path = write("\n".join(lines((TIME, ANGLE))))
    check(path, columns={"time_s": "1", "raw_angle_deg": "2"})


def test_a_map_says_the_unit_or_leaves_it_to_the_file(write):
    path = write("\n".join(["t,b (deg)", *lines((TIME, ANGLE))]))
    check(path, columns={"raw_angle": "b (deg)"})
    check(path, columns={"raw_angle_deg": "b (deg)"})


def test_exoids_own_columns_are_read_in_any_dialect(write):
    rows = ["time_s;raw_angle_deg;marker", *lines((TIME, ANGLE, ["x"] * 40), ";", ",")]
    segment, said = check(write("\n".join(rows)))
    assert set(segment.extra_columns["marker"]) == {"x"}
    assert "unknown column marker is kept as text" in said


@pytest.mark.parametrize(
    "names",
    [
        ("time", "angle", "gyro_dps"),
        ("time_s", "angle", "gyro_z_deg/s"),
        ("time_s", "knee_deg", "gyro_dps"),
    ],
)
def test_a_time_of_exoids_name_hides_no_other_name(write, names):
    rows = [",".join(names), *lines((TIME, ANGLE, RATE))]
    segment, _ = check(write("\n".join(rows)))
    np.testing.assert_allclose(segment.raw_angular_velocity, np.radians(RATE), rtol=1e-14)


# What is asked for or refused


@pytest.mark.parametrize(
    ("content", "options", "said"),
    [
        ("t,knee_angle_r,knee_angle_l\n0,1,2\n1,1,2\n", {}, "several columns can be the angle"),
        ("time,t,knee\n0,1,2\n1,1,2\n", {}, "several columns can be the time: time, t"),
        ("t,hip\n0,1\n1,1\n", {}, 'It holds: t, hip. Name it: columns={"raw_angle_deg": "hip"}'),
        ("t,hip (rad)\n0,1\n1,1\n", {}, 'Name it: columns={"raw_angle_rad": "hip (rad)"}'),
        ("t,hip,toe\n0,1,1\n1,1,1\n", {}, 'Name it: columns={"raw_angle_deg": "..."}'),
        ("t,gyro_x_dps\n0,1\n1,1\n", {}, "has no angle, and a turning rate alone is not enough"),
        ("time_s,raw_angel_deg\n0,1\n1,1\n", {}, "Did you mean raw_angle_deg? Name it: columns="),
        ("t;knee\n0;1\n1;1\n2;left\n3;1\n", {}, "line 4, column knee: 'left' is not a number"),
        ("t;knee\n0;1\n1;1\n2;1;5\n3;1\n", {}, "line 4 has 3 cells, but the samples above have 2"),
        ("t;knee\n0;1\n1;1\n2;1\n3\n", {}, "It is the last one: is the end of the file lost?"),
        ("t,knee\n0,0,1,5\n1,0,2,5\n", {}, "decimal commas between commas"),
        ("t;knee (rad)\n0;-20\n1;-21\n", {}, "line 2: raw_angle_rad in segment 0, sample 0 is -20"),
        ("t;knee (m)\n0;-20\n1;-21\n", {}, "column knee (m) is in m, but raw_angle_rad is in rad"),
        ("t;knee\n0;1\n", {}, "segment 0 has 1 sample; at least 2 are needed"),
        ("t;knee\n0;1\n0;2\n", {}, "line 3: time_s must increase"),
        ("Hello.\nThis is no table.\n", {}, "holds no table of numbers"),
        ("t,k\n0,1\n1,1\n", {"raw_angle_deg": "knee"}, "has no column 'knee' for raw_angle_deg."),
        ("t,k\n0,1\n1,1\n", {"raw_angel_deg": "k"}, "Did you mean raw_angle_deg?"),
    ],
)
def test_a_table_that_cannot_be_understood_is_one_sentence(write, content, options, said):
    path = write(content)
    with pytest.raises(ValueError, match=r"leg\.csv: ") as caught:
        load(path, columns=options)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("angle", ["angle_deg", "raw_angle_deg", "knee_angle_deg"])
def test_a_gyro_is_read_whatever_the_angle_beside_it_is_called(write, angle):
    rows = [f"time_s,{angle},gyro_deg_s", *lines((TIME, ANGLE, RATE))]
    loaded = load(write("\n".join(rows)))
    (segment,) = loaded.recording.segments
    np.testing.assert_allclose(segment.best_angle, np.radians(ANGLE), rtol=1e-15)
    np.testing.assert_allclose(segment.raw_angular_velocity, np.radians(RATE), rtol=1e-15)
    assert any("gyro_deg_s as raw_velocity_rad_s (in deg/s)" in note for note in loaded.notes)


@pytest.mark.parametrize(("name", "ticks"), [("ms", 1e3), ("millis", 1e3), ("us", 1e6)])
def test_a_clock_that_is_called_by_its_unit_is_the_time(write, name, ticks):
    rows = [f"{name},knee_angle_deg", *lines((np.round(TIME * ticks), ANGLE))]
    check(write("\n".join(rows)))


@pytest.mark.parametrize(
    ("names", "ticks"),
    [("mSec\tTORQUE (N-M)\tPOSITION (DEGREES)", 1e3), ("X [s]\tTorque [Nm]\tPos [deg]", 1)],
)
def test_a_vague_name_is_known_by_its_unit(write, names, ticks):
    """As dynamometers and loggers of muscles write theirs."""
    rows = lines((TIME * ticks, ANGLE * 0, ANGLE), "\t")
    segment, _ = check(write("\n".join([names, *rows]), "leg.txt"))
    assert segment.applied_torque is not None


@pytest.mark.parametrize("name", ["X", "X [mm]", "Position [mm]", "POSITION"])
def test_a_vague_name_of_another_unit_stays_unknown(write, name):
    path = write("\n".join([f"t,knee angle (deg),{name}", *lines((TIME, ANGLE, TIME))]))
    _, said = check(path)
    assert f"not read: {name}." in said


def test_milliseconds_beside_a_time_are_not_the_time(write):
    part = np.round(1e3 * TIME % 1 * 1e3)
    _, said = check(write("\n".join(["time,ms,knee_angle_deg", *lines((TIME, part, ANGLE))])))
    assert "not read: ms" in said


def test_a_velocity_is_taken_for_a_gyro_only_where_it_is_called_one(write):
    rows = ["t,knee,knee_velocity", *lines((TIME, ANGLE, RATE))]
    segment, said = check(write("\n".join(rows)))
    assert segment.raw_angular_velocity is None
    assert "not read: knee_velocity. A gyro among them is named: columns=" in said


@pytest.mark.parametrize(
    ("kind", "names", "told"),
    [
        ("measured", "Motor torque (Nm)", True),
        ("passive", "Motor torque (Nm)", False),
        ("measured", "Motor (Nm),Spring (Nm)", False),
        ("measured", "Motor current (A)", False),
    ],
)
def test_of_a_measured_motion_the_only_column_in_newton_metres_is_the_torque(
    write, kind, names, told
):
    others = [TIME * 0.5 for _ in names.split(",")]
    path = write("\n".join([f"Time (s),Angle (rad),{names}", *lines((TIME, -TIME, *others))]))
    path.with_suffix(".toml").write_text(
        f'[subject]\nkind = "rig"\n[protocol]\nkind = "{kind}"\n', encoding="utf-8"
    )
    loaded = load(path)
    torque = loaded.recording.segments[0].applied_torque
    assert (torque is not None) is told
    if told:
        np.testing.assert_allclose(torque, TIME * 0.5)
        assert f"{names} as torque_nm (in N m)" in " ".join(loaded.notes)


def test_names_that_steer_a_terminal_are_shown_without_it(write):
    path = write("\n".join(["t;knee;\x1b[31mred", *lines((TIME, ANGLE, ANGLE), ";")]))
    assert all(each.isprintable() for each in load(path).notes)


@settings(max_examples=200)
@given(st.binary(max_size=400))
def test_any_bytes_are_a_recording_or_one_sentence(tmp_path_factory, content):
    path = tmp_path_factory.mktemp("bytes") / "leg.csv"
    path.write_bytes(content)
    with pytest.raises(ValueError, match="leg") as caught:
        load(path)
    assert "\n" not in str(caught.value)


LABVIEW = "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n\nChannels\t1\t\n"


@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("name", ["leg.txt", "leg.lvm"])
@pytest.mark.parametrize("ends", ["", "\t"])
@pytest.mark.parametrize("remark", ["", "\tlet go"])
def test_labviews_time_is_known_and_its_comments_may_be_left_out(
    write, decimal, name, ends, remark
):
    first, *rows = lines((TIME, ANGLE), "\t", decimal)
    rows = [f"{first}{remark or ends}", *(f"{row}{ends}" for row in rows)]
    _, said = check(write("\n".join([f"{LABVIEW}X_Value\tKnee Angle\tComment", *rows]), name))
    assert "X_Value as time_s (in s)" in said
    assert "not read: Comment" in said


def test_x_value_of_any_other_program_is_no_time(write):
    rows = ["X_Value\tKnee Angle", *lines((TIME, ANGLE), "\t")]
    with pytest.raises(ValueError, match="has no time"):
        load(write("\n".join(rows), "leg.txt"))


def test_a_separator_at_the_end_of_the_names_alone_is_no_column(write):
    check(write("\n".join(["Time (s),Knee Angle (deg),", *lines((TIME, ANGLE))])))


def test_a_name_without_cells_that_may_be_any_column_is_refused(write):
    rows = ["Frame,Time (s),Knee Angle (deg)", *lines((TIME, ANGLE))]
    with pytest.raises(ValueError, match="have 2 cells, but 3 names"):
        load(write("\n".join(rows)))


VICON = ",,P04:RKneeAngles,,", "Frame,Sub Frame,X,Y,Z", ",,deg,deg,deg"
FRAMES = lines((range(1, 41), [0] * 40, ANGLE, [1.2] * 40, [0.3] * 40))


def test_vicons_rate_stands_below_its_title(write):
    column = {"raw_angle_deg": "P04:RKneeAngles.X"}
    table = "\n".join(["Model Outputs", "200", *VICON, *FRAMES])
    time = load(write(table), columns=column).recording.segments[0].time
    assert np.diff(time) == pytest.approx(1 / 200)
    with pytest.raises(ValueError, match="has no time"):
        load(write("\n".join(["Model Outputs", *VICON, *FRAMES])), columns=column)


def test_places_of_markers_are_no_can_log(write):
    markers = "PathFileType\t4\t(X/Y/Z)\tmarkers.trc\nDataRate\tCameraRate\n100\t100\n"
    with pytest.raises(ValueError, match="holds the places of markers"):
        load(write(markers, "markers.trc"))
