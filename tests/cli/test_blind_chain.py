"""A blind case carried from its recording to a model, a simulation and a plan, by commands alone.

What moved it is a rigid-body engine that shares no code with exoid.
"""

import json

import pytest

CASE, TERM = "pf194b", "quadratic_drag"
FAR = 4.5  # standard errors: beyond it lies one of 150,000
GRAVITY = 9.81  # m/s^2, of the case


@pytest.fixture(scope="module")
def truth(shared):
    """The ratios of the leg, and of the term to its inertia."""
    listed = json.loads((shared / "concealed" / "truth.json").read_text(encoding="utf-8"))
    (case,) = (each for each in listed if each["id"] == CASE)
    leg = case["baseline"]
    return {
        "gravity_over_inertia": leg["m"] * leg["l"] * GRAVITY / leg["J"],
        "stiffness_over_inertia": leg["c"] / leg["J"],
        "damping_over_inertia": leg["d"] / leg["J"],
        "coefficient_over_inertia": case["params"][TERM]["b_Nms2_rad2"] / leg["J"],
    }


@pytest.fixture(scope="module")
def folder(shared, command, tmp_path_factory):
    """What the commands wrote, each from what the one before it had."""
    folder = tmp_path_factory.mktemp("chain")
    recording, model, leg = (
        shared / "concealed" / f"{CASE}.csv",
        folder / "why.nc",
        folder / "leg.nc",
    )
    again = folder / "again.csv"
    for line in (
        ("diagnose", recording, "--save", model, "--json", folder / "why.json"),
        ("fit", recording, "--model", model, "--save", leg, "--json", folder / "leg.json"),
        ("simulate", again, "--model", leg, "--drop", -20, "--drop", -70, "--duration", 6),
        ("fit", again, "--model", leg, "--json", folder / "again.json"),
        ("plan", recording, "--model", model, "--json", folder / "plan.json"),
    ):
        done = command(*line)
        assert done.returncode == 0, done.stderr
    return folder


def ratios(found):
    return found["ratios"] | found["terms"][TERM]


@pytest.mark.proof
def test_the_concealed_term_becomes_the_model(folder, truth):
    why = json.loads((folder / "why.json").read_text())
    assert list(why["after"]["terms"]) == [TERM]
    told = json.loads((folder / "leg.json").read_text())
    for found in (why["after"], told, json.loads((folder / "again.json").read_text())):
        for name, value in truth.items():
            one = ratios(found)[name]
            assert abs(one["value"] - value) < FAR * one["standard_error"], name
    planned = json.loads((folder / "plan.json").read_text())
    assert planned["standard_error_after"] < 0.5 * planned["standard_error_before"]


@pytest.mark.proof
def test_eq_9_alone_is_wrong_by_more_than_a_tenth(folder, truth):
    """So the term was needed: the numbers before it are of another leg."""
    before = json.loads((folder / "why.json").read_text())["before"]["ratios"]
    for name in ("stiffness_over_inertia", "damping_over_inertia"):
        assert before[name]["value"] > 1.1 * truth[name]
