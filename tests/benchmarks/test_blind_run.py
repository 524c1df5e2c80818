"""What is concealed in stored recordings is found, by the benchmark's own command."""

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from benchmarks.blind.answer import Answer
from benchmarks.blind.score import SOUND, mark

ROOT = Path(__file__).parents[2]
# Single effects and nothing. Each row has one shape, which is compiled once, and of that shape the
# cases that take the least time.
PASSIVE = ("p1bd2c", "p769d3", "pcedc0", "pf49e9")
ACTIVE = ("p4b567", "p5ae79", "p5f26f")
MOTOR = ("motor-ringing",)
ROWS = {name: row for row in (PASSIVE, ACTIVE, MOTOR) for name in row}


@pytest.fixture(scope="module")
def answer(shared, programs, tmp_path_factory):
    """What the benchmark says of a case; it runs the whole row of the case."""

    @cache
    def answers(row):
        folder = tmp_path_factory.mktemp("blind")
        cases = [word for name in row for word in ("--case", name)]
        command = [sys.executable, "-m", "benchmarks.blind", *cases, "--to", str(folder)]
        environment = os.environ | {"XDG_CACHE_HOME": str(programs)}
        subprocess.run(command, cwd=ROOT, env=environment, check=True, capture_output=True)
        return json.loads((folder / "answers.json").read_text(encoding="utf-8"))

    return lambda name: answers(ROWS[name])[name]


@pytest.mark.proof
@pytest.mark.parametrize("name", PASSIVE + ACTIVE)
def test_what_is_concealed_is_the_first_name(name, answer, shared):
    listed = json.loads((shared / "concealed" / "truth.json").read_text(encoding="utf-8"))
    truth = next(each for each in listed if each["id"] == name)
    given = answer(name)
    said = Answer(given["verdict"], tuple(given["ranking"]), novel=given["novel"])
    if truth["category"] in SOUND:
        assert said.verdict == "none"
    else:
        assert mark(truth, said).first, given
        # 1.2: the aim of held-out errors, in noise floors
        floor = truth["noise"]["floor_angle_rad"] * 180 / np.pi
        assert given["heldout_rmse_after"] < 1.2 * floor


@pytest.mark.proof
def test_dry_friction_is_found_in_a_motors_ringing(answer):
    given = answer("motor-ringing")
    assert (given["verdict"], given["ranking"][0]) == ("mismatch", "coulomb_friction")
    assert given["heldout_rmse_after"] < 0.25 * given["heldout_rmse_before"]
