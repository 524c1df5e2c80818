"""`exoid report`, and `--report` of other commands, as a user runs them."""

import hashlib
import json
import re

import pytest
from command_line import refusal


@pytest.fixture(scope="module")
def page(command, recordings, tmp_path_factory):
    """The page of a quick report."""
    path = tmp_path_factory.mktemp("report") / "leg.html"
    table = recordings / "drop.csv"
    done = command("report", table, "--no-diagnosis", "--multistart", 8, "--seed", 3, "-o", path)
    assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[-1] == f"wrote {path}"
    return path.read_text(encoding="utf-8")


def sections(text):
    return re.findall(r'<section id="(\w+)"', text)


def test_quick_report_has_no_diagnosis(page):
    assert "parameters" in sections(page)
    assert "physics" not in sections(page)


def test_report_tells_files_settings_and_the_command_that_repeats_it(page, recordings):
    for path in (recordings / "drop.csv", recordings / "drop.toml"):
        assert hashlib.sha256(path.read_bytes()).hexdigest() in page
    assert f"exoid report {recordings / 'drop.csv'} --no-diagnosis --multistart 8 --seed 3" in page
    for software in ("exoid", "jax", "numpy", "Python"):
        assert f'<th scope="row">{software}</th>' in page


def test_fit_writes_a_page_beside_its_document(command, recordings, tmp_path):
    path, document = tmp_path / "fit.html", tmp_path / "fit.json"
    done = command("fit", recordings / "session.blf", "--report", path, "--json", document)
    assert done.returncode == 0, done.stderr
    text = path.read_text(encoding="utf-8")
    assert "physics" not in sections(text)
    assert "What the CAN log says of itself" in text
    found = json.loads(document.read_text(encoding="utf-8"))
    assert found["recordings"][0]["sha256"] in text


def test_page_of_segments_that_were_fitted_alone_says_so(command, recordings, tmp_path):
    path = tmp_path / "each.html"
    done = command("fit", recordings / "two.csv", "--each", "--report", path)
    assert done.returncode == 0, done.stderr
    assert "Every segment was fitted alone" in path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        (["-o", "leg.pdf"], r"leg\.pdf: the name must end in \.html or \.htm\."),
        (["-o", "absent/leg.html"], r"the folder absent does not exist\. Make it first\."),
        (["--no-diagnosis", "--terms", "mine.py"], r"leave out --no-diagnosis"),
        (["--body-mass", "1"], r"--body-mass is 1 kg; it must lie between"),
    ],
)
def test_what_cannot_be_is_refused_before_anything_is_computed(
    command, recordings, tmp_path, arguments, why
):
    done = command("report", recordings / "drop.csv", *arguments, cwd=tmp_path)
    assert re.search(why, refusal(done))
    assert not list(tmp_path.iterdir())


def test_an_existing_page_survives_a_failing_run(command, tmp_path):
    kept = tmp_path / "report.html"
    kept.write_text("kept", encoding="utf-8")
    empty = tmp_path / "empty.csv"
    empty.write_text("", encoding="utf-8")
    refusal(command("report", empty, "-o", kept))
    assert kept.read_text(encoding="utf-8") == "kept"
