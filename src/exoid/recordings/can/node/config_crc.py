"""What node and host must agree on before a number on the bus means the same to both."""

import re
from binascii import crc_hqx

from exoid.recordings.can.dbc import EXOID_DBC, messages_in, stride_in
from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.filter.constants import (
    CURRENT,
    MEASUREMENT_NOISE,
    PROCESS_NOISE,
    START_VARIANCE,
)
from exoid.recordings.filter.learning import LEARNING

# What firmware of before ran, whose measured frames mean the same: the filter by its ConfigCrc.
EARLIER = {0x99CA: "3 states"}
SEED = 0xFFFF  # of CRC-16/CCITT-FALSE
POLYNOMIAL = 0x1021  # which `crc_hqx` divides by
# Not EXO_FINE, which no node with an AS5600 sends: its logs mean the same with and without it.
RECORDED = (
    *("EXO_TIME", "EXO_STATE", "EXO_RAW", "EXO_ACC"),
    *("EXO_SETTINGS", "EXO_HEARTBEAT", "EXO_HEALTH"),
)
LEARNED = (
    "EXO_RATIOS",
    "EXO_RATIO_ERRORS",
    "EXO_FRICTION",
    "EXO_LEARNING",
)  # in the order in which they come
COMMANDED = ("EXO_TORQUE", "EXO_PARAMETER")  # by which no recording is read
VERSION = re.compile(r'^VERSION "(.*)"', re.MULTILINE)


def config_crc() -> int:
    """CRC-16/CCITT-FALSE of what this exoid reads a recording by; the node sends its own."""
    return crc_hqx(meaning(EXOID_DBC.read_text(encoding="utf-8")).encode(), SEED)


def learning_crc() -> int:
    """The same of what the node has learned of a leg, which no measured frame depends on."""
    text = EXOID_DBC.read_text(encoding="utf-8")
    return crc_hqx("\n".join([repr(LEARNING), *layout(text, LEARNED)]).encode(), SEED)


def filter_of(told: int | None) -> str | None:
    """Which of the node's filters a ConfigCrc stands for; None where that is not known."""
    return ({config_crc(): CURRENT} | EARLIER).get(told or 0)


def meaning(text: str) -> str:
    """What the frames of a recording mean by this text of exoid.dbc and by the filter's constants.

    Comments, order and spaces of the file do not count, nor do commands, which no recording needs.
    Where a number comes to mean something else that none of this shows, VERSION is to be raised.
    """
    version = VERSION.search(text)
    constants = (PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE)
    head = f"version {version and version[1]}, a node every {stride_in(text)}, {constants!r}"
    return "\n".join([head, *layout(text, RECORDED)])


def layout(text: str, names: tuple[str, ...]) -> list[str]:
    """Where the signals of these messages lie and what a count of each is."""
    plans = [plan for name, plan in messages_in(text).items() if name in names]
    return [line for plan in sorted(plans, key=identifier) for line in lines_of(plan)]


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
