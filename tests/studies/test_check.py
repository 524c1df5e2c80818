"""A look at a data set: what does not agree in its recordings is found, and nothing else."""

from pathlib import Path

import pytest

from study_checks import NAMES, checked, found, only
from study_folders import READ_ALL, processor_time, study, table_of


def test_a_sound_study_is_told_and_has_no_finding(sound):
    told = checked(sound)
    assert told.findings == ()
    assert (told.recordings, told.people, told.read, told.readable) == (8, 2, 8, 8)
    assert told.sides == {"left": 4, "right": 4}
    assert told.devices == {"raw angle, 100 Hz": 8}
    assert told.drops == 8


def test_of_many_recordings_some_are_read_spread_over_all(sound):
    (sound / NAMES[3]).write_text("damaged")
    assert [each.where for each in checked(sound, most=2).findings] == []
    told = checked(sound, most=8)
    assert (told.read, told.readable, told.errors) == (8, 7, 1)


def test_a_recording_that_cannot_be_read_has_its_reason(sound):
    (sound / NAMES[0]).write_text("a,b\n1,2\n")
    level, where, says = only(sound, "unreadable")
    assert (level, where) == ("error", NAMES[0])
    assert "has no time" in says
    assert str(sound) not in says


def test_a_column_that_may_be_a_gyro_and_is_not_read_is_told(sound):
    path = sound / NAMES[0]
    head, *rows = path.read_text().splitlines()
    head = head.replace("time_s", "t")  # another's table
    path.write_text("\n".join([f"{head},Drehrate (°/s)", *(f"{each},0.1" for each in rows)]))
    level, where, says = only(sound, "gyro not read")
    assert (level, where) == ("warning", NAMES[0])
    assert 'raw_velocity_deg_s = "..." under [columns]' in says


def test_a_locked_file_has_its_reason(sound, monkeypatch):
    opened = Path.open

    def locked(self, *arguments, **options):
        if self.name == "left_1.csv" and self.parent.name == "P01":
            raise PermissionError(13, "Permission denied", str(self))
        return opened(self, *arguments, **options)

    monkeypatch.setattr(Path, "open", locked)  # who runs the tests may be root
    assert only(sound, "unreadable")[1:] == (
        NAMES[0],
        "Permission denied. Ask for the right to it, or name another.",
    )


def test_a_sidecar_that_cannot_be_read_is_found_though_no_sample_is(sound):
    (sound / "P01" / "left_1.toml").write_text("[subject")
    told = checked(sound, most=0)
    assert [each.kind for each in told.findings] == ["unreadable"]
    assert "is not valid TOML" in told.findings[0].says


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ('id = "P02"', "its sidecar says participant P02, its name P01"),
        ('side = "right"', "its sidecar says side right, its name left"),
        ("body_mass_kg = 55", "its sidecar says body mass 55, the table 77"),
        ("height_m = 1.7", "its sidecar says height 1.7, the table 1.8"),
    ],
)
def test_a_sidecar_against_name_or_table_is_found(sound, told, said):
    (sound / "P01" / "left_1.toml").write_text(f"[subject]\n{told}\n")
    level, where, says = found(sound, "told twice")[0]
    assert (level, where) == ("error", NAMES[0])
    assert said in says


def test_a_sidecar_that_says_the_same_in_other_signs_is_not(sound):
    (sound / "P01" / "left_1.toml").write_text('[subject]\nid = "sub-p01"\nbody_mass_kg = 76\n')
    assert found(sound, "told twice") == []


def test_a_file_whose_folder_says_the_other_side_is_found(sound):
    study(sound, ["P02/left/right_3.csv"])
    (sound / "P02" / "left" / "right_3.csv").write_text(table_of(99))
    _, where, says = only(sound, "told twice")
    assert where == "P02/left/right_3.csv"
    assert "its name tells the side twice: left and right" in says


def test_the_same_content_under_two_names_is_found(sound):
    (sound / "P02" / "left_9.csv").write_bytes((sound / NAMES[1]).read_bytes())
    assert only(sound, "same recording")[1:] == (
        "P02/left_9.csv",
        f"holds the same as {NAMES[1]}: it would count twice. Delete one.",
    )


def test_files_alike_but_for_their_end_are_not_the_same(sound):
    text = table_of(50, seconds=30)
    (sound / "P01" / "left_8.csv").write_text(text)
    (sound / "P01" / "left_9.csv").write_text(text[:-2] + "7\n" if text[-2] != "7" else text)
    assert found(sound, "same recording") == []


def test_names_that_differ_by_capitals_alone_are_found(sound):
    (sound / "P01" / "LEFT_1.csv").write_text(table_of(88))
    if len([*(sound / "P01").iterdir()]) == 4:
        pytest.skip("this file system takes both names for one")
    assert found(sound, "names alike")[0][1] == "P01/LEFT_1.csv and P01/left_1.csv"
    assert found(sound, "one trial")[0][1] == "P01/left_1.csv"


def test_a_recording_without_a_side_and_a_study_without_a_table_are_told(tmp_path):
    study(tmp_path, ["P01_1.csv"])
    assert found(tmp_path, "no side")[0][1] == "P01_1.csv"
    assert "exoid study init writes one" in found(tmp_path, "no table")[0][2]


CHECKED = """
from exoid.studies.dataset.check.check import check_dataset
from exoid.studies.dataset.open_dataset import open_dataset
assert check_dataset(open_dataset(sys.argv[1]), 20, lambda word: None).recordings == 20_000
"""


def test_twenty_thousand_tiny_files_take_bounded_time(tmp_path):
    """Six to nine times what it takes to read them, for name, sidecar and content."""
    for person in range(200):
        there = tmp_path / f"P{person:03d}"
        there.mkdir()
        for trial in range(100):
            (there / f"left_{trial}.csv").write_text(f"{person},{trial:03d}")
    assert processor_time(CHECKED, tmp_path) < 25 * processor_time(READ_ALL, tmp_path)
