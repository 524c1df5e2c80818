"""A folder as a data set, and the recordings in it."""

import os
from contextlib import chdir
from pathlib import Path

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from study_folders import READ_ALL, processor_time, study

PEOPLE = "id,body_mass_kg,height_m,age_years,group\nP01,77,1.8,30,a\n"


def test_a_plain_folder_tells_its_recordings_and_people(tmp_path):
    names = ["P01_left_day1.csv", "P01_right_day1.csv", "sub-02/ses-1/left.csv"]
    study(tmp_path, names, {"participants.csv": PEOPLE, "README.txt": "a study", "P.pdf": ""})
    dataset = open_dataset(tmp_path)
    assert [each.name for each in dataset.entries] == names
    assert [each.participant for each in dataset.entries] == ["P01", "P01", "02"]
    assert dataset.participants["P01"].more == {"group": "a"}
    assert not dataset.bids
    assert dataset.problems == ()


def test_a_recording_knows_what_names_and_table_say(tmp_path):
    study(tmp_path, ["P01_left_day1.csv"], {"participants.csv": PEOPLE})
    dataset = open_dataset(tmp_path)
    subject = recording_of(dataset.entries[0], dataset).subject
    assert (subject.id, subject.side, subject.session) == ("P01", "left", "day1")
    assert (subject.body_mass, subject.height, subject.age) == (77.0, 1.8, 30.0)


def test_what_the_sidecar_says_stands(tmp_path):
    told = '[subject]\nid = "P01"\nside = "right"\nbody_mass_kg = 80\n'
    study(tmp_path, ["a_left.csv"], {"participants.csv": PEOPLE, "a_left.toml": told})
    dataset = open_dataset(tmp_path)
    subject = recording_of(dataset.entries[0], dataset).subject
    assert (subject.side, subject.body_mass, subject.height) == ("right", 80.0, 1.8)


@pytest.mark.parametrize("there", [[], ["notes.pdf"], ["README.csv"]])
def test_a_folder_without_a_recording_is_refused_in_a_line(tmp_path, there):
    for name in there:
        (tmp_path / name).write_text("")
    with pytest.raises(ValueError, match="no recording was found in it"):
        open_dataset(tmp_path)


def test_no_folder_is_refused_by_its_name(tmp_path):
    with pytest.raises(ValueError, match="nowhere: there is no such folder"):
        open_dataset(tmp_path / "nowhere")


def test_links_in_a_circle_end_and_what_they_show_stands_once(tmp_path):
    study(tmp_path, ["day1/P01_left.csv", "day2/P01_left.csv"])
    (tmp_path / "day1" / "up").symlink_to(tmp_path, target_is_directory=True)
    (tmp_path / "day2" / "self").symlink_to("self")
    (tmp_path / "gone.csv").symlink_to(tmp_path / "missing.csv")
    names = [each.name for each in open_dataset(tmp_path).entries]
    assert names == ["day1/P01_left.csv", "day2/P01_left.csv", "gone.csv"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes")
def test_a_pipe_is_no_recording(tmp_path):
    study(tmp_path, ["P01_left.csv"])
    os.mkfifo(tmp_path / "pipe.csv")
    assert [each.name for each in open_dataset(tmp_path).entries] == ["P01_left.csv"]


def test_a_folder_that_cannot_be_read_is_a_problem_and_the_others_are_read(tmp_path, monkeypatch):
    study(tmp_path, ["a/P01_left.csv", "locked/P02_left.csv"])
    opened = os.scandir

    def scandir(path):
        if Path(path).name == "locked":
            raise PermissionError(13, "Permission denied", str(path))
        return opened(path)

    monkeypatch.setattr(os, "scandir", scandir)  # who runs the tests may be root
    dataset = open_dataset(tmp_path)
    assert [each.name for each in dataset.entries] == ["a/P01_left.csv"]
    (problem,) = dataset.problems
    assert problem.startswith("locked/: Permission denied. Ask for the right")


def test_the_results_of_a_run_within_it_are_not_recordings(tmp_path):
    study(tmp_path, ["P01_left.csv", "out/recordings.parquet", "out/quantities.parquet"])
    assert [each.name for each in open_dataset(tmp_path).entries] == ["P01_left.csv"]


def test_no_recording_is_opened(tmp_path, monkeypatch):
    study(tmp_path, ["P01_left.csv", "P02/right.csv"])
    monkeypatch.setattr(Path, "open", None)
    assert len(open_dataset(tmp_path).entries) == 2


OPENED = """
from exoid.studies.dataset.open_dataset import open_dataset
dataset = open_dataset(sys.argv[1])
"""


def test_a_hundred_thousand_files_take_seconds(tmp_path):
    """A tenth of it here, in one to two times what it takes to read them."""
    for person in range(100):
        folder = tmp_path / f"P{person:03d}" / "day1"
        folder.mkdir(parents=True)
        for trial in range(100):
            (folder / f"{('left', 'right')[trial % 2]}_{trial // 2}.csv").touch()
    assert processor_time(OPENED, tmp_path) < 5 * processor_time(READ_ALL, tmp_path)
    entries = open_dataset(tmp_path).entries
    assert len(entries) == 10_000
    assert {each.run for each in entries} == {str(trial) for trial in range(50)}


def test_folders_too_deep_to_be_entered_are_a_problem_in_a_line_that_can_be_read(tmp_path):
    study(tmp_path, ["P01_left.csv"])
    with chdir(tmp_path):
        for _ in range(100):
            Path("d" * 50).mkdir()
            os.chdir("d" * 50)
    (problem,) = open_dataset(tmp_path).problems
    assert problem.endswith("File name too long. Choose a shorter name.")
    assert len(problem) < 200


@pytest.mark.parametrize(
    "content",
    [
        b"notes",
        b"Visit of P01.\nTired, 2 of 5 drops, 3, 4 and 5 with a pause.\r\nAgain on 3.4.2024\n",
        "\ufeffMüde, 2 von 5.\n".encode("utf-16-le"),
    ],
)
def test_a_text_without_a_table_is_no_recording_and_named(tmp_path, content):
    study(tmp_path, ["P01_left.txt"])
    (tmp_path / "P01").mkdir()
    (tmp_path / "P01" / "notes.txt").write_bytes(content)
    dataset = open_dataset(tmp_path)
    assert [each.name for each in dataset.entries] == ["P01_left.txt"]
    assert dataset.aside == ("P01/notes.txt",)


@pytest.mark.parametrize(
    "content",
    [
        "",
        "Lab 1, 2024\n" * 30 + "time [s]\tangle [deg]\n" + "0,010\t-20,10\n" * 300,
        "angle [deg]\n" + "-20.1\n" * 30,
        "time side angle\n" + "12:00:01.5 left -20.1\n" * 30,
    ],
)
def test_a_text_with_a_table_is_a_recording_and_so_is_an_empty_one(tmp_path, content):
    (tmp_path / "P01_left.txt").write_text(content)
    dataset = open_dataset(tmp_path)
    assert ([each.name for each in dataset.entries], dataset.aside) == (["P01_left.txt"], ())


def test_what_office_keeps_beside_an_open_table_is_hidden(tmp_path):
    study(tmp_path, ["P01_left.csv"])
    (tmp_path / "~$participants.xlsx").write_bytes(b"\x05anna")
    assert [each.name for each in open_dataset(tmp_path).entries] == ["P01_left.csv"]
