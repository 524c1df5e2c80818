"""Any file becomes a recording cut into its movements, whichever kind it is."""

from dataclasses import replace

import numpy as np
import pytest
from exo_node import Node, write_log

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import write_sidecar

TIME = np.arange(900) * 0.01
MARKS = Protocol(kind=("passive", "passive"), segment_start=(1.0, 5.0), segment_end=(3.0, 8.0))


def knee() -> Recording:
    """Nine seconds of one swing, unmarked."""
    angle = -1.5 + 1.2 * np.exp(-0.4 * TIME) * np.cos(5 * TIME)
    return Recording((Segment(TIME, raw_angle=angle),), Subject(kind="leg"))


def test_a_table_without_marks_stays_as_it_is(tmp_path):
    write_table(knee(), tmp_path / "knee.csv")
    loaded = load(tmp_path / "knee.csv")
    assert loaded.quality is None
    (segment,) = loaded.recording.segments
    np.testing.assert_array_equal(segment.time, TIME)


def test_a_table_with_marks_is_cut_at_them(tmp_path):
    write_table(replace(knee(), protocol=MARKS), tmp_path / "knee.csv")
    recording = load(str(tmp_path / "knee.csv")).recording
    assert [segment.time.size for segment in recording.segments] == [201, 301]
    assert [segment.time[0] for segment in recording.segments] == [0.0, 0.0]


def test_marks_outside_the_table_are_refused_with_its_name(tmp_path):
    late = replace(MARKS, segment_start=(1.0, 50.0), segment_end=(3.0, 60.0))
    write_table(replace(knee(), protocol=late), tmp_path / "knee.csv")
    with pytest.raises(ValueError, match=r"knee\.csv: segment 1 is marked from 50 to 60 s"):
        load(tmp_path / "knee.csv")


@pytest.mark.parametrize("suffix", [".blf", ".csv"])
def test_a_log_is_told_from_a_table_and_brings_its_quality(tmp_path, suffix):
    path = write_log(tmp_path / f"log{suffix}", Node().messages(900))
    write_sidecar(Subject(kind="leg", height=1.8), MARKS, Sensors(), path.with_suffix(".toml"))
    loaded = load(path)
    assert loaded.quality is not None
    assert loaded.quality.samples == 900
    assert loaded.notes == ()
    assert loaded.recording.subject.height == 1.8
    assert [round(each.time[-1]) for each in loaded.recording.segments] == [2, 3]


def test_a_log_without_a_sidecar_says_that_it_is_of_nobody(tmp_path):
    path = write_log(tmp_path / "log.blf", Node().messages(900))
    loaded = load(path)
    said = f"{tmp_path / 'log.toml'}: there is none: subject and protocol are unknown"
    assert loaded.notes == (said,)
    assert loaded.recording.subject == Subject()


def test_strict_refuses_what_a_log_has_lost(tmp_path):
    messages = Node().messages(900)
    path = write_log(tmp_path / "log.blf", messages[:600] + messages[640:])
    write_sidecar(Subject(), MARKS, Sensors(), path.with_suffix(".toml"))
    assert load(path).quality.losses()
    with pytest.raises(ValueError, match=r"log\.blf is not complete"):
        load(path, strict=True)


@pytest.mark.parametrize(
    ("request_", "said"),
    [
        ({"dbc": "knee.dbc"}, "belong together"),
        ({"signals": {"raw_angle": "Knee.Angle"}}, "belong together"),
    ],
)
def test_half_of_a_signal_map_is_refused_for_a_table_too(tmp_path, request_, said):
    write_table(knee(), tmp_path / "knee.csv")
    with pytest.raises(ValueError, match=said):
        load(tmp_path / "knee.csv", **request_)


def test_what_is_no_recording_is_refused(tmp_path):
    with pytest.raises(ValueError, match="this is a directory"):
        load(tmp_path)
    with pytest.raises(ValueError, match=r"Name the table or log beside it"):
        load(tmp_path / "knee.toml")
    with pytest.raises(FileNotFoundError, match=r"knee\.csv"):
        load(tmp_path / "knee.csv")


def test_what_holds_for_a_study_is_told_to_be_unread_by_a_single_recording(tmp_path):
    path = tmp_path / "P01.csv"
    path.write_text(
        "time_s,raw_angle_rad\n" + "".join(f"{n / 100},{-n / 200}\n" for n in range(99))
    )
    assert not any("defaults.toml" in note for note in load(path).notes)
    general = tmp_path / "defaults.toml"
    general.write_text('[protocol]\nkind = "passive"\n')
    (note,) = [note for note in load(path).notes if "defaults.toml" in note]
    assert note.endswith("What P01.csv needs of it belongs into P01.toml.")
    told = load(path, defaults=[general])
    assert told.recording.protocol.kind == "passive"
    assert not any("defaults.toml" in note for note in told.notes)
