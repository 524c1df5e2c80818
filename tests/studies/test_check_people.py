"""A look at the people of a data set: sizes, ids, and recordings that are not of one leg."""

import pytest

from study_checks import NAMES, PEOPLE, checked, found, only
from study_folders import study, table_of


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("P02,7.7,1.65,40", "weighs 7.7 kg at 1.65 m"),
        ("P02,7.7,,40", "weighs 7.7 kg at 40 years. Is a digit missing?"),
        ("P02,7.7,,", "weighs 7.7 kg. Is a digit missing?"),
        ("P02,61000,1.65,40", "It would be 61 kg if it is in g."),
        ("P02,61,165,40", "It would be 1.65 m if it is in cm."),
        ("P02,165,0.61,40", "It would be 61 kg at 1.65 m were the two exchanged."),
        ("P02,1.65,61,40", "It would be 61 kg at 1.65 m were the two exchanged."),
        ("P02,61,1.65,400", "age_years is 400"),
    ],
)
def test_a_size_that_nobody_has_is_found_with_its_likely_cause(sound, row, said):
    (sound / "participants.csv").write_text(PEOPLE.replace("P02,61,1.65,40", row))
    level, where, says = found(sound, "impossible size")[0]
    assert (level, where) == ("error", "P02")
    assert said in says


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("P02,149.3,1.73,40", "(50 kg/m2). Is that right? It would be 67.7 kg if it is in lb."),
        ("P02,149.3,1.73,", "It would be 67.7 kg if it is in lb."),
        ("P02,230,1.75,50", "weighs 230 kg at 1.75 m, as hardly anybody does (75 kg/m2)."),
        ("P02,31,1.65,40", "(11 kg/m2). Is that right?"),
    ],
)
def test_a_size_that_hardly_anybody_has_is_told_with_its_likely_unit(sound, row, said):
    (sound / "participants.csv").write_text(PEOPLE.replace("P02,61,1.65,40", row))
    (one,) = checked(sound).findings
    assert (one.level, one.kind, one.where) == ("warning", "unusual size", "P02")
    assert said in one.says


@pytest.mark.parametrize("row", ["P02,18,1.05,5", "P02,125,1.75,50", "P02,38,1.5,17"])
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


def test_mixed_rates_and_devices_of_one_person_are_found(sound):
    (sound / NAMES[0]).write_text(table_of(30, rate=60.0))
    (sound / "P02" / "left_1.toml").write_text('[sensors]\ndevice = "goniometer"\n')
    assert found(sound, "mixed rates")[0][1:] == (
        "P01",
        "was recorded at 60 and at 100 Hz. Compare with care: noise and errors differ.",
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
