"""`exoid study init` and `check`, and `exoid convert` of a data set."""

import json
from pathlib import Path

import pytest
from command_line import refusal

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from study_folders import same, study, table_of

NAMES = [f"P0{p}/{when}/{side}_{k}.csv" for p in (1, 2) for when in ("pre", "post")
         for side in ("left", "right") for k in (1, 2)]  # fmt: skip
PEOPLE = "id,body_mass_kg,height_m,age_years,group\nP01,77,1.8,30,a\nP02,61,1.65,40,b\n"
SIDECAR = '[subject]\nnotes = "shoe on"\nadded_mass_kg = [0.5]\n[protocol]\nkind = "passive"\n'


@pytest.fixture
def folder(tmp_path):
    sidecars = {"participants.csv": PEOPLE, "P01/pre/left_1.toml": SIDECAR}
    return study(tmp_path / "study", NAMES, sidecars)


def whole(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def by_leg(folder: Path) -> dict[tuple, object]:
    """The recordings of a data set by whose, when, side and run."""
    dataset = open_dataset(folder)
    return {
        (each.participant, each.session, each.side, each.run): recording_of(each, dataset)
        for each in dataset.entries
    }


def test_init_writes_a_table_to_be_filled_in_and_replaces_nothing(command, tmp_path):
    study(tmp_path, ["P02_left.csv", "P01_left.csv"])
    done = command("study", "init", tmp_path)
    assert done.returncode == 0, done.stderr
    table = tmp_path / "participants.csv"
    assert table.read_text() == "id,body_mass_kg,height_m,age_years,sex,group\nP01,,,,,\nP02,,,,,\n"
    assert f"wrote {table}" in done.stdout
    assert "Fill in participants.csv" in done.stdout
    table.write_text("id,body_mass_kg\nP01,77\n")
    done = command("study", "init", tmp_path)
    assert table.read_text() == "id,body_mass_kg\nP01,77\n"
    assert done.stdout == f"{table} is kept as it is. It lacks rows for: P02\n"


def test_init_takes_what_sidecars_tell_and_names_recordings_of_nobody(command, tmp_path):
    told = '[subject]\nid = "anna"\nbody_mass_kg = 77\n'
    study(tmp_path, ["one_left.csv", "two_left.csv"], {"one_left.toml": told})
    done = command("study", "init", tmp_path)
    assert "anna,77,,,," in (tmp_path / "participants.csv").read_text()
    assert "1 recording of nobody" in done.stdout
    assert "two_left.csv" in done.stdout


def test_check_says_what_is_there_and_ends_with_0(command, folder):
    done = command("study", "check", folder)
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    assert lines[0] == f"{folder}: 16 recordings of 2 people"
    assert "  sides     left 8, right 8" in lines
    assert "  sessions  post 8, pre 8" in lines
    assert not any("mended" in line or "known" in line for line in lines)


def test_check_ends_with_1_where_something_must_be_mended_and_has_all_for_machines(
    command, folder, tmp_path
):
    (folder / "P01" / "pre" / "left_1.csv").write_text("nothing")
    done = command("study", "check", folder, "--json", tmp_path / "found.json")
    assert done.returncode == 1
    assert "Errors, to be mended:\n  unreadable: 1\n    P01/pre/left_1.csv: " in done.stdout
    document = json.loads((tmp_path / "found.json").read_text())
    assert document["recordings"] == 16
    (finding,) = document["findings"]
    assert (finding["level"], finding["where"]) == ("error", "P01/pre/left_1.csv")


def test_check_shows_letters_that_steer_a_terminal_escaped(command, folder):
    (folder / "P01_\x1b[31m_left.csv").write_text("nothing")
    done = command("study", "check", folder)
    assert "\x1b" not in done.stdout
    assert r"P01_\u001b[31m_left.csv" in done.stdout


@pytest.mark.parametrize("words", [["init"], ["check"]])
def test_no_data_set_is_refused_in_a_line(command, tmp_path, words):
    (tmp_path / "file.csv").write_text(table_of())
    (tmp_path / "empty").mkdir()
    for name, said in (
        ("nowhere", "there is no such folder"),
        ("file.csv", "there is no such folder"),
        ("empty", "no recording was found in it"),
    ):
        assert said in refusal(command("study", *words, tmp_path / name))


def test_there_and_back_every_recording_is_the_same(command, folder, tmp_path):
    for source, target, said in (
        (folder, tmp_path / "bids", "16 recordings as Motion-BIDS"),
        (tmp_path / "bids", tmp_path / "back", "16 recordings as exoid's tables"),
    ):
        done = command("convert", source, "-o", target)
        assert done.returncode == 0, done.stderr
        assert done.stdout == f"{target}: {said}\n"
    first, bids, back = (by_leg(each) for each in (folder, tmp_path / "bids", tmp_path / "back"))
    assert first.keys() == bids.keys() == back.keys()
    for key, recording in first.items():
        same(recording, bids[key])
        same(recording, back[key])
    assert open_dataset(tmp_path / "bids").bids
    people = open_dataset(folder).participants
    assert open_dataset(tmp_path / "bids").participants == people
    assert open_dataset(tmp_path / "back").participants == people


def test_recordings_that_are_told_alike_all_come_along(command, tmp_path):
    names = ["P01_left.csv", "a/P01_left.csv", "b/P01_left_1.csv"]
    study(tmp_path / "study", names)
    done = command("convert", tmp_path / "study", "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert {each.run for each in open_dataset(tmp_path / "out").entries} == {"1", "2", "3"}


def test_a_folder_is_replaced_only_by_force_and_then_kept_aside(command, folder, tmp_path):
    target = tmp_path / "out"
    target.mkdir()
    (target / "mine.txt").write_text("mine")
    assert f"{target} exists" in refusal(command("convert", folder, "-o", target))
    done = command("convert", folder, "-o", target, "--force")
    assert done.stdout.splitlines()[1] == f"what was there is {tmp_path / 'out.before'}"
    assert (tmp_path / "out.before" / "mine.txt").read_text() == "mine"
    assert command("convert", folder, "-o", target, "--force").returncode == 0
    assert (tmp_path / "out.before1" / "dataset_description.json").exists()


def test_one_unreadable_recording_leaves_everything_as_it_was(command, folder, tmp_path):
    (folder / "P01" / "pre" / "left_1.csv").write_text("nothing")
    before = whole(tmp_path)
    said = refusal(command("convert", folder, "-o", tmp_path / "out"))
    assert "1 of 16 recordings cannot be read, and nothing was written" in said
    assert "left_1.csv" in said
    assert whole(tmp_path) == before
    assert [each.name for each in tmp_path.iterdir()] == ["study"]


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (["odd_left.csv"], "odd_left.csv tells nobody"),
        (["P1_left.csv", "p1_left.csv"], "P1 and p1 would be one person, sub-"),
    ],
)
def test_people_that_would_be_lost_are_refused(command, tmp_path, names, said):
    study(tmp_path / "study", names)
    assert said in refusal(command("convert", tmp_path / "study", "-o", tmp_path / "out"))
    assert [each.name for each in tmp_path.iterdir()] == ["study"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["study", "-o", "study/in"], "this folder is read here"),
        (["study/..", "-o", "study"], "this folder is read here"),
        (["study", "-o", "file"], "this is a file. Name a folder"),
        (["study", "-o", "nowhere/out"], "does not exist. Make it first"),
        (["study", "-o", "out", "--flip", "all"], "--flip is for a recording"),
        (["study/P01/pre/left_1.csv", "-o", "a.csv", "--as", "bids"], "--as is for a data set"),
        (["study", "-o", "out", "--as", "csv"], "--as"),
    ],
)
def test_what_a_data_set_cannot_be_converted_to_is_refused(command, folder, words, said):
    (folder.parent / "file").write_text("")
    before = whole(folder.parent)
    assert said in refusal(command("convert", *words, cwd=folder.parent))
    assert whole(folder.parent) == before
