"""`exoid convert` of a data set: there and back, whole or not at all."""

import os
import signal
from pathlib import Path
from time import monotonic, sleep

import pytest
from command_line import LIMIT, refusal

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from study_folders import same, study, two_people


@pytest.fixture
def folder(tmp_path):
    return two_people(tmp_path / "study")


def whole(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def by_leg(folder: Path) -> dict[tuple, object]:
    """The recordings of a data set by whose, when, side and run."""
    dataset = open_dataset(folder)
    return {
        (each.participant, each.session, each.side, each.run): recording_of(each, dataset)
        for each in dataset.entries
    }


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


def test_files_that_do_not_come_along_are_named_and_what_describes_the_study_does(
    command, folder, tmp_path
):
    (folder / "README.md").write_text("ours")
    (folder / "P01" / "consent.pdf").write_text("")
    (folder / "P01" / "notes.txt").write_text("She was tired, 2 of 5 drops.")
    for source, target in ((folder, tmp_path / "bids"), (tmp_path / "bids", tmp_path / "back")):
        done = command("convert", source, "-o", target)
        assert (target / "README.md").read_text() == "ours"
        names = "P01/consent.pdf, P01/notes.txt"
        left = f"exoid: 2 other files left behind: {names}\n" if source == folder else ""
        assert (done.returncode, done.stderr) == (0, left)


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
    assert "P01/pre/left_1.csv: " in said
    assert str(folder) not in said
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


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signal to send")
def test_ctrl_c_leaves_nothing_of_a_conversion(command, tmp_path):
    names = [f"P{person:03d}_left_{trial}.csv" for person in range(100) for trial in range(20)]
    study(tmp_path / "study", names)
    running = command.start("convert", tmp_path / "study", "-o", tmp_path / "out")
    deadline = monotonic() + LIMIT
    while not [*tmp_path.glob(".out*.part/sub-*")] and monotonic() < deadline:
        assert running.poll() is None, running.communicate()
        sleep(0.01)
    running.send_signal(signal.SIGINT)
    said = running.communicate(timeout=LIMIT)
    assert (running.returncode, said) == (130, ("", "exoid: interrupted\n"))
    assert [each.name for each in tmp_path.iterdir()] == ["study"]
