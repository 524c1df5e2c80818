"""The commands of exoid.dbc, as frames that a node takes."""

from binascii import crc_hqx

import can

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.node.config_crc import SEED
from exoid.recordings.can.node.one_frame import encoded

TELL = "EXO_TELL"
SET_ZERO = "EXO_SET_ZERO"
SET_DIRECTION = "EXO_SET_DIRECTION"
SET_NODE_ID = "EXO_SET_NODE_ID"
SET_BIT_RATE = "EXO_SET_BIT_RATE"
IDENTIFY = "EXO_IDENTIFY"
LOAD = "EXO_LOAD"
ALLOW = "EXO_ALLOW"
COMMANDS = (TELL, SET_ZERO, SET_DIRECTION, SET_NODE_ID, SET_BIT_RATE, IDENTIFY, LOAD, ALLOW)
EVERYBODY = 0  # the serial by which TELL is for every node


def command(name: str, serial: int, **values: float | int) -> can.Message:
    """The frame of a command to the node of that serial, its signals in their units.

    **Raises** `ValueError` for a value that the signal cannot hold.
    """
    plan = exoid_messages()[name]
    check = plan.signal("Check").start // 8
    data = encoded(plan, {"Serial": serial, **values})
    sealed = data[:check] + bytes([crc_hqx(data[:check], SEED) & 0xFF]) + data[check + 1 :]
    return can.Message(arbitration_id=plan.identifier, is_extended_id=False, data=sealed)
