"""What node and host must agree on before a number on the bus means the same to both."""

import re
from binascii import crc_hqx

from exoid.recordings.can.dbc import EXOID_DBC, messages_in, stride_in
from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.filter.constants import MEASUREMENT_NOISE, PROCESS_NOISE, START_VARIANCE

SEED = 0xFFFF  # of CRC-16/CCITT-FALSE
POLYNOMIAL = 0x1021  # which `crc_hqx` divides by
RECORDED = ("EXO_TIME", "EXO_STATE", "EXO_RAW", "EXO_ACC", "EXO_SETTINGS", "EXO_HEARTBEAT")
VERSION = re.compile(r'^VERSION "(.*)"', re.MULTILINE)

# CRCs of nodes that took them of the text of their exoid.dbc: the meaning that each stands for.
OF_TEXT = {0x99CA: 0xC281}


def config_crc() -> int:
    """CRC-16/CCITT-FALSE of what this exoid reads a recording by; the node sends its own."""
    return crc_hqx(meaning(EXOID_DBC.read_text(encoding="utf-8")).encode(), SEED)


def meaning_of(told: int) -> int:
    """The CRC of the same meaning as the one that a node told."""
    return OF_TEXT.get(told, told)


def meaning(text: str) -> str:
    """What the frames of a recording mean by this text of exoid.dbc and by the filter's constants.

    Comments, order and spaces of the file do not count, nor do commands, which no recording needs.
    Where a number comes to mean something else that none of this shows, VERSION is to be raised.
    """
    version = VERSION.search(text)
    plans = [plan for name, plan in messages_in(text).items() if name in RECORDED]
    constants = (PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE)
    return "\n".join(
        [
            f"version {version and version[1]}, a node every {stride_in(text)}, {constants!r}",
            *(line for plan in sorted(plans, key=identifier) for line in lines_of(plan)),
        ]
    )


def identifier(plan: MessagePlan) -> int:
    return plan.identifier


def lines_of(plan: MessagePlan) -> list[str]:
    """A message and its signals from the first bit on, a line each."""
    head = f"{plan.name} {plan.identifier} {plan.extended} {plan.length} {plan.period!r}"
    return [
        head,
        *(
            f"{each.name} {each.start} {each.length} {each.big_endian} {each.signed} "
            f"{each.floating} {each.scale!r} {each.offset!r} {each.unit}"
            for each in sorted(plan.signals, key=lambda signal: signal.start)
        ),
    ]
