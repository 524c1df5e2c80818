"""A rig's recording carried to a model, a simulation and a plan, by commands alone: nothing that
was found is lost on the way.
"""

import json

import pytest

TERM = "coulomb_friction"  # what its makers say of it, in one form or another


@pytest.fixture(scope="module")
def folder(shared, command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("rig")
    recording, model = shared / "real" / "servo-drop.csv", folder / "why.nc"
    for line in (
        ("diagnose", recording, "--save", model, "--json", folder / "why.json"),
        ("fit", recording, "--model", model, "--json", folder / "fit.json"),
        ("simulate", folder / "again.csv", "--model", model, "--drop", -20),
        ("plan", recording, "--model", model, "--json", folder / "plan.json"),
    ):
        done = command(*line)
        assert done.returncode == 0, done.stderr
    return folder


@pytest.mark.proof
def test_what_was_found_is_in_every_step(folder):
    why = json.loads((folder / "why.json").read_text())
    assert why["selected"] == [TERM]
    told = json.loads((folder / "fit.json").read_text())
    for found in (why["after"], told):
        level = found["terms"][TERM]["level_over_inertia"]
        assert level["value"] == pytest.approx(1.76, abs=0.24)  # the error that it says
        assert found["terms"][TERM]["level"]["value"] is None  # no motion tells a rig's inertia
        assert found["fit"]["angle_rmse_rad"] < 0.5 * why["before"]["fit"]["angle_rmse_rad"]
    assert any("cannot tell coulomb friction from stribeck" in each for each in told["notes"])
    assert {TERM, "stribeck_friction"} <= {
        *json.loads((folder / "plan.json").read_text())["between"]
    }
    assert (folder / "again.csv").is_file()
