"""What node and host must agree on before a number on the bus means the same to both."""

from binascii import crc_hqx

from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.filter.constants import (
    CURRENT,
    MEASUREMENT_NOISE,
    PROCESS_NOISE,
    START_VARIANCE,
)

# What firmware of before ran, whose frames mean the same: the filter by its ConfigCrc.
EARLIER = {0x99CA: "3 states"}
SEED = 0xFFFF  # of CRC-16/CCITT-FALSE


def config_crc() -> int:
    """CRC-16/CCITT-FALSE of exoid.dbc and of the filter's constants; the node sends its own.

    The DBC counts as text: a checkout that turned its line ends has the same CRC.
    """
    layout = EXOID_DBC.read_text(encoding="utf-8")
    constants = (PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE)
    return crc_hqx(f"{layout}{constants!r}".encode(), SEED)


def filter_of(told: int | None) -> str | None:
    """Which of the node's filters a ConfigCrc stands for; None where that is not known."""
    return ({config_crc(): CURRENT} | EARLIER).get(told or 0)
