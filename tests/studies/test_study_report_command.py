"""`exoid study report` as a user calls it."""

import json

import pytest
from benchmarks.studies.tables import Design, simulate
from command_line import refusal


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    study = simulate(Design(people=10, drops=2), 0)
    study.recordings.to_parquet(folder / "recordings.parquet")
    study.quantities.to_parquet(folder / "quantities.parquet")
    return folder


def test_it_says_the_finding_and_writes_page_and_document(command, results, tmp_path):
    page, document = tmp_path / "report.html", tmp_path / "report.json"
    asked = ("--by", "group", "-o", page, "--json", document)
    done = command("study", "report", results, *asked)
    assert done.returncode == 0, done.stderr
    found = json.loads(document.read_text(encoding="utf-8"))
    words = " ".join(done.stdout.split())
    assert words.startswith(found["finding"])
    for title in ("Test and retest", "By group", "right - left", "Missing physics"):
        assert title in done.stdout
    assert f"wrote {page}" in done.stderr
    assert "exoid study report" in page.read_text(encoding="utf-8")
    (one,) = found["quantities"].values()
    assert one["groups"]["differences"][0]["second"] == "spastic"
    assert one["reliability"]["change"]["value"] > one["reliability"]["sem"]["value"]
    assert found["recordings"] == {"ok": 40}


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["--by", "colour"], "There is: group, dose"),
        (["--quantity", "inertie"], "There is: relaxation_index"),
        (["--before", "day1"], "name both"),
        (["-o", "report.txt"], "must end in .html"),
    ],
)
def test_what_is_not_there_is_one_line(command, results, tmp_path, arguments, word):
    said = refusal(command("study", "report", results, *arguments, cwd=tmp_path))
    assert word in said


def test_a_folder_without_results_is_one_line(command, tmp_path):
    assert "no recordings.parquet" in refusal(command("study", "report", tmp_path))


def test_a_page_that_is_there_is_told_before_anything_is_read(command, results, tmp_path):
    page = tmp_path / "report.html"
    page.write_text("mine")
    said = refusal(command("study", "report", tmp_path / "nothing", "-o", page))
    assert "report.html exists" in said
    assert page.read_text() == "mine"
