"""`exoid plan`, and `exoid fit` on several recordings of one leg."""

import json
from dataclasses import replace
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import pytest
from command_line import refusal
from sessions import DROP, LEG, SUBJECT, session

from exoid.cli.commands import plan
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.splitting.split import split
from exoid.twin.motion import Movement

LOADED = replace(DROP, added_mass=1.0, added_mass_distance=0.4)


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """The same leg with a mass at a place that nobody measured."""
    recording = split(session(LOADED))
    path = tmp_path_factory.mktemp("loaded") / "loaded.csv"
    subject = replace(recording.subject, added_mass_distance=None)
    write_table(replace(recording, subject=subject), path)
    return path


def planned(command, folder, *arguments):
    path = folder / "plan.json"
    done = command("plan", *arguments, "--json", path)
    assert done.returncode == 0, done.stderr
    return done.stdout, json.loads(path.read_text(encoding="utf-8"))


def test_a_plan_after_a_bare_drop_asks_for_a_loaded_one(command, recordings, tmp_path):
    said, document = planned(command, tmp_path, recordings / "drop.csv")
    assert "What to record next for inertia J" in said
    assert "kg at the ankle" in said
    assert "let go without a push" in " ".join(said.split())
    # Damping and stiffness that may change with the load leave J some per cent; anatomy, 10.
    assert document["standard_error_after"] < 0.5 * document["standard_error_before"]
    assert any(each["added_mass_kg"] > 0 for each in document["proposed"])
    errors = [each["standard_error"] for each in document["options"]]
    assert errors == sorted(errors)


def test_a_first_session_is_planned_without_any_recording(command, tmp_path):
    said, document = planned(
        command, tmp_path, "--body-mass", 74, "--height", 1.78, "--goal", "damping"
    )
    assert "What to record next for damping d" in said
    kinds = {each["added_mass_kg"] > 0 for each in document["proposed"]}
    assert kinds == {True, False}


@pytest.mark.proof
def test_a_plan_for_what_no_motion_tells_says_so(command, recordings):
    done = command("plan", recordings / "drop.csv", "--goal", "com_distance")
    assert done.returncode == 0
    assert "motion shows only the product m l" in " ".join(done.stdout.split())


def test_a_goal_that_does_not_exist_is_refused(command, recordings):
    drop = recordings / "drop.csv"
    assert "--goal" in refusal(command("plan", drop, "--goal", "beauty"))
    told = refusal(command("plan", drop, "--goal", "coulomb_friction.level"))
    assert "add --with coulomb_friction" in told


def test_rivals_that_cannot_be_told_apart_are_refused(command, recordings):
    drop = recordings / "drop.csv"
    misspelt = refusal(command("plan", drop, "--between", "coulom_friction,hysteresis"))
    assert "--between coulom_friction: there is no such term; did you mean coulomb_f" in misspelt
    assert "two terms" in refusal(command("plan", drop, "--between", "hysteresis"))
    assert "need a recording" in refusal(command("plan", "--between", "hysteresis,backlash"))
    both = command("plan", drop, "--between", "hysteresis,backlash", "--goal", "damping")
    assert "leave --goal" in refusal(both)


def test_sets_are_told_apart_as_they_are_named():
    rivals, _ = plan.asked("backlash, backlash+coulomb_friction", None, None, (), None)
    assert rivals == ((Backlash,), (Backlash, CoulombFriction))
    with pytest.raises(ValueError, match=r"coulomb_friction\+backlash: it was said before"):
        plan.asked("backlash+coulomb_friction,coulomb_friction+backlash", None, None, (), None)
    with pytest.raises(ValueError, match="two terms or more, with commas"):
        plan.asked("backlash+coulomb_friction", None, None, (), None)


def test_terms_of_ones_own_are_asked_for_by_name(command, recordings, tmp_path):
    mine = tmp_path / "mine.py"
    mine.write_text("from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag\n"
                    "class Mud(QuadraticDrag):\n    title = 'mud'\n")  # fmt: skip
    for name in ("plan", "fit"):
        said = refusal(command(name, recordings / "drop.csv", "--terms", mine))
        assert "give --with with the names of those that you want; there are mud" in said


def test_what_a_diagnosis_suspects_is_told_apart_by_default(monkeypatch):
    monkeypatch.setattr(plan, "suspected_in", lambda model, own: ["coulomb_friction", "backlash"])
    rivals, chosen = plan.asked(None, None, None, (), Path("why.nc"))
    assert (rivals, chosen) == (((CoulombFriction,), (Backlash,)), ())
    # A goal is asked of the model that was saved.
    monkeypatch.setattr(plan, "saved_model", lambda model, own: Mock(terms=()))
    assert plan.asked(None, plan.INERTIA, None, (), Path("why.nc")) == ((), ())


def test_a_rig_is_refused_before_anything_is_computed(command, tmp_path, monkeypatch):
    recording = split(session(DROP))
    write_table(replace(recording, subject=Subject(kind="rig")), tmp_path / "rig.csv")
    monkeypatch.setattr(plan, "compute", Mock(side_effect=AssertionError("it computes")))
    assert "can be taken apart and weighed" in refusal(command("plan", tmp_path / "rig.csv"))


def test_a_missing_recording_is_named(command, tmp_path):
    assert "nothing.csv" in refusal(command("plan", tmp_path / "nothing.csv"))


@pytest.mark.proof
def test_bare_and_loaded_recordings_give_the_scale_and_the_place_of_the_mass(
    command, recordings, loaded, tmp_path
):
    path = tmp_path / "fit.json"
    done = command("fit", recordings / "drop.csv", loaded, "--json", path)
    assert done.returncode == 0, done.stderr
    document = json.loads(path.read_text(encoding="utf-8"))
    inertia = document["parameters"]["inertia"]
    assert inertia["determined_by"] == "data"
    assert inertia["shares"]["data"] > 0.9
    assert inertia["value"] == pytest.approx(LEG["inertia"], rel=0.01)
    assert inertia["profile"]["shape"] == "two-sided"
    mounting = next(m for m in document["mountings"] if m["recording"] == "loaded.csv")
    assert mounting["added_mass_distance"]["value"] == pytest.approx(0.4, abs=0.01)
    assert "Mounting, of each recording" in done.stdout


def test_a_loaded_drop_alone_is_called_singular(command, loaded):
    done = command("fit", loaded)
    assert done.returncode == 0
    assert "(singular): add a drop of the bare leg" in " ".join(done.stdout.split())
    assert "prior" in next(x for x in done.stdout.splitlines() if x.startswith("inertia J"))


def test_recordings_of_different_bodies_are_refused(command, recordings, tmp_path):
    other = split(session(DROP))
    write_table(replace(other, subject=replace(SUBJECT, body_mass=60.0)), tmp_path / "other.csv")
    line = refusal(command("fit", recordings / "drop.csv", tmp_path / "other.csv"))
    assert "other.csv says body_mass 60 kg" in line
    assert "drop.csv says 74 kg" in line


def test_a_distance_without_a_mass_is_refused(command, tmp_path):
    path = tmp_path / "drop.csv"
    write_table(split(session(Movement(np.radians(-12), 2.0))), path)
    sidecar = path.with_suffix(".toml")
    sidecar.write_text(
        sidecar.read_text().replace("[subject]", "[subject]\nadded_mass_distance_m = 0.4")
    )
    assert "without added_mass_kg" in refusal(command("fit", path))


def test_a_posterior_needs_a_name_that_ends_in_nc_and_one_fit(command, recordings, tmp_path):
    drop = recordings / "drop.csv"
    assert ".nc" in refusal(command("fit", drop, "--posterior", tmp_path / "p.csv"))
    assert "--each" in refusal(command("fit", drop, "--each", "--posterior", tmp_path / "p.nc"))
