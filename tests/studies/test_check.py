"""A look at a data set: everything that does not agree is found, and nothing else."""

from pathlib import Path

import pytest

from exoid.studies.dataset.check.check import Checked, check_dataset
from exoid.studies.dataset.open_dataset import open_dataset
from study_folders import processor_time, study, table_of

NAMES = [f"P{p:02d}/{side}_{k}.csv" for p in (1, 2) for side in ("left", "right") for k in (1, 2)]
PEOPLE = "id,body_mass_kg,height_m,age_years\nP01,77,1.80,30\nP02,61,1.65,40\n"


def checked(folder: Path, most: int = 1000) -> Checked:
    return check_dataset(open_dataset(folder), most, lambda word: None)


def found(folder: Path, kind: str) -> list[tuple[str, str, str]]:
    """Level, place and words of all findings of a kind."""
    return [(e.level, e.where, e.says) for e in checked(folder).findings if e.kind == kind]


def only(folder: Path, kind: str) -> tuple[str, str, str]:
    """The one finding of a kind, where nothing else is an error."""
    (one,) = found(folder, kind)
    assert {each.kind for each in checked(folder).findings if each.level == "error"} <= {kind}
    return one


@pytest.fixture
def sound(tmp_path):
    """A study in which all is told and agrees."""
    return study(tmp_path, NAMES, {"participants.csv": PEOPLE})


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
    ("row", "said"),
    [
        ("P02,7.7,1.65,40", "weighs 7.7 kg at 1.65 m"),
        ("P02,7.7,,40", "weighs 7.7 kg at 40 years. Is a digit missing?"),
        ("P02,7.7,,", "weighs 7.7 kg. Is a digit missing?"),
        ("P02,61000,1.65,40", "It would be 61 kg if it is in g."),
        ("P02,61,165,40", "It would be 1.65 m if it is in cm."),
        ("P02,61,1.65,400", "age_years is 400"),
    ],
)
def test_a_size_that_nobody_has_is_found_with_its_likely_cause(sound, row, said):
    (sound / "participants.csv").write_text(PEOPLE.replace("P02,61,1.65,40", row))
    level, where, says = found(sound, "impossible size")[0]
    assert (level, where) == ("error", "P02")
    assert said in says


@pytest.mark.parametrize("row", ["P02,18,1.05,5", "P02,230,1.75,50", "P02,38,1.5,17"])
def test_a_child_and_a_heavy_and_a_slight_person_are_none(sound, row):
    (sound / "participants.csv").write_text(PEOPLE.replace("P02,61,1.65,40", row))
    assert checked(sound).findings == ()


def test_one_id_with_two_body_masses_is_found_in_the_table_and_in_sidecars(sound):
    (sound / "participants.csv").write_text(PEOPLE + "P01,70,1.80,30\n")
    assert "P01 stands there twice, with body_mass 77.0 and 70.0" in only(sound, "layout")[2]
    (sound / "participants.csv").unlink()
    for name, mass in (("left_1", 77), ("left_2", 58)):
        told = f"[subject]\nbody_mass_kg = {mass}\nheight_m = 1.8\n"
        (sound / "P01" / f"{name}.toml").write_text(told)
    assert only(sound, "two sizes")[1:] == (
        "P01",
        "has the body mass 58 in P01/left_2.csv and 77 in P01/left_1.csv: are they two people?",
    )


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


def test_people_without_recordings_and_recordings_without_people_are_found(sound):
    (sound / "participants.csv").write_text(PEOPLE.replace("P02", "P03"))
    (sound / "odd_left.csv").write_text(table_of(77))
    assert [each[1] for each in found(sound, "nobody recorded")] == ["P03"]
    assert [each[1] for each in found(sound, "not in the table")] == ["P02"]
    assert only(sound, "of nobody")[:2] == ("error", "odd_left.csv")


def test_ids_that_are_nearly_one_are_found(sound):
    study(sound, ["p1_left.csv", "P12_left.csv"])
    for seed, name in enumerate(("p1_left.csv", "P12_left.csv")):
        (sound / name).write_text(table_of(60 + seed))
    assert [each[1] for each in found(sound, "ids alike")] == ["P01 and p1"]


def test_names_that_differ_by_capitals_alone_are_found(sound):
    (sound / "P01" / "LEFT_1.csv").write_text(table_of(88))
    if len([*(sound / "P01").iterdir()]) == 4:
        pytest.skip("this file system takes both names for one")
    assert found(sound, "names alike")[0][1] == "P01/LEFT_1.csv and P01/left_1.csv"
    assert found(sound, "one trial")[0][1] == "P01/left_1.csv"


def test_mixed_rates_and_devices_of_one_person_are_found(sound):
    (sound / NAMES[0]).write_text(table_of(30, rate=60.0))
    (sound / "P02" / "left_1.toml").write_text('[sensors]\ndevice = "goniometer"\n')
    assert found(sound, "mixed rates")[0][1:] == (
        "P01",
        "was recorded at 59.9 and at 100 Hz. Compare with care: noise and errors differ.",
    )
    assert found(sound, "mixed devices")[0][1] == "P02"


def test_a_leg_that_swings_unlike_the_others_of_its_id_is_found(sound):
    """Half the frequency is a quarter of the pull; drops of one leg differ by 1.2 at most."""
    study(sound, ["P01/right_8.csv", "P01/right_9.csv", "P01/left_3.csv"])
    lines = (sound / NAMES[1]).read_text().splitlines()
    slow = [f"{2 * float(line.split(',')[0]):.4f},{line.split(',')[1]}" for line in lines[1:]]
    (sound / NAMES[1]).write_text("\n".join([lines[0], *slow, ""]))
    level, where, says = found(sound, "another leg")[0]
    assert (level, where) == ("warning", NAMES[1])
    assert "is it of another leg?" in says


def test_without_sizes_a_person_has_ratios_only(sound):
    (sound / "participants.csv").write_text("id,body_mass_kg,height_m\nP01,77,\nP02,,\n")
    told = checked(sound)
    assert told.ratios_only == 2
    assert [each.where for each in told.findings if each.kind == "no body mass"] == ["P02"]
    assert [each.where for each in told.findings if each.kind == "no height"] == ["P01", "P02"]
    assert told.errors == 0


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
    """70 us of a processor each for name, sidecar and content; four times that where it is slow."""
    for person in range(200):
        there = tmp_path / f"P{person:03d}"
        there.mkdir()
        for trial in range(100):
            (there / f"left_{trial}.csv").write_text(f"{person},{trial:03d}")
    assert processor_time(CHECKED, tmp_path) < 20_000 * 280e-6
