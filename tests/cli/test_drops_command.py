"""`exoid drops`: table, figure and document; what is refused is a failure only where all is."""

import json

import pytest
from command_line import refusal

from exoid.recordings.formats.own_table import write_table
from swings import NOISE, Oscillator, drop


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """full.csv (to its rest) and cut.csv."""
    path = tmp_path_factory.mktemp("drops")
    write_table(drop(noise=NOISE), path / "full.csv")
    write_table(drop(noise=NOISE, lasting=4.0), path / "cut.csv")
    return path


def test_a_drop_is_read_into_table_figure_and_document(command, folder, tmp_path):
    figure, document = tmp_path / "drops.svg", tmp_path / "drops.json"
    done = command("drops", folder / "full.csv", "--plot", figure, "--json", document)
    assert done.returncode == 0, done.stderr
    assert done.stderr == f"wrote {document}\nwrote {figure}\n"
    assert max(map(len, done.stdout.split("\n"))) <= 80
    assert "relaxation index" in done.stdout
    assert figure.read_bytes().startswith(b"<?xml")
    found = json.loads(document.read_text())
    assert found["recordings"][0].keys() == {"path", "sha256", "segments", "subject"}
    period = found["drops"][0]["measures"]["period"]
    assert abs(period["value"] - Oscillator().period) < 4.5 * period["standard_error"]


def test_what_a_record_does_not_allow_is_told_and_is_no_failure(command, folder):
    done = command("drops", folder / "cut.csv", folder / "full.csv")
    assert (done.returncode, done.stderr) == (0, "")
    said = " ".join(done.stdout.split())
    assert "Drop of segment cut.csv 0" in said
    assert "cut before rest" in said
    assert "Average over drops" in said


def test_without_a_path_it_reads_the_example(command):
    done = command("drops")
    assert done.returncode == 0
    assert done.stdout.startswith("No recording given: this is the example")
    assert "Drop of segment 3, which begins at" in done.stdout
    assert "s, 1 kg added" in done.stdout
    assert "a voluntary movement" in " ".join(done.stdout.split())


def test_a_record_without_any_drop_is_told_and_did_not_succeed(command, folder, tmp_path):
    path, figure = tmp_path / "active.csv", tmp_path / "active.pdf"
    path.write_bytes((folder / "cut.csv").read_bytes())
    path.with_suffix(".toml").write_text('[protocol]\nkind = "active"\n')
    done = command("drops", path, "--plot", figure)
    assert done.returncode == 1
    assert "a voluntary movement" in " ".join(done.stdout.split())
    assert "±" not in done.stdout
    assert done.stderr == f"exoid: no segment could be read: {figure} was not drawn.\n"
    assert not figure.exists()


@pytest.mark.parametrize("lasting", [0.1, 0.4])  # s: cut as it is let go, and in the fall
def test_a_drop_of_which_nothing_can_be_read_did_not_succeed(command, tmp_path, lasting):
    write_table(drop(noise=NOISE, lasting=lasting), tmp_path / "short.csv")
    done = command("drops", tmp_path / "short.csv")
    assert "Segments that were not read - 0: nothing to read: " in " ".join(done.stdout.split())
    assert "Drop of segment" not in done.stdout
    assert done.returncode == 1


def test_bad_input_is_refused_in_one_line(command, folder, tmp_path):
    assert "Check the name" in refusal(command("drops", tmp_path / "none.csv"))
    assert ".pdf or .svg or .png" in refusal(
        command("drops", folder / "cut.csv", "--plot", tmp_path / "a.txt")
    )
    assert "read here" in refusal(
        command("drops", folder / "cut.csv", "--json", folder / "cut.csv")
    )
