"""Terms on the command line: named, with values, of one's own, and of a saved model."""

import json

import pytest
from command_line import refusal

WORN = ("--drop", -20, "--drop", -50, "--duration", 3, "--body-mass", 74, "--height", 1.78)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("terms")


@pytest.mark.slow
def test_from_a_simulated_term_to_its_fit_to_its_simulation_to_its_plan(command, folder):
    worn, saved, told = folder / "worn.csv", folder / "worn.nc", folder / "worn.json"
    done = command("simulate", worn, "--with", "coulomb_friction=0.3", *WORN)
    assert (done.returncode, done.stderr) == (0, "")
    done = command("fit", worn, "--with", "coulomb_friction", "--multistart", 4,
                   "--save", saved, "--json", told)  # fmt: skip
    assert done.returncode == 0
    assert "Terms, beside Eq. 9" in done.stdout
    ratio = json.loads(told.read_text())["terms"]["coulomb_friction"]["level_over_inertia"]
    assert abs(ratio["value"] - 0.3 / 0.44) < 4.5 * ratio["standard_error"]
    assert (ratio["unit"], ratio["determined_by"]) == ("1/s^2", "data")
    again = folder / "again.csv"
    done = command("simulate", again, "--model", saved, *WORN)
    assert (done.returncode, done.stderr) == (0, "")
    assert again.read_text() != worn.read_text()
    body = [line for line in worn.with_suffix(".toml").read_text().splitlines() if "_kg" in line]
    assert body[0] in again.with_suffix(".toml").read_text()  # whose leg it is
    done = command("fit", again, "--model", saved, "--multistart", 2)
    assert done.returncode == 0
    assert "F_c / J" in done.stdout
    done = command("plan", worn, "--model", saved, "--goal", "coulomb_friction.level",
                   "--multistart", 2)  # fmt: skip
    assert done.returncode == 0
    assert "What to record next for coulomb_friction.level F_c" in done.stdout
    assert f"fit OLD NEW --model {saved}" in " ".join(done.stdout.split())
    said = refusal(command("plan", worn, "--model", saved, "--goal", "hysteresis.level"))
    assert "--goal hysteresis.level: it can be inertia" in said
    assert "coulomb_friction.level_over_inertia" in said


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--with", "coulomb_fricton=0.3"), "did you mean coulomb_friction?"),
        (("--with", "friction"), "coulomb_friction or load_friction or stribeck_friction?"),
        (("--with", "coulomb_friction"), "level is missing; give level [N m]"),
        (("--with", "coulomb_friction=much"), "'much' is no number; give level [N m]"),
        (("--with", "coulomb_friction=99"), "level is 0 to 50 N m"),
        (("--with", "coulomb_friction=0.1,0.2"), "coulomb_friction has level [N m], and no more"),
        (("--with", "hysteresis=yield_angle:0.1"), "level is missing"),
        (("--model", "nothing.nc"), "nothing.nc"),
    ],
)
def test_a_term_that_cannot_be_simulated_is_one_sentence(command, tmp_path, options, said):
    assert said in refusal(command("simulate", tmp_path / "leg.csv", *options))


def test_a_fit_refuses_a_term_that_is_none_before_it_reads(command, tmp_path):
    assert "did you mean gyro_bias?" in refusal(command("fit", "none.csv", "--with", "gyro_bas"))
