"""A CAN bus heard live: its frames one by one, past lines that are none and over unplugged cables.

python-can's `Notifier` is not used: its thread ends at the first malformed line of an adapter,
and nobody is told.
"""

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import can

from exoid.files.library_faults import plain, quiet
from exoid.recordings.live.port import HELD, check_free, hold
from exoid.recordings.live.slcan import SlcanPort

PATIENCE = 0.05  # s without a frame, after which the caller may look at other things
RETRY = 1.0  # s between attempts to open a bus that is gone
SERIAL = ("slcan", "serial")  # interfaces whose channel is a serial port
DATA, FD_DATA = 8, 64  # bytes that a frame can hold
STANDARD, EXTENDED = 0x7FF, 0x1FFFFFFF  # the highest ids

Tell = Callable[[str], Any]


class CanBusError(ValueError):
    """A bus that cannot be opened, in one line: what is wrong, where, and what to do."""


@dataclass(frozen=True)
class BusAddress:
    """Which bus: python-can's interface and channel, the bit rate [bit/s], further options."""

    interface: str
    channel: str
    bitrate: int
    options: Mapping[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.interface} {self.channel}"


class LiveBus:
    """The frames of a bus. When it is gone, it is tried again every second until it is back.

    `tell` is called with a sentence when the bus goes and when it comes back.

    **Raises** `CanBusError` when the bus cannot be opened at first.
    """

    def __init__(self, address: BusAddress, tell: Tell):
        self.address = address
        self.tell = tell
        self.bad = 0  # lines and frames that no CAN controller has sent
        self.gone: float | None = None  # s, monotonic, since when
        self.next_try = 0.0
        self.bus: can.BusABC | None = opened(address)
        self.source = source_of(address, self.bus)

    def receive(self) -> can.Message | None:
        """The next frame that is one; None where none came for a moment."""
        if self.bus is None:
            self.try_again()
            return None
        try:
            message = self.source.recv(PATIENCE)
        except (ValueError, IndexError):  # of those who take a line apart
            self.bad += 1
            return None
        except (can.CanError, OSError) as fault:
            self.lose(plain(str(fault.__cause__ or fault)))
            return None
        if message is None:
            return None
        self.welcome()
        if is_whole(message):
            return message
        self.bad += 1
        return None

    def send(self, message: can.Message) -> None:
        """Put a frame on the bus. **Raises** `CanBusError` where it does not take it."""
        try:
            if self.bus is None:
                raise can.CanOperationError("it is not there")
            self.bus.send(message)
        except (can.CanError, OSError) as fault:
            reason = plain(str(fault.__cause__ or fault))
            raise CanBusError(
                f"{self.address} takes no frame: {reason}. Check that it is plugged in, and that "
                "another device on the bus acknowledges."
            ) from fault

    def lose(self, reason: str) -> None:
        """The bus is gone: say so once, and let go of it."""
        self.close()
        if self.gone is None:
            self.gone = time.monotonic()
            self.tell(
                f"{self.address} is gone ({reason}). What was recorded is kept. Plug it in again: "
                "it is tried every second until Ctrl-C."
            )

    def try_again(self) -> None:
        """Open the bus if it is time to, else wait for a moment."""
        if time.monotonic() < self.next_try:
            time.sleep(PATIENCE)
            return
        try:
            self.bus = opened(self.address)
            self.source = source_of(self.address, self.bus)
        except CanBusError:
            self.next_try = time.monotonic() + RETRY

    def welcome(self) -> None:
        """A frame came: if the bus had been gone, it is back."""
        if self.gone is not None:
            self.tell(f"{self.address} is back after {time.monotonic() - self.gone:.0f} s.")
            self.gone = None

    def close(self) -> None:
        """Let go of the bus, however ill it is."""
        bus, self.bus = self.bus, None
        self.next_try = time.monotonic() + RETRY
        if bus is None:
            return
        with quiet("can"), suppress(can.CanError, OSError):
            bus.shutdown()
        # slcan leaves its port open where it cannot say goodbye; a device that is plugged in again
        # while its old port is held gets another name.
        port = getattr(bus, "serialPortOrig", None)
        if port is not None:
            with suppress(OSError):
                port.close()


def source_of(address: BusAddress, bus: can.BusABC) -> Any:
    """Who gives the frames: the bus, or for slcan a reader of ours on its port."""
    if address.interface != "slcan":
        return bus
    return SlcanPort(bus.serialPortOrig, PATIENCE)  # pyright: ignore[reportAttributeAccessIssue]


def opened(address: BusAddress) -> can.BusABC:
    slcan = address.interface == "slcan"
    try:
        if slcan:
            check_free(address.channel)
        with quiet("can"):
            bus = can.Bus(
                interface=address.interface,
                channel=address.channel,
                bitrate=address.bitrate,
                **address.options,
            )
        if slcan:
            hold(bus.serialPortOrig)  # pyright: ignore[reportAttributeAccessIssue]
        return bus
    except Exception as fault:
        # The backends of python-can have no family of exceptions: a missing driver raises anything.
        reason = plain(str(fault)) or type(fault).__name__
        raise CanBusError(
            f"{address} cannot be opened: {reason}. {advice(address, reason)}"
        ) from fault


def advice(address: BusAddress, reason: str) -> str:
    """What to do about a bus that cannot be opened."""
    if address.interface not in can.VALID_INTERFACES:
        return f"The interface can be {', '.join(sorted(can.VALID_INTERFACES))}."
    if reason == HELD:
        return (
            "Close that one. A recording whose terminal was closed goes on: pgrep -af 'exoid "
            "record' shows its number, and kill NUMBER ends it with all that it recorded."
        )
    if "Permission denied" in reason:
        return "Give yourself access to it: on Linux join its group, dialout, and log in again."
    if address.interface not in SERIAL or "bitrate" in reason:
        return "Check the channel, the bit rate, and that the adapter and its driver are there."
    from serial.tools.list_ports import comports

    ports = ", ".join(sorted(port.device for port in comports()))
    return f"Is it plugged in? Serial ports here: {ports or 'none'}."


def is_whole(message: can.Message) -> bool:
    """Can a CAN controller have sent this? Some adapters hand on what is left of a frame."""
    if message.is_error_frame:
        return True
    longest = FD_DATA if message.is_fd else DATA
    highest = EXTENDED if message.is_extended_id else STANDARD
    length = 0 if message.is_remote_frame else message.dlc
    fits = 0 <= message.arbitration_id <= highest and message.dlc <= longest
    return fits and len(message.data) == length
