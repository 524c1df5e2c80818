"""What exoid writes keeps the rules of BIDS, by the schema that its makers publish."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from bidsschematools.rules import regexify_all
from bidsschematools.schema import load_schema

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.writing.convert_dataset import convert_dataset
from study_folders import study

VALIDATOR = shutil.which("bids-validator-deno")
PEOPLE = "id,body_mass_kg,height_m,age_years,sex,group\nP-01,77,1.8,30,F,a\nP-02,,,,,\n"
NAMES = ["P-01_left_pre.csv", "P-01_right_pre_2.csv", "P-02_left_pre.csv", "P-02_left_post.csv"]


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A study with ids and sessions that BIDS would not take as they are."""
    source = study(tmp_path_factory.mktemp("study"), NAMES, {"participants.csv": PEOPLE})
    target = tmp_path_factory.mktemp("bids")
    convert_dataset(open_dataset(source), target, "bids", whole=False, say=lambda word: None)
    return target


def paths(folder: Path) -> list[str]:
    return sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file())


def cells(path: Path) -> list[list[str]]:
    return [line.split("\t") for line in path.read_text(encoding="utf-8").splitlines()]


def keys_wanted(group: str) -> set[str]:
    """The keys that `_motion.json` must have."""
    rules = load_schema()["rules"]["sidecars"]["motion"][group]["fields"]
    levels = {
        name: rule if isinstance(rule, str) else rule["level"] for name, rule in rules.items()
    }
    return {name for name, level in levels.items() if level == "required"}


def test_every_file_has_a_name_that_bids_knows(written):
    rules = [re.compile(each["regex"]) for each in regexify_all()[0]]
    names = paths(written)
    assert len(names) > 20
    assert [name for name in names if not any(rule.fullmatch(name) for rule in rules)] == []
    assert not any(rule.fullmatch("sub-P-01/motion/left_motion.tsv") for rule in rules)


def test_the_metadata_has_what_bids_requires(written):
    wanted = keys_wanted("motionTaskInformation") | keys_wanted("motionRequired")
    assert wanted == {"TaskName", "SamplingFrequency"}
    for path in written.rglob("*_motion.json"):
        assert wanted <= json.loads(path.read_text()).keys()


def test_channels_are_of_types_that_bids_knows_in_its_order(written):
    schema = load_schema()
    columns = schema["objects"]["columns"]
    first = schema["rules"]["tabular_data"]["motion"]["motionChannels"]["initial_columns"]
    for path in written.rglob("*_channels.tsv"):
        head, *rows = cells(path)
        assert head[: len(first)] == [columns[name]["name"] for name in first]
        known = {name: {*columns[name]["enum"], "n/a"} for name in ("component", "type__channels")}
        assert {row[1] for row in rows} <= known["component"]
        assert {row[2] for row in rows} <= known["type__channels"] - {"n/a"}
        samples = cells(path.with_name(path.name.replace("_channels", "_motion")))
        assert {len(row) for row in samples} == {len(rows)}


def test_every_participant_has_one_row_and_every_row_a_folder(written):
    head, *rows = cells(written / "participants.tsv")
    assert head[0] == "participant_id"
    assert [row[0] for row in rows] == ["sub-P01", "sub-P02"]
    assert [row[0] for row in rows] == sorted(each.name for each in written.glob("sub-*"))
    assert rows[1][1:] == ["n/a"] * (len(head) - 1)
    assert {*head} - {"participant_id"} <= json.loads(
        (written / "participants.json").read_text()
    ).keys()


@pytest.mark.skipif(VALIDATOR is None, reason="bids-validator-deno is absent")
def test_the_validator_of_bids_finds_no_error(written):
    assert VALIDATOR is not None
    done = subprocess.run([VALIDATOR, "--json", str(written)], capture_output=True, text=True)
    issues = json.loads(done.stdout)["issues"]["issues"]
    assert [each for each in issues if each["severity"] == "error"] == []
    assert done.returncode == 0
