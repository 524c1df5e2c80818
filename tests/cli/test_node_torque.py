"""`exoid node load` and `torque`: a fitted leg goes to a node, which commands a torque by it."""

import json
from dataclasses import replace

import jax.numpy as jnp
import pytest
from command_line import refusal

import exoid
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.recordings.commissioning.torque_parameters import from_data
from fake_node import FakeBus, FakeNode

SERIAL = 0xC0FFEE01
NO_CLAIM = "Emulated and simulated only: no motor and no person was ever near it."


@pytest.fixture(scope="module")
def saved(recordings, tmp_path_factory):
    """A fit with dry friction, and the same with what no node has in its place."""
    folder = tmp_path_factory.mktemp("saved")
    result = exoid.fit(recordings / "drop.csv", terms=(CoulombFriction,), multistart=1)
    exoid.save_result(result, folder / "leg.nc")
    drag, told = QuadraticDrag(jnp.asarray(0.1)), result.terms["coulomb_friction"]["level"]
    said = {"quadratic_drag": {"coefficient": told}}
    exoid.save_result(replace(result, fitted_terms=(drag,), terms=said), folder / "drag.nc")
    return folder


@pytest.fixture
def on_bus(request, monkeypatch):
    """Nodes on a bus of the test's own, which answer at once; the options that lead there."""
    monkeypatch.setattr("exoid.recordings.commissioning.dialogue.PATIENCE", 0.2)
    running = []

    def started(*nodes):
        running.append(FakeBus(request.node.name, *nodes))
        return ("--interface", "virtual", "--channel", request.node.name)

    yield started
    for each in running:
        each.close()


def test_a_fitted_leg_is_downloaded_and_shown_with_its_units(command, on_bus, saved, tmp_path):
    node = FakeNode(SERIAL)
    there = on_bus(node, FakeNode(SERIAL + 1, node=3))
    shares = ("--gravity", 0.8, "--friction", 0.5, "--limit", 3)
    wanted = (*shares, "--node", "C0FFEE01")
    done = command("node", "load", saved / "leg.nc", *there, *wanted)
    assert (done.returncode, done.stderr) == (0, "")
    first, told, kept = done.stdout.splitlines()
    assert first == f"node 0 (serial C0FFEE01) holds {saved / 'leg.nc'}:"
    held = from_data(node.held)
    assert told.startswith(f"torque: gravity {held.gravity:g} N m, thigh angle ")
    assert f", inertia {held.inertia:g} kg m^2, gravity share 0.8, stiffness share 0, " in told
    assert told.endswith("limit 3 N m, rate limit 20 N m/s")
    assert kept.endswith("; kept in flash")
    path = tmp_path / "node.json"
    shown = command("node", "show", *there, "--node", "C0FFEE01", "--json", path)
    assert shown.stdout.splitlines()[-2:] == [told, kept]
    (entry,) = json.loads(path.read_text())["nodes"]
    assert entry["torque_parameters"]["gravity_share"] == pytest.approx(0.8, rel=1e-7)  # float32
    assert entry["torque_parameters"]["stored"] is True


def test_what_a_node_cannot_hold_is_refused_before_a_frame_is_sent(command, on_bus, saved):
    node = FakeNode(SERIAL)
    there = on_bus(node)
    for arguments, said in (
        ((saved / "leg.nc", "--inertia", 0.3), "the fit has told the leg's inertia"),
        ((saved / "drag.nc",), "nothing that acts like quadratic_drag"),
        ((saved / "none.nc",), "No such file"),
        ((saved / "leg.nc", "--gravity", 1.5), "--gravity"),
    ):
        assert said in refusal(command("node", "load", *arguments, *there))
    assert node.parts == b""


def test_a_torque_is_commanded_for_its_time_and_ends_at_zero(command, on_bus):
    node = FakeNode(SERIAL)
    asked = ("--enable", "--seconds", 1.2, "--limit", 2.5)
    done = command("node", "torque", *on_bus(node), *asked)
    assert (done.returncode, done.stderr) == (0, "")
    armed, *lines, last = done.stdout.splitlines()
    assert armed == "node 0 (serial C0FFEE01) is armed."
    assert [line.split()[-3:] for line in lines[1:]] == [["+0.50", "N", "m"]] * 2
    assert last == "The torque is 0."
    assert node.wishes[-1] == 0
    assert node.permit == 0
    assert node.limits == {2.5}


def test_without_enable_the_node_is_armed_alone(command, on_bus):
    node = FakeNode(SERIAL)
    done = command("node", "torque", *on_bus(node))
    assert done.returncode == 0
    assert "Nothing was enabled: give --enable." in done.stdout
    assert 2 not in node.wishes
    assert node.wishes[-1] == 0


def test_a_node_that_cuts_its_torque_ends_the_command_with_the_reason(command, on_bus):
    node = FakeNode(SERIAL, cuts=1 | 1 << 8, enabled_for=20)
    done = command("node", "torque", *on_bus(node), "--enable")
    assert done.returncode == 2
    assert "has cut its torque to 0: its encoder does not answer; its angle is stale" in done.stderr
    assert node.wishes[-1] == 0
    assert node.wishes.count(1) < node.wishes.index(2) + 1  # it is not armed again


def test_a_node_with_a_doubt_is_not_armed_and_says_why(command, on_bus, monkeypatch):
    monkeypatch.setattr("exoid.recordings.commissioning.torque_host.ARMING", 0.3)
    there = on_bus(FakeNode(SERIAL, doubts=1 << 9))
    said = refusal(command("node", "torque", *there, "--enable"))
    assert said.endswith("is not armed: it holds no whole parameters.")


def test_a_limit_between_two_steps_is_refused(command, on_bus):
    there = on_bus(FakeNode(SERIAL))
    assert "steps of 0.25 N m" in refusal(command("node", "torque", *there, "--limit", 1.1))


@pytest.mark.parametrize("name", ["load", "torque"])
def test_the_help_claims_no_safety(command, name):
    said = " ".join(command("node", name, "--help").stdout.split())
    assert NO_CLAIM in said
    assert "It is no safety function." in said
