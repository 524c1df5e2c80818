"""`exoid study run` as one calls it."""

import json
import pickle
import subprocess
import sys

import pytest
from command_line import refusal

from exoid.cli.terminal import progress as module
from exoid.cli.terminal.progress import Log, lasting, line
from exoid.studies.statistics.visits.exchanged import Exchanged
from study_folders import study
from study_runs import COMPUTED, NAMES, in_this_process, people


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Twenty people, both legs."""
    return people(tmp_path_factory.mktemp("study"))


@pytest.fixture
def here():
    """Workers in this process."""
    with in_this_process():
        yield


def test_a_run_says_what_it_did_and_writes_two_tables_and_a_document(
    command, here, folder, tmp_path
):
    results, document = tmp_path / "results", tmp_path / "run.json"
    done = command(*("study", "run", folder, "-o", results, "--steps", "drops", "--json", document))
    assert done.returncode == 0
    for said in ("42", "failed", "the same as another", "1 failed, ", "the file is empty"):
        assert said in done.stdout
    assert f"wrote {results / 'recordings.parquet'}" in done.stdout.replace("\n", "")
    told = json.loads(document.read_text())
    assert (told["recordings"], told["computed"]) == (len(NAMES) + 2, COMPUTED)
    assert (told["ok"], told["failed"], told["duplicates"]) == (40, 1, 1)


def test_a_text_without_a_table_is_no_row_of_the_tables_and_named(command, here, tmp_path):
    study(tmp_path, ["P01_left.csv"], {"notes.txt": "She was tired, 2 of 5 drops."})
    document = tmp_path / "run.json"
    asked = ("--steps", "drops", "--json", document)
    done = command("study", "run", tmp_path, "-o", tmp_path / "results", *asked)
    assert done.returncode == 0
    assert "left aside, as texts without a table of numbers: notes.txt\n" in done.stderr
    assert json.loads(document.read_text())["recordings"] == 1


def test_where_not_one_recording_can_be_measured_the_exit_code_says_so(command, here, tmp_path):
    (tmp_path / "P01_left.csv").write_text("time_s,raw_angle_rad\n")
    done = command("study", "run", tmp_path, "-o", tmp_path / "results", "--steps", "drops")
    assert done.returncode == 1


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--steps", "drop"), "'drop' is no step; they are drops, fit, diagnose."),
        (("--steps", "fit,fit"), "name each step once"),
        (("--with", "coulomb"), "no such term; did you mean coulomb_friction?"),
        (("--workers", "2", "--scheduler", "tcp://there:1"), "leave one out"),
        (("-o", "participants.csv"), "this is a file. Name a folder for the tables."),
        (("-o", "a/b"), "does not exist. Make it first."),
    ],
)
def test_what_cannot_be_run_is_refused_in_one_line(command, folder, options, said):
    assert said in refusal(command("study", "run", ".", "-o", "results", *options, cwd=folder))


def test_terms_of_the_model_are_those_of_every_fit_and_told_apart(
    command, here, folder, tmp_path, monkeypatch
):
    asked = []

    def run(found, results, settings, **how):
        asked.append(settings)
        raise ValueError("enough was seen")

    monkeypatch.setattr("exoid.studies.engine.run_study.run_study", run)
    for terms in ((), ("--with", "coulomb_friction"), ("--with", "coulomb_friction=0.1")):
        command("study", "run", folder, "-o", tmp_path / "results", *terms)
    plain, free, valued = asked
    assert "terms" not in plain.fit
    assert [term.__name__ for term in free.fit["terms"]] == ["CoulombFriction"]
    assert free.diagnose == plain.diagnose
    assert len({each.digest("fit") for each in asked}) == 3
    assert len({each.digest("drops") for each in asked}) == 1
    assert pickle.loads(pickle.dumps(valued)).digest("fit") == valued.digest("fit")


def test_a_run_says_whose_sides_look_exchanged(command, here, folder, tmp_path, monkeypatch):
    monkeypatch.setattr(
        "exoid.studies.statistics.visits.exchanged.exchanged",
        lambda study: (Exchanged("P01", ("day2",)),),
    )
    asked = ("--steps", "drops", "-o", tmp_path / "results")
    said = command("study", "run", folder, *asked).stdout.replace("\n", " ")
    assert "P01: left and right of visit day2 look exchanged" in said


def test_a_run_that_ctrl_c_ends_says_that_the_same_command_goes_on(
    command, here, folder, tmp_path, monkeypatch
):
    def run(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("exoid.studies.engine.run_study.run_study", run)
    done = command("study", "run", folder, "-o", tmp_path / "results")
    assert "What was computed is kept: the same command goes on from there.\n" in done.stderr


@pytest.mark.parametrize(
    ("lacking", "asked"),
    [("pyarrow", "run"), ("distributed", "run"), ("pyarrow", "report")],
)
def test_without_its_packages_a_study_names_the_one_extra_that_has_them(
    folder, tmp_path, lacking, asked
):
    made = [folder, "-o", tmp_path / "results"] if asked == "run" else [folder]
    without = f"import sys; sys.modules[{lacking!r}] = None; from exoid.cli import main; main()"
    command = [sys.executable, "-c", without, "study", asked, *map(str, made)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "which is missing: in a clone of exoid, python3 -m pip --python" in refusal(done)


def test_without_a_terminal_a_long_run_has_lines_and_a_short_one_none(
    command, here, folder, tmp_path, monkeypatch
):
    asked = ("study", "run", folder, "--steps", "drops", "-o")
    monkeypatch.setattr(module, "SHORT", 3600.0)
    assert command(*asked, tmp_path / "short").stderr == ""
    monkeypatch.setattr(module, "SHORT", 0.0)
    lines = command(*asked, tmp_path / "long").stderr.splitlines()
    assert f"exoid: drops: 0 of {COMPUTED} recordings" in lines
    assert lines[-1].startswith(f"exoid: drops: {COMPUTED} of {COMPUTED} recordings, ")


def test_a_log_tells_begins_tenths_and_what_takes_minutes(monkeypatch):
    now, told = [0.0], []
    monkeypatch.setattr(module.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(module.Screen, "tell", lambda screen, line: told.append(line))
    log = Log()
    for second, done in ((1, 0), (9, 90), (11, 91), (12, 100), (13, 101), (320, 102), (321, 103)):
        now[0] = float(second)
        log.hear(f"{done}", done, 1000)
    log.hear("next", 0, 1000)
    assert told == ["100", "102", "next"]
    log.tell()  # as its timer has it, where nothing more is heard
    assert told[-1] == "next"


def test_progress_tells_rate_and_time_left():
    assert line("recordings", 0, 1000, 5.0) == "0 of 1000 recordings"
    told = line("recordings", 120, 1000, 10.0)
    assert told == "120 of 1000 recordings, 12 a second, 1 min 13 s left"
    assert line("recordings", 2, 4, 720.0) == "2 of 4 recordings, 6 min 0 s each, 12 min 0 s left"
    assert lasting(7260.0) == "2 h 1 min"
