"""What is concealed in stored recordings is found, by the benchmark's own command."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from benchmarks.blind.answer import Answer
from benchmarks.blind.score import SOUND, mark

ROOT = Path(__file__).parents[2]
# Of every kind some, and of few shapes: each shape is compiled first.
CONCEALED = (
    *("p0582c", "p1bd2c", "p32cfe", "p6d961", "p769d3", "pcedc0", "pf194b", "pf49e9"),
    *("p44f4d", "p46ba4", "p4b567", "p5f26f", "pd4a7d"),
)


@pytest.fixture(scope="module")
def answers(shared, tmp_path_factory):
    folder = tmp_path_factory.mktemp("blind")
    cases = [word for name in (*CONCEALED, "motor-swing") for word in ("--case", name)]
    command = [sys.executable, "-m", "benchmarks.blind", *cases, "--to", str(folder)]
    cache = os.environ | {"XDG_CACHE_HOME": str(folder)}
    subprocess.run(command, cwd=ROOT, env=cache, check=True, capture_output=True)
    return json.loads((folder / "answers.json").read_text(encoding="utf-8"))


@pytest.mark.slow
@pytest.mark.parametrize("name", CONCEALED)
def test_what_is_concealed_is_the_first_name(name, answers, shared):
    listed = json.loads((shared / "concealed" / "truth.json").read_text(encoding="utf-8"))
    truth = next(each for each in listed if each["id"] == name)
    given = answers[name]
    answer = Answer(given["verdict"], tuple(given["ranking"]), novel=given["novel"])
    if truth["category"] in SOUND:
        assert answer.verdict == "none"
    else:
        assert mark(truth, answer).first, given
        # 1.2: the aim of held-out errors, in noise floors
        floor = truth["noise"]["floor_angle_rad"] * 180 / np.pi
        assert given["heldout_rmse_after"] < 1.2 * floor


@pytest.mark.slow
def test_dry_friction_is_found_in_a_motors_swing(answers):
    given = answers["motor-swing"]
    assert (given["verdict"], given["ranking"][0]) == ("mismatch", "coulomb_friction")
    assert given["heldout_rmse_after"] < 0.1 * given["heldout_rmse_before"]
