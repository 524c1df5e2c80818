"""`exoid convert`: the table says what the log said, and nothing that was there is lost."""

import shutil

import numpy as np
import pytest
from command_line import refusal

from exoid.recordings.declared.entry import known
from exoid.recordings.loading.load import load


def assert_same(one, other) -> None:
    """Every number and every key of two recordings."""
    assert len(one.segments) == len(other.segments)
    for mine, theirs in zip(one.segments, other.segments, strict=True):
        assert mine.channels().keys() == theirs.channels().keys()
        for name, samples in mine.channels().items():
            np.testing.assert_array_equal(samples, theirs.channels()[name])
    for table in ("subject", "protocol", "sensors"):
        mine, theirs = getattr(one, table), getattr(other, table)
        for entry in known(mine):
            assert getattr(mine, entry.name) == getattr(theirs, entry.name)


def test_a_log_and_its_table_are_the_same_recording(command, recordings, tmp_path):
    done = command("convert", recordings / "session.blf", "-o", tmp_path / "leg.csv")
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"{tmp_path / 'leg.csv'}: 1 segment, and {tmp_path / 'leg.toml'}\n"
    assert "samples from" in done.stderr
    log = load(recordings / "session.blf").recording
    assert_same(log, load(tmp_path / "leg.csv").recording)


def test_a_whole_log_keeps_what_lies_between_its_marks(command, recordings, tmp_path):
    done = command("convert", recordings / "session.blf", "-o", tmp_path / "leg.csv", "--whole")
    assert done.returncode == 0, done.stderr
    whole = load(recordings / "session.blf", whole=True).recording
    assert_same(whole, load(tmp_path / "leg.csv", whole=True).recording)
    assert whole.segments[0].time[-1] > 4
    assert_same(load(recordings / "session.blf").recording, load(tmp_path / "leg.csv").recording)


def test_a_table_in_degrees_becomes_one_in_radians(command, tmp_path):
    (tmp_path / "deg.csv").write_text("time_s,raw_angle_deg\n0.0,-90\n0.01,-45\n")
    assert command("convert", tmp_path / "deg.csv", "-o", tmp_path / "rad.csv").returncode == 0
    angle = load(tmp_path / "rad.csv").recording.segments[0].raw_angle
    assert angle.tolist() == [np.radians(-90), np.radians(-45)]


@pytest.mark.parametrize("there", ["leg.csv", "leg.toml"])
def test_what_is_there_is_replaced_only_by_force(command, recordings, tmp_path, there):
    (tmp_path / there).write_text("old")
    arguments = ("convert", recordings / "session.blf", "-o", tmp_path / "leg.csv")
    assert f"{tmp_path / there} exists" in refusal(command(*arguments))
    assert {each.name: each.read_text() for each in tmp_path.iterdir()} == {there: "old"}
    assert command(*arguments, "--force").returncode == 0
    assert len(load(tmp_path / "leg.csv").recording.segments) == 1


def test_a_failing_conversion_leaves_what_was_there(command, recordings, tmp_path):
    (tmp_path / "leg.csv").write_text("old")
    (tmp_path / "bad.blf").write_bytes((recordings / "session.blf").read_bytes()[:100])
    done = command("convert", tmp_path / "bad.blf", "-o", tmp_path / "leg.csv", "--force")
    assert "bad.blf" in refusal(done)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["bad.blf", "leg.csv"]
    assert (tmp_path / "leg.csv").read_text() == "old"


def test_the_sidecar_of_the_log_is_not_written_over(command, recordings, tmp_path):
    for name in ("session.blf", "session.toml"):
        shutil.copy(recordings / name, tmp_path / name)
    before = (tmp_path / "session.toml").read_bytes()
    for force in ((), ("--force",)):
        done = command("convert", tmp_path / "session.blf", "-o", tmp_path / "session.csv", *force)
        assert "session.toml: this file is read here" in refusal(done)
    assert (tmp_path / "session.toml").read_bytes() == before


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("missing.blf", "-o", "leg.csv"), "Check the name"),
        (("missing.blf", "-o", "leg.blf"), "must end in .csv"),
        (("missing.blf", "-o", "nowhere/leg.csv"), "the folder nowhere does not exist"),
        (("missing.blf",), "'--output'"),
    ],
)
def test_what_cannot_be_converted_is_refused(command, tmp_path, arguments, said):
    assert said in refusal(command("convert", *arguments, cwd=tmp_path))
    assert not list(tmp_path.iterdir())
