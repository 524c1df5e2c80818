"""exoid export: one command, five tools."""

import mujoco
import pytest
from command_line import refusal

import exoid

FORMS = {"mjcf": "xml", "urdf": "urdf", "osim": "osim", "c": "h", "python": "py"}


@pytest.fixture(scope="module")
def saved(recordings, tmp_path_factory):
    """A fit of one drop with dry friction, and one with what MuJoCo has nothing for."""
    from exoid.physics.terms.device.coulomb_friction import CoulombFriction

    folder = tmp_path_factory.mktemp("saved")
    result = exoid.fit(recordings / "drop.csv", terms=(CoulombFriction,), multistart=1)
    exoid.save_result(result, folder / "leg.nc")
    return folder


@pytest.mark.parametrize("form", FORMS)
def test_every_form_is_written_under_its_own_ending_and_its_table_said(command, saved, form):
    done = command("export", saved / "leg.nc", "--as", form, "--force", cwd=saved)
    assert done.returncode == 0, done.stderr
    name = f"leg.{FORMS[form]}"
    assert f"wrote {name}" in done.stderr
    wanted = exoid.export(exoid.load_result(saved / "leg.nc").result, form).text
    assert (saved / name).read_text(encoding="utf-8") == wanted
    rows = [line.split()[0] for line in done.stdout.splitlines() if line and line[0].isalpha()]
    assert {"leg", "coulomb_friction"} <= set(rows)


def test_opensim_has_its_own_name_too(command, saved):
    done = command("export", saved / "leg.nc", "--as", "opensim", "--force", cwd=saved)
    assert done.returncode == 0, done.stderr
    assert "wrote leg.osim" in done.stderr


def test_a_segment_is_exported_as_it_was(command, saved, tmp_path):
    path = tmp_path / "segment.xml"
    done = command("export", saved / "leg.nc", "--as", "mjcf", "--segment", 0, "-o", path)
    assert done.returncode == 0, done.stderr
    assert mujoco.MjModel.from_xml_path(str(path)).nkey == 1


def test_what_a_form_cannot_hold_is_warned_of_in_one_line(command, saved, tmp_path):
    done = command("export", saved / "leg.nc", "--as", "urdf", "-o", tmp_path / "leg.urdf")
    first, *_ = done.stderr.splitlines()
    assert first == "exoid: Not in this file, but in its comment: stiffness, encoder and gyro."
    assert done.returncode == 0


def test_bad_input_is_refused_in_one_line(command, saved, recordings, tmp_path):
    leg, form = saved / "leg.nc", ("--as", "mjcf")
    taken = tmp_path / "taken.xml"
    taken.write_text("mine")
    for arguments, said in (
        ((leg, *form, "-o", tmp_path / "leg.txt"), "the name must end in .xml or .mjcf"),
        ((leg, *form, "-o", taken), "taken.xml exists. Name another file, or replace it"),
        ((leg, *form, "-o", tmp_path / "x.xml", "--segment", 4), "no segment 4: the fit has"),
        ((tmp_path / "none.nc", *form, "-o", tmp_path / "x.xml"), "No such file"),
        ((recordings / "drop.csv", *form, "-o", tmp_path / "x.xml"), "drop.csv"),
        ((leg, "--as", "sdf"), "--as"),
    ):
        assert said in refusal(command("export", *arguments))
    assert taken.read_text() == "mine"
    assert not (tmp_path / "x.xml").exists()


def test_a_term_that_the_tool_has_nothing_for_is_refused_by_name(command, saved, tmp_path):
    from dataclasses import replace

    import jax.numpy as jnp

    from exoid.fitting.result.estimates.estimate import Estimate
    from exoid.physics.terms.tissue.hysteresis import Hysteresis

    result = exoid.load_result(saved / "leg.nc").result
    told = {
        name: Estimate("F", name, "N m", value, 0.01)
        for name, value in (("level", 0.1), ("yield_angle", 0.05))
    }
    term = Hysteresis(jnp.asarray(0.1), jnp.asarray(0.05))
    other = replace(result, fitted_terms=(term,), terms={"hysteresis": told})
    exoid.save_result(other, tmp_path / "other.nc")
    arguments = ("export", tmp_path / "other.nc", "--as", "mjcf", "-o", tmp_path / "leg.xml")
    said = refusal(command(*arguments))
    assert "nothing for hysteresis" in said
    assert "Export it for Python" in said
    assert not (tmp_path / "leg.xml").exists()


def test_a_fit_of_every_segment_alone_is_refused_with_what_to_do(command, saved, tmp_path):
    from dataclasses import replace

    result = exoid.load_result(saved / "leg.nc").result
    exoid.save_result(replace(result, leg=None), tmp_path / "each.nc")
    arguments = ("export", tmp_path / "each.nc", "--as", "c", "-o", tmp_path / "leg.h")
    assert "it holds no one model. Fit without --each." in refusal(command(*arguments))
