"""The command line reads what others wrote: columns are named by an option or by the sidecar."""

from pathlib import Path

import numpy as np
import pytest
from command_line import refusal

from exoid.recordings.loading.load import load
from exoid.recordings.loading.once import once

TIME = np.arange(300) * 0.01
ANGLE = -90 + 70 * np.exp(-TIME) * np.cos(5 * TIME)  # deg, of a leg let go


@pytest.fixture
def camera(tmp_path):
    """What a camera's software exports on a German computer."""
    rows = [f"{t:.2f};{a:.3f};0".replace(".", ",") for t, a in zip(TIME, ANGLE, strict=True)]
    path = tmp_path / "camera.csv"
    path.write_bytes("\r\n".join(["Zeit (s);Kniewinkel (°);Hüfte (°)", *rows]).encode("cp1252"))
    return path


def test_a_table_in_other_words_is_converted_and_what_was_understood_is_said(
    command, camera, tmp_path
):
    for suffix in ("csv", "parquet"):
        done = command("convert", camera, "-o", tmp_path / f"leg.{suffix}", "--force")
        assert done.returncode == 0, done.stderr
        assert "Kniewinkel (°) as raw_angle_rad (in °)" in done.stderr
        (segment,) = load(tmp_path / f"leg.{suffix}").recording.segments
        assert abs(np.degrees(segment.raw_angle) - ANGLE).max() < 6e-4  # half a written digit


def test_an_option_names_a_column(command, camera, tmp_path):
    column = ("--column", "raw_angle_deg=Hüfte (°)")
    done = command("convert", camera, "-o", tmp_path / "hip.csv", *column)
    assert done.returncode == 0, done.stderr
    (segment,) = load(tmp_path / "hip.csv").recording.segments
    assert set(segment.raw_angle) == {0.0}


@pytest.mark.parametrize(
    ("column", "said"),
    [
        ("raw_angle_deg", "--column raw_angle_deg: write it as COLUMN="),
        ("raw_angle_deg=Kniewinkel", "for raw_angle_deg. Did you mean Kniewinkel (°)? It holds"),
        ("angel=Kniewinkel (°)", "there is no column angel to fill. Did you mean angle"),
    ],
)
def test_a_map_that_does_not_fit_is_refused(command, camera, column, said):
    assert said in refusal(command("drops", camera, "--column", column))


def test_a_log_has_no_columns_to_name(command, recordings):
    done = command("drops", recordings / "session.blf", "--column", "time_s=t")
    assert "a CAN log has no columns to name" in refusal(done)


def test_what_is_said_of_several_files_is_said_once():
    first, other = Path("a.csv"), Path("b.csv")
    noticed = [
        (first, "exoid: a.csv: read x."),
        (first, "lost 2 of 9 frames"),
        (other, "exoid: b.csv: read x."),
        (other, "exoid: b.csv: its clock began anew."),
        (other, "lost 2 of 9 frames"),
    ]
    assert once(noticed, before="exoid: ") == [
        "exoid: a.csv and 1 more: read x.",
        "lost 2 of 9 frames",
        "exoid: b.csv: its clock began anew.",
        "lost 2 of 9 frames",
    ]
