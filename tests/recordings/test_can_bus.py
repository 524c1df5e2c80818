"""A live bus is heard frame by frame, whatever its lines and its cable do."""

import select
import time

import can
import pytest

from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from live_node import NO_WAIT, Cable, line, numbered

LIMIT = 20.0  # s, after which something that should come is not coming
FOREIGN = 0x200


@pytest.fixture
def said():
    return []


@pytest.fixture
def cable(tmp_path):
    made = Cable(tmp_path / "port")
    yield made
    made.pull_out()


@pytest.fixture
def bus(cable, said):
    made = LiveBus(BusAddress("slcan", str(cable.path), 500_000, NO_WAIT), said.append)
    yield made
    made.close()


def hear(bus, wanted: int) -> list[can.Message]:
    """So many frames of a bus; fewer where they do not come."""
    found = []
    end = time.monotonic() + LIMIT
    while len(found) < wanted and time.monotonic() < end:
        message = bus.receive()
        found += [] if message is None else [message]
    return found


MALFORMED = [
    b"t1018112233\r",  # cut: three of eight bytes
    b"t101900112233445566778899\r",  # nine bytes
    b"t10180011223344556677889\r",  # runs on
    b"tXYZ80011223344556677\r",
    b"t10\r",
    b"t\r",
    b"t99980011223344556677\r",  # an id of 12 bits
    b"tFFFFFFFFF\r",
    b"\xff\xfe\r",
    b"018001122\r",  # its head was lost
    b"T1FFFFFF\r",
    b"TFFFFFFFF0\r",  # an id of 32 bits
    b"r10\a",
    b"?" * 100 + b"\r",
]


@pytest.mark.parametrize("bad", MALFORMED)
def test_a_malformed_line_is_counted_and_the_frames_around_it_are_heard(cable, bus, bad):
    before, after = numbered(2)
    cable.write(line(before) + bad + line(after))
    heard = hear(bus, 2)
    assert [m.data for m in heard] == [before.data, after.data]
    assert bus.bad >= 1


def test_every_cut_of_a_line_is_survived(cable, bus):
    whole = line(numbered(1)[0])
    cable.write(whole + b"".join(whole[:cut] + b"\r" for cut in range(1, len(whole) - 1)) + whole)
    assert len(hear(bus, 2)) == 2
    # A cut of the data is seen by the length; only the whole line, with or without its end, is not.
    assert bus.bad == len(whole) - 2


def test_answers_of_the_adapter_and_a_line_begun_before_we_listened_are_no_faults(cable, bus):
    frames = numbered(2)
    cable.write(b"344556677\r\r\r\az\rV1013\r" + line(frames[0]) + b"Z\rF00\r" + line(frames[1]))
    assert len(hear(bus, 2)) == 2
    assert bus.bad == 0


def test_remote_and_extended_frames_and_device_time_are_understood(cable, bus):
    cable.write(b"T1ABCDEF02a1B2\r" + b"r7FF4\r" + b"t1002A1B2C3D4\r")
    extended, remote, stamped = hear(bus, 3)
    assert (extended.arbitration_id, extended.is_extended_id) == (0x1ABCDEF0, True)
    assert (remote.arbitration_id, remote.is_remote_frame, remote.dlc) == (0x7FF, True, 4)
    assert stamped.data == b"\xa1\xb2"


def test_a_frame_that_no_controller_can_send_is_not_handed_on(said):
    sender = can.Bus(interface="virtual", channel="odd")
    bus = LiveBus(BusAddress("virtual", "odd", 500_000), said.append)
    odd = can.Message(arbitration_id=0x101, is_extended_id=False, dlc=8, data=b"abc")
    for message in (odd, *numbered(1)):
        sender.send(message)
    assert [m.arbitration_id for m in hear(bus, 1)] == [FOREIGN]
    assert bus.bad == 1
    bus.close()
    sender.shutdown()


def test_a_pulled_cable_is_named_and_the_bus_found_again(cable, bus, said):
    cable.send(*numbered(1))
    assert len(hear(bus, 1)) == 1
    port = bus.bus.serialPortOrig
    cable.pull_out()
    while bus.gone is None:
        bus.receive()
    assert not port.is_open  # else the device would come back under another name
    assert said[0].startswith(f"slcan {cable.path} is gone: it was unplugged, or has no power. ")
    assert "tried every second until Ctrl-C" in said[0]
    cable.plug_in()
    while bus.bus is None:
        bus.receive()
    cable.send(*numbered(1))
    assert len(hear(bus, 1)) == 1
    assert "is back after" in said[1]
    assert len(said) == 2


@pytest.mark.parametrize(
    ("interface", "bitrate", "hint"),
    [
        ("slcan", 500_000, "it is not there. Is it plugged in, .* Serial ports here"),
        ("slcan", 123_456, "it is not there. Is it plugged in"),
        ("slkan", 500_000, "there is no such interface. The interface can be .*slcan"),
        ("pcan", 500_000, "its driver is missing here. Check the channel, the bit rate"),
        ("kvaser", 500_000, "its driver knows no such channel.*Check the channel"),
    ],
)
def test_a_bus_that_cannot_be_opened_is_refused_with_a_hint(
    tmp_path, said, interface, bitrate, hint
):
    address = BusAddress(interface, str(tmp_path / "none"), bitrate, NO_WAIT)
    with pytest.raises(CanBusError, match=f"(?s){interface} .*none cannot be opened: .*{hint}"):
        LiveBus(address, said.append)


def test_a_bit_rate_that_the_adapter_lacks_is_refused(cable, said):
    with pytest.raises(CanBusError, match=r"no such channel, bit rate.*knows 10000, 20000"):
        LiveBus(BusAddress("slcan", str(cable.path), 123_456, NO_WAIT), said.append)


def test_a_burst_of_many_times_what_the_port_holds_is_heard_in_full(cable, bus):
    sent = numbered(5000)
    thread = cable.stream(sent, 1e9)
    assert [m.data for m in hear(bus, 5000)] == [m.data for m in sent]
    thread.join()
    assert bus.bad == 0


def test_a_port_has_one_reader_and_the_second_writes_nothing_to_it(cable, bus):
    cable.heard_out()
    with pytest.raises(CanBusError, match=r"another program reads it\. Close that.*kill NUMBER"):
        LiveBus(bus.address, print)
    cable.send(*numbered(3))
    assert len(hear(bus, 3)) == 3
    assert not select.select([cable.end], [], [], 0)[0]


def test_a_port_that_was_let_go_is_free(cable, bus):
    bus.close()
    LiveBus(bus.address, print).close()
