"""What is wrong with a bus is said in words of ours, whatever python-can and pyserial call it."""

import errno
import os

import can
import pytest
from serial import SerialException

from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from exoid.recordings.live.channel.fault import Fault, fault_of, loss_of
from live_node import NO_WAIT

LIBRARIES = ("Errno", "could not", "Could not", "failed", "ioctl", "Error Code", "device reports")


def refused(channel: str) -> str:
    with pytest.raises(CanBusError) as raised:
        LiveBus(BusAddress("slcan", channel, 500_000, NO_WAIT))
    return str(raised.value)


@pytest.fixture
def port(tmp_path, monkeypatch):
    """A file that the operating system refuses to open with a number."""
    path = tmp_path / "port"
    path.touch()
    usual = os.open

    def fails(number: int) -> str:
        def opening(name, *options, **more):
            if name == str(path):
                raise OSError(number, os.strerror(number), name)
            return usual(name, *options, **more)

        monkeypatch.setattr(os, "open", opening)
        return str(path)

    return fails


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (errno.EACCES, "this user may not use it. Give yourself access: on Linux sudo usermod -aG"),
        (errno.EPERM, "this user may not use it. Give yourself access"),
        (errno.ENOENT, "it is not there. Is it plugged in, and the right one? Serial ports here"),
        (errno.ENODEV, "it is not there. Is it plugged in"),
        (errno.EBUSY, "another program reads it. Close that one."),
        (errno.EIO, "it was unplugged, or has no power. Is it plugged in"),
    ],
)
def test_what_the_system_refuses_is_said_with_what_to_do(port, number, said):
    line = refused(port(number))
    assert said in line
    assert not [each for each in LIBRARIES if each in line]


@pytest.mark.parametrize("channel", [os.devnull, os.sep])
def test_what_is_no_serial_port_is_called_so(channel):
    line = refused(channel)
    assert f"slcan {channel} cannot be opened: it is no serial port. Is it plugged in, and" in line
    assert not [each for each in LIBRARIES if each in line]


def by_number(kind: type[Exception], number: int) -> Exception:
    """As python-can raises it: its own words, with the system's error behind them."""
    try:
        try:
            raise OSError(number, os.strerror(number))
        except OSError as fault:
            raise kind(f"Error receiving: {fault.strerror}") from fault
    except kind as raised:
        return raised


@pytest.mark.parametrize(
    ("raised", "meant"),
    [
        (SerialException("device reports readiness to read but returned no data"), "UNPLUGGED"),
        (by_number(SerialException, errno.EIO), "UNPLUGGED"),
        (by_number(can.CanOperationError, errno.ENODEV), "UNPLUGGED"),
        (by_number(can.CanOperationError, errno.ENXIO), "UNPLUGGED"),
        (by_number(can.CanOperationError, errno.ENETDOWN), "DOWN"),
        (by_number(can.CanOperationError, errno.ENOBUFS), "FULL"),
        (can.CanOperationError("Transmit buffer full"), "FULL"),
    ],
)
def test_a_bus_that_goes_is_told_by_what_became_of_it(raised, meant):
    assert loss_of(raised) is Fault[meant]


def test_what_windows_says_is_understood():
    quoted = "could not open port 'COM9': FileNotFoundError(2, 'cannot find', None, 2)"
    assert fault_of(SerialException(quoted)) is Fault.ABSENT


def test_words_that_only_a_driver_knows_are_shown_as_its_own():
    assert fault_of(can.CanError("heavy\nbus")) == 'its driver says "heavy bus"'


def test_a_socket_that_is_switched_off_is_told_with_the_command_that_brings_it_up(monkeypatch):
    said = []
    bus = LiveBus(BusAddress("virtual", "can7", 250_000), said.append)

    def down(_):
        raise by_number(can.CanOperationError, errno.ENETDOWN)

    monkeypatch.setattr(bus.source, "recv", down)
    assert bus.receive() is None
    assert said == [
        "virtual can7 is gone: it is switched off. What was recorded is kept. Bring it up: sudo ip "
        "link set can7 up type can bitrate 250000. It is tried every second until Ctrl-C."
    ]


def test_a_bus_that_goes_while_a_node_is_asked_ends_it_in_one_line(monkeypatch):
    bus = LiveBus(BusAddress("virtual", "asked", 250_000))

    def gone(_):
        raise SerialException("read failed: [Errno 5] Input/output error")

    monkeypatch.setattr(bus.source, "recv", gone)
    with pytest.raises(CanBusError, match=r"asked is gone: it was unplugged.*repeat the command"):
        bus.receive()
