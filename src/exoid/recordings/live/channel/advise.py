"""What to do about a bus that cannot be opened."""

import sys
from pathlib import Path

import can

from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.live.channel.fault import Fault

SERIAL = ("slcan", "serial")  # interfaces whose channel is a serial port
USUAL_GROUP = "dialout"  # of serial ports, where the port does not tell
CLOSE = "Close that one."
STILL_RECORDING = (
    "A recording whose terminal was closed goes on: pgrep -af 'exoid record' shows its number, and "
    "kill NUMBER ends it with all that it recorded."
)
CHECK = "Check the channel, the bit rate, and that the adapter and its driver are there."


def advice(address: BusAddress, fault: Fault | str) -> str:
    """In a sentence or two."""
    if fault == Fault.UNKNOWN:
        return f"The interface can be {', '.join(sorted(can.VALID_INTERFACES))}."
    if fault == Fault.HELD:
        return CLOSE if sys.platform == "win32" else f"{CLOSE} {STILL_RECORDING}"
    if fault == Fault.FORBIDDEN and address.interface in SERIAL:
        return (
            f"Give yourself access: on Linux sudo usermod -aG {group_of(address.channel)} $USER, "
            "then log out and in again."
        )
    if address.interface == "slcan" and fault == Fault.UNFIT:
        from can.interfaces.slcan import slcanBus

        rates = ", ".join(map(str, sorted(slcanBus._BITRATES)))
        return f"slcan knows {rates} bit/s. A channel is such as /dev/ttyACM0 or COM3."
    if address.interface in SERIAL:
        return f"Is it plugged in, and the right one? Serial ports here: {serial_ports()}."
    if fault == Fault.DOWN:
        return bring_up(address)
    if fault == Fault.ABSENT and address.interface == "socketcan":
        return "Is it plugged in? 'ip link' shows the CAN interfaces here."
    return CHECK


def bring_up(address: BusAddress) -> str:
    """Of an interface of Linux."""
    return f"Bring it up: sudo ip link set {address.channel} up type can bitrate {address.bitrate}."


def serial_ports() -> str:
    from serial.tools.list_ports import comports

    return ", ".join(sorted(port.device for port in comports())) or "none"


def group_of(channel: str) -> str:
    """Whose members may use a port."""
    try:
        found = Path(channel.partition("@")[0]).group()
    except (OSError, KeyError, NotImplementedError):
        return USUAL_GROUP
    return USUAL_GROUP if found == "root" else found
