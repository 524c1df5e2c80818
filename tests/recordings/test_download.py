"""Parameters of a torque on their way to a node: taken as they are, or not at all."""

import struct
from binascii import crc_hqx
from dataclasses import replace

import pytest

from exoid.recordings.commissioning import dialogue
from exoid.recordings.commissioning.dialogue import Dialogue, NotWholeError
from exoid.recordings.commissioning.download import download
from exoid.recordings.commissioning.told_parameters import ToldParameters
from exoid.recordings.commissioning.torque_parameters import TorqueParameters, from_data
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from fake_node import LAYOUT_CRC, PLACES, FakeBus, FakeNode

LEG = TorqueParameters(8.0, 0.1, 2.0, 0.3, 0.2, 0.31, 0.5, 0.0, 0.0, 0.25, 5.0, 20.0)
SERIAL = 0xC0FFEE01


@pytest.fixture
def talk(request, monkeypatch):
    """A dialogue with a node; a question is given up quickly."""
    monkeypatch.setattr(dialogue, "PATIENCE", 0.2)
    running = []

    def started(node: FakeNode):
        there = FakeBus(request.node.name, node)
        bus = LiveBus(BusAddress("virtual", request.node.name, 500_000))
        running.extend((bus, there))
        talk = Dialogue(bus)
        return talk, talk.find()[0]

    yield started
    for each in running:
        each.close()


def test_they_are_held_and_told_to_the_bit_of_float32(talk):
    node = FakeNode(SERIAL)
    held = download(*talk(node), LEG)
    assert node.held == LEG.data
    assert held.values == from_data(LEG.data)
    assert (held.crc, held.whole, held.stored) == (LEG.crc, True, True)


def test_a_part_that_is_missed_is_sent_again(talk):
    node = FakeNode(SERIAL, deaf={"EXO_LOAD": 2})
    assert download(*talk(node), LEG).values == from_data(LEG.data)


def test_a_node_that_loses_its_parts_gets_them_anew(talk):
    class Forgetful(FakeNode):
        times = 0

        def load(self, place, data):
            self.times += 1
            self.parts = b"" if self.times == 9 else self.parts
            super().load(place, data)

    node = Forgetful(SERIAL)
    assert download(*talk(node), LEG).crc == LEG.crc
    assert node.times == 9 + 2 * PLACES + 1


def test_a_node_that_never_gets_them_whole_keeps_those_before(talk):
    class Noisy(FakeNode):
        def load(self, place, data):
            super().load(place, data ^ (place == 7))

    before = replace(LEG, gravity=7.0).data
    node = Noisy(SERIAL, held=before)
    with pytest.raises(NotWholeError, match="keeps those before"):
        download(*talk(node), LEG)
    assert node.held == before


def test_a_node_that_tells_others_is_not_believed(talk, monkeypatch):
    monkeypatch.setattr("exoid.recordings.commissioning.download.TELLING", 0.3)

    class Deaf(FakeNode):
        def load(self, place, data):
            """It acknowledges and does nothing."""

    with pytest.raises(CanBusError, match="has acknowledged the parameters, but does not tell"):
        download(*talk(Deaf(SERIAL)), LEG)


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("gravity", -0.5, "gravity = -0.5 N m: a node takes 0 to 60"),
        ("friction_share", 1.01, "friction_share = 1.01 : a node takes 0 to 1"),
        ("inertia", float("nan"), "inertia = nan kg m.2: a node takes 0 to 2"),
        ("rate_limit", float("inf"), "rate_limit = inf N m/s: a node takes 0 to 100"),
    ],
)
def test_what_a_node_does_not_take_is_refused_before_it_is_sent(talk, name, value, said):
    node = FakeNode(SERIAL)
    with pytest.raises(ValueError, match=said):
        download(*talk(node), replace(LEG, **{name: value}))
    assert (node.parts, node.held) == (b"", b"")


def test_what_is_told_of_two_legs_is_never_mixed():
    told, other = ToldParameters(), replace(LEG, gravity=9.0)

    def hear(leg: TorqueParameters, place: int) -> None:
        value = struct.unpack("<12f", leg.data)[place]
        frame = {"Place": place, "Value": value, "Crc": leg.crc, "Stored": 1}
        told.hear({name: float(number) for name, number in frame.items()})

    for place in range(8):
        hear(LEG, place)
    for place in [*range(8, 12), *range(7)]:
        hear(other, place)
        assert told.held() is None
    hear(other, 7)
    held = told.held()
    assert held is not None
    assert held.values == from_data(other.data)


def test_the_crc_begins_with_that_of_the_layout():
    assert LEG.crc == crc_hqx(LEG.data, LAYOUT_CRC)
