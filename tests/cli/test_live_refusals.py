"""`exoid live` on bad options: one line that says what and where, and nothing written."""

import sys

import pytest
from command_line import refusal

from exoid.cli.inputs.reading import EXAMPLE


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "give a recording to follow, or --channel of a bus: neither is given"),
        (["leg.blf", "--channel", "x"], "both are given"),
        (["leg.blf", "-o", "other.blf"], "-o is of a bus"),
        (["leg.blf", "--duration", "3"], "--duration is of a bus"),
        (["--channel", "x", "--flip", "all"], "--flip is of a recording"),
        (["leg.blf", "--speed", "fast"], "--speed fast: give a number such as 1 or 2.5, or max"),
        (["leg.blf", "--speed", "0"], "--speed 0"),
        (["leg.blf", "--speed", "inf"], "--speed inf"),
        (["leg.blf", "--speed", "1_0"], "--speed 1_0: give a number"),
        (["leg.blf"], "leg.blf: No such file or directory"),
        (["leg.blf", "--until", "weight=2%"], "--until weight=2%: there is no 'weight'"),
        (["leg.blf", "--until", "inertia=1%", "--until", "inertia=2%"], "names a quantity twice"),
        (["leg.blf", "--until", "inertia=1_0%"], "is not like --until inertia=2%"),
        (["leg.blf", "--port", "8000"], "--port is of the page, which --serve shows"),
        (["leg.blf", "--host", "0.0.0.0"], "--host is of the page, which --serve shows"),
        (["leg.blf", "--with", "friction"], "there is no such term"),
        (["leg.blf", "--with", "hysteresis"], "it has a memory of its own"),
        (["leg.blf", "--with", "gyro_bias"], "it is estimated in any case"),
        (["leg.blf", "--with", "stiffness_rest_angle"], "a constant torque; ask for torque_bias"),
        (["leg.blf", "--with", "load_friction"], "is a share of a load that is estimated, too"),
        (["leg.blf", "--with", "coulomb_friction=0.1"], "Name it alone"),
        (["leg.blf", "--json-lines", "nowhere/rows"], "the folder nowhere does not exist"),
        (["leg.blf", "--body-mass", "7700"], "--body-mass is 7700 kg"),
        (["--channel", "x", "--added-mass-distance", "0.4"], "without --added-mass"),
        (["--channel", "x", "-o", "leg.csv"], "a recording ends in .blf"),
        (["--channel", "x", "-o", "leg.blf", "--json-lines", "leg.toml"], "or written twice"),
        (["--channel", "x", "--segment"], "the standard input is no terminal"),
        (["--channel", "no-port"], "slcan no-port cannot be opened"),
        (["--channel", "x", "--port", "70000"], "'--port'"),
    ],
)
def test_an_absurd_option_is_refused(command, tmp_path, options, said):
    done = command("live", *options, cwd=tmp_path)
    assert said in refusal(done)
    assert not list(tmp_path.iterdir())


def test_what_is_there_is_not_replaced(command, tmp_path):
    (tmp_path / "rows").write_text("old")
    done = command("live", EXAMPLE, "--json-lines", tmp_path / "rows")
    assert "exists. Name another file, or replace it with --force" in refusal(done)
    assert (tmp_path / "rows").read_text() == "old"


def test_a_page_without_its_packages_is_refused_in_one_line(command, monkeypatch):
    from exoid.files import extras

    found = extras.find_spec
    monkeypatch.setattr(
        extras, "find_spec", lambda name: None if name == "uvicorn" else found(name)
    )
    done = command("live", EXAMPLE, "--serve")
    assert done.returncode == 2
    assert done.stderr.strip() == (  # before the file is decoded, of which nothing is said
        "exoid: a page is served by uvicorn, which is missing: in a clone of exoid, python3 -m pip "
        f"--python {sys.executable} install '.[live]'"
    )
