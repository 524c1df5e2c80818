"""Opening a bus, or saying in one line why it cannot be."""

from typing import Any

import can

from exoid.files.library_faults import quiet
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from exoid.recordings.live.channel.advise import advice
from exoid.recordings.live.channel.fault import Fault, fault_of
from exoid.recordings.live.channel.port import check_free, hold
from exoid.recordings.live.channel.slcan import SlcanPort


def opened(address: BusAddress) -> can.BusABC:
    """The bus. **Raises** `CanBusError` with what is wrong and what to do."""
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
    except Exception as raised:
        # The backends of python-can have no family of exceptions: a missing driver raises anything.
        known = address.interface in can.VALID_INTERFACES
        fault = fault_of(raised) if known else Fault.UNKNOWN
        raise CanBusError(
            f"{address} cannot be opened: {fault}. {advice(address, fault)}"
        ) from raised


def source_of(address: BusAddress, bus: can.BusABC, patience: float) -> Any:
    """Who gives the frames: the bus, or for slcan a reader of ours on its port."""
    if address.interface != "slcan":
        return bus
    return SlcanPort(bus.serialPortOrig, patience)  # pyright: ignore[reportAttributeAccessIssue]
