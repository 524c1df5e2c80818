"""Asking a port for nodes: where none answers, it is said what came instead, and what to check."""

import pytest

from exoid.recordings.commissioning import dialogue
from exoid.recordings.commissioning.dialogue import Dialogue
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from live_node import NO_WAIT, Cable, line, numbered

POSITION = b"$GPGGA,123519,4807.038,N,01131.000,E,1,08\r\n"


@pytest.mark.parametrize(
    ("sent", "said"),
    [
        (b"", r"at 500000 bit/s. Is this the node's port or bus, and is the node powered and"),
        (5 * POSITION, r"[45] lines came, no frames: something else speaks there"),
        (line(numbered(1, 0x0A5)[0]), r"but 1 frame of others came. Is this its bus"),
    ],
)
def test_who_else_speaks_on_the_port_is_told(tmp_path, monkeypatch, sent, said):
    monkeypatch.setattr(dialogue, "ROUNDS", 1)
    cable = Cable(tmp_path / "port")
    bus = LiveBus(BusAddress("slcan", str(cable.path), 500_000, NO_WAIT), print)
    try:
        cable.write(sent)
        with pytest.raises(CanBusError, match=said):
            Dialogue(bus).find()
    finally:
        bus.close()
        cable.pull_out()
