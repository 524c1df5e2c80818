"""A CAN bus heard live: its frames one by one, past lines that are none and over unplugged cables.

python-can's `Notifier` is not used: its thread ends at the first malformed line of an adapter,
and nobody is told.
"""

import time
from collections.abc import Callable
from contextlib import suppress
from errno import ENODEV
from typing import Any

import can

from exoid.files.library_faults import quiet
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from exoid.recordings.live.channel.advise import bring_up
from exoid.recordings.live.channel.fault import Fault, loss_of
from exoid.recordings.live.channel.open import opened, source_of

PATIENCE = 0.05  # s without a frame, after which the caller may look at other things
RETRY = 1.0  # s between attempts to open a bus that is gone
ACKNOWLEDGE = "Check that it is plugged in, and that another device on the bus acknowledges."
DATA, FD_DATA = 8, 64  # bytes that a frame can hold
STANDARD, EXTENDED = 0x7FF, 0x1FFFFFFF  # the highest ids

Tell = Callable[[str], Any]


class LiveBus:
    """The frames of a bus. When it is gone, it is tried again every second until it is back.

    `tell` is called with a sentence when the bus goes and when it comes back; without it a bus
    that goes ends what is done with it.

    **Raises** `CanBusError` when the bus cannot be opened at first, or goes and nobody is told.
    """

    def __init__(self, address: BusAddress, tell: Tell | None = None):
        self.address = address
        self.tell = tell
        self.bad = 0  # lines and frames that no CAN controller has sent
        self.gone: float | None = None  # s, monotonic, since when
        self.next_try = 0.0
        self.bus: can.BusABC | None = opened(address)
        self.source = source_of(address, self.bus, PATIENCE)

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
        except (can.CanError, OSError) as raised:
            self.lose(loss_of(raised))
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
                raise OSError(ENODEV, "gone")
            self.bus.send(message)
        except (can.CanError, OSError) as raised:
            fault = loss_of(raised)
            todo = bring_up(self.address) if fault == Fault.DOWN else ACKNOWLEDGE
            raise CanBusError(f"{self.address} takes no frame: {fault}. {todo}") from raised

    def lose(self, fault: Fault | str) -> None:
        """The bus is gone: say so once, and let go of it."""
        self.close()
        if self.gone is not None:
            return
        self.gone = time.monotonic()
        todo = bring_up(self.address) if fault == Fault.DOWN else "Plug it in again."
        if self.tell is None:
            raise CanBusError(f"{self.address} is gone: {fault}. {todo} Then repeat the command.")
        self.tell(
            f"{self.address} is gone: {fault}. What was recorded is kept. {todo} It is tried every "
            "second until Ctrl-C."
        )

    def try_again(self) -> None:
        """Open the bus if it is time to, else wait for a moment."""
        if time.monotonic() < self.next_try:
            time.sleep(PATIENCE)
            return
        try:
            self.bus = opened(self.address)
            self.source = source_of(self.address, self.bus, PATIENCE)
        except CanBusError:
            self.next_try = time.monotonic() + RETRY

    def welcome(self) -> None:
        """A frame came: if the bus had been gone, it is back."""
        if self.gone is not None and self.tell is not None:
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


def is_whole(message: can.Message) -> bool:
    """Can a CAN controller have sent this? Some adapters hand on what is left of a frame."""
    if message.is_error_frame:
        return True
    longest = FD_DATA if message.is_fd else DATA
    highest = EXTENDED if message.is_extended_id else STANDARD
    length = 0 if message.is_remote_frame else message.dlc
    fits = 0 <= message.arbitration_id <= highest and message.dlc <= longest
    return fits and len(message.data) == length
