"""`exoid node`: a node is found and commissioned over its bus, or one line says what to check."""

import json

import pytest

from fake_node import FakeBus, FakeNode

SERIAL = 0xC0FFEE01
OTHER = 0x1234ABCD


@pytest.fixture
def on_bus(request, monkeypatch):
    """Nodes on a bus of the test's own, which answer at once; the options that lead there."""
    monkeypatch.setattr("exoid.recordings.commissioning.dialogue.PATIENCE", 0.2)
    running = []

    def started(*nodes):
        channel = request.node.name
        running.append(FakeBus(channel, *nodes))
        return ("--interface", "virtual", "--channel", channel)

    started.running = running
    yield started
    for each in running:
        each.close()


def test_find_shows_every_node_with_version_serial_settings_supply_and_errors(command, on_bus):
    there = on_bus(FakeNode(SERIAL, zero=1000, changes=1), FakeNode(OTHER, node=3, errors=7))
    done = command("node", "find", *there)
    assert (done.returncode, done.stderr) == (0, "")
    heads, first, second = done.stdout.splitlines()
    assert " ".join(heads.split()) == "id serial firmware zero count bit rate supply state"
    assert " ".join(first.split()) == "0 C0FFEE01 1.2.3 1000 rises 500 kbit/s 3.26 V well"
    assert second.startswith("3   1234ABCD")
    assert second.endswith("not commissioned, 7 transmit errors")


def test_find_writes_the_same_for_machines(command, on_bus, tmp_path):
    there = on_bus(FakeNode(OTHER, node=3, errors=7, reversed=True))
    done = command("node", "find", *there, "--json", tmp_path / "nodes.json")
    assert done.returncode == 0, done.stderr
    assert json.loads((tmp_path / "nodes.json").read_text())["nodes"] == [
        {
            "id": 3,
            "serial": "1234ABCD",
            "zero_counts": 2048,
            "reversed": True,
            "commissioned": False,
            "bit_rate": 500_000,
            "changes": 0,
            "health": {
                "firmware": "1.2.3",
                "supply_v": 3.26,
                "transmit_errors": 7,
                "receive_errors": 0,
                "lost_frames": 0,
                "sensor_fault": False,
                "can_off": False,
                "on_can": True,
            },
        }
    ]


def test_two_nodes_of_one_id_are_named(command, on_bus):
    done = command("node", "find", *on_bus(FakeNode(SERIAL), FakeNode(OTHER)))
    assert done.returncode == 0
    (line,) = done.stderr.splitlines()
    assert "2 nodes have the id 0" in line
    assert "exoid node set --node SERIAL --id ID" in line


def test_show_says_all_of_one_node(command, on_bus):
    done = command("node", "show", *on_bus(FakeNode(SERIAL, reversed=True, changes=4)))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "node 0, serial C0FFEE01, firmware 1.2.3",
        "zero 2048, the encoder's count falls in extension",
        "CAN bus at 500 kbit/s",
        "supply 3.26 V; errors: transmit 0, receive 0, frames lost 0; settings stored 4 times",
        "state: well",
    ]


@pytest.mark.parametrize(
    ("reversed", "angle", "zero"), [(False, 0, 1000), (False, -90, 2024), (True, -90, 4072)]
)
def test_zero_takes_the_angle_that_the_knee_has(command, on_bus, reversed, angle, zero):
    node = FakeNode(SERIAL, reversed=reversed)
    done = command("node", "zero", *on_bus(node), "--angle", angle)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == (
        f"node 0 (serial C0FFEE01): the knee is at {angle} deg; the zero was 2048 and is {zero}.\n"
    )
    assert node.zero == zero


def test_a_knee_that_moves_is_not_taken_for_zero(command, on_bus):
    node = FakeNode(SERIAL, velocity=-0.5)
    done = command("node", "zero", *on_bus(node))
    assert (done.returncode, done.stdout) == (2, "")
    assert "moves at 29 deg/s: its angle was not taken. Hold it still and repeat." in done.stderr
    assert node.changes == 0


def test_set_changes_direction_id_and_bit_rate_at_once(command, on_bus):
    node = FakeNode(SERIAL)
    options = ("--direction", "falls", "--id", 2, "--rate", 250_000)
    done = command("node", "set", *on_bus(node), *options)
    assert (done.returncode, done.stderr) == (0, "")
    assert (node.reversed, node.node, node.bit_rate, node.changes) == (True, 2, 250_000, 3)
    assert done.stdout.startswith("node 2, serial C0FFEE01")
    assert done.stdout.splitlines()[-1].endswith("starts again: --bitrate 250000 then.")


@pytest.mark.parametrize("options", [("--direction", "falls"), ("--id", 2)])
def test_set_tells_the_firmware_that_the_node_told_before(command, on_bus, options):
    done = command("node", "set", *on_bus(FakeNode(SERIAL)), *options)
    assert ", serial C0FFEE01, firmware 1.2.3\n" in done.stdout
    assert "supply 3.26 V" in done.stdout


def test_one_of_several_nodes_is_meant_by_its_id_or_its_serial(command, on_bus):
    nodes = [FakeNode(SERIAL), FakeNode(OTHER), FakeNode(77, node=5)]
    there = on_bus(*nodes)
    assert command("node", "identify", *there, "--node", "5", "--duration", 3).returncode == 0
    assert command("node", "set", *there, "--node", "1234abcd", "--id", 1).returncode == 0
    assert [node.blinks for node in nodes] == [0, 0, 3]
    assert [node.node for node in nodes] == [0, 1, 5]


@pytest.mark.parametrize("lost", ["EXO_TELL", "EXO_SET_ZERO"])
def test_what_is_lost_is_sent_again(command, on_bus, lost):
    node = FakeNode(SERIAL, deaf={lost: 2})
    done = command("node", "zero", *on_bus(node))
    assert done.returncode == 0, done.stderr
    assert node.zero == 1000


@pytest.mark.parametrize(
    ("nodes", "options", "said"),
    [
        ([FakeNode(1), FakeNode(2, node=4)], (), "2 nodes answer: 0 (00000001), 4 (00000002). Say"),
        ([FakeNode(1), FakeNode(2)], ("--node", "0"), "Say which one is meant: --node SERIAL."),
        ([FakeNode(1)], ("--node", "3"), "--node 3: nobody answers to that. The ids (serials)"),
        ([FakeNode(1)], ("--node", "x"), "--node x: give an id such as 2, or a serial"),
        ([], (), "no node answers on virtual"),
        ([FakeNode(1, answers=False)], (), "one sends (id 0): its firmware is older"),
        ([FakeNode(1, fails="NoAngle")], (), "node 0 (serial 00000001) has no angle: its encoder"),
        ([FakeNode(1, fails="NotStored")], (), "could not store it: it counts until"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_line(command, on_bus, nodes, options, said):
    done = command("node", "zero", *on_bus(*nodes), *options)
    assert (done.returncode, done.stdout) == (2, "")
    (line,) = done.stderr.splitlines()
    assert said in line
    assert all(node.changes == 0 for node in nodes)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["node"], "Missing command. Try 'exoid node --help'."),
        (["node", "find"], "Missing option '--channel'"),
        (["node", "fnd"], "No such command 'fnd'"),
        (["node", "set", "--channel", "x"], "nothing to set: give --direction, --id or --rate."),
        (["node", "set", "--channel", "x", "--rate", 7], "--rate 7: it can be 125000, 250000"),
        (
            ["node", "set", "--channel", "x", "--id", 16],
            "'--id': it must be less than or equal",
        ),
        (["node", "zero", "--channel", "x", "--angle", "200"], "less than or equal to 180"),
        (["node", "zero", "--channel", "x", "--angle", "nan"], "--angle"),
        (["node", "set", "--channel", "x", "--direction", "up"], "'up' is not one of 'rises'"),
        (["node", "find", "--channel", "/dev/none"], "/dev/none cannot be opened"),
        (["node", "find", "--channel", "x", "--json", "no/such.json"], "no"),
    ],
)
def test_a_mistake_is_told_in_one_line(command, arguments, said):
    done = command(*arguments)
    assert (done.returncode, done.stdout) == (2, "")
    (line,) = done.stderr.splitlines()
    assert said in line


def test_a_node_that_falls_silent_is_named(command, on_bus, monkeypatch):
    there = on_bus(FakeNode(SERIAL))
    take = on_bus.running[0].take

    def take_questions(message):
        if message.arbitration_id == 0x200:
            take(message)

    monkeypatch.setattr(on_bus.running[0], "take", take_questions)
    done = command("node", "identify", *there)
    assert done.returncode == 2
    assert "node 0 (serial C0FFEE01) does not answer to EXO_IDENTIFY" in done.stderr


def test_a_zero_is_not_taken_of_a_knee_that_nobody_sees(command, on_bus):
    node = FakeNode(SERIAL, measures=False)
    done = command("node", "zero", *on_bus(node))
    (line,) = done.stderr.splitlines()
    assert (done.returncode, done.stdout) == (2, "")
    assert "node 0 (serial C0FFEE01) answers, but sends no EXO_STATE" in line
    assert "its angle was not taken. exoid node show says whether" in line
    assert node.zero == 2048
