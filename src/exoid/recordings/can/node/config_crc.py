"""What node and host must agree on before a number on the bus means the same to both."""

import re
from binascii import crc_hqx

from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.filter.constants import MEASUREMENT_NOISE, PROCESS_NOISE, START_VARIANCE

SEED = 0xFFFF  # of CRC-16/CCITT-FALSE
# EXO_FINE, which no node with an AS5600 sends: its logs mean the same with and without it.
OF_SOME_NODES = re.compile(
    r'^(BO_ 263 .*\n( SG_ .*\n)*\n|CM_ (BO_|SG_) 263 .*\n|BA_ "\w+" BO_ 263 .*\n)', re.MULTILINE
)


def config_crc() -> int:
    """CRC-16/CCITT-FALSE of exoid.dbc and of the filter's constants; the node sends its own.

    The DBC counts as text: a checkout that turned its line ends has the same CRC.
    """
    layout = OF_SOME_NODES.sub("", EXOID_DBC.read_text(encoding="utf-8"))
    constants = (PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE)
    return crc_hqx(f"{layout}{constants!r}".encode(), SEED)
