"""What the README shows runs as it stands."""

import re
from pathlib import Path

import jax
import numpy as np
import pytest

import exoid
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.sidecar import read_sidecar
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

README = Path(__file__).parents[1] / "README.md"
TEXT = README.read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
LONGEST = 160  # lines: it is one page


@pytest.fixture
def folder_with_a_drop(tmp_path, monkeypatch):
    leg = LegParameters(*map(np.asarray, (4.5, 0.44, 0.265, 0.35, 2.8)))
    movement = Movement(start_angle=-0.3, duration=3.0)
    recording = record(LegModel(leg, NoTorque()), [movement], jax.random.key(0))
    exoid.write_table(recording, tmp_path / "drop.csv")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.proof
def test_the_library_examples_run(folder_with_a_drop):
    assert BLOCKS
    for block in BLOCKS:
        exec(compile(block, "README.md", "exec"), {})
    assert (folder_with_a_drop / "fit.pdf").stat().st_size > 1000


def test_every_option_it_names_exists():
    from exoid.cli.app import COMMANDS, load

    commands = {name: load(name) for name in COMMANDS}
    known = {name for each in commands.values() for entry in each.params for name in entry.opts}
    for line in re.findall(rf"^.*\bexoid (?:{'|'.join(commands)}).*$", TEXT, re.MULTILINE):
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", line.split("exoid ", 1)[1]):
            assert option in known | {"--help"}, line


def test_it_is_one_page():
    assert len(TEXT.splitlines()) <= LONGEST


def test_what_it_links_to_exists():
    for link in re.findall(r"\]\(([^)#]+)\)", TEXT):
        assert (README.parent / link).exists(), link


def test_its_sidecar_is_understood(tmp_path):
    (block,) = re.findall(r"```toml\n(.*?)```", TEXT, re.DOTALL)
    path = tmp_path / "session.toml"
    path.write_text(block, encoding="utf-8")
    assert read_sidecar(path)[3] == ()  # nothing is unknown
