"""`exoid study init` and `check`: what a data set lacks, and what it holds."""

import json

import pytest
from command_line import refusal

from study_folders import study, table_of, two_people


@pytest.fixture
def folder(tmp_path):
    return two_people(tmp_path / "study")


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


def test_a_text_without_a_table_is_left_aside_and_named(command, folder):
    (folder / "notes.txt").write_text("She was tired, 2 of 5 drops.")
    checked = command("study", "check", folder)
    assert checked.returncode == 0
    assert checked.stdout.startswith(f"{folder}: 16 recordings of 2 people\n")
    assert "left aside: 1\n    notes.txt: is a text without a table of numbers" in checked.stdout
    begun = command("study", "init", folder)
    assert begun.stderr == "exoid: left aside, as texts without a table of numbers: notes.txt\n"
    assert "of nobody" not in begun.stdout


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
        ("file.csv", "this is a file"),
        ("empty", "no recording was found in it"),
    ):
        assert said in refusal(command("study", *words, tmp_path / name))
