"""Where the decode plans come from: the project's own exoid.dbc, or a DBC of the user's.

exoid.dbc is read by 20 lines here, because cantools takes longer to import than a whole log takes
to read; the tests hold the two against each other. Every other DBC is read by cantools.
"""

import re
from functools import cache
from pathlib import Path

from exoid.files.library_faults import plain, quiet
from exoid.recordings.can.dbc_lines import fault_of
from exoid.recordings.can.decode import WORD, MessagePlan, SignalPlan

EXOID_DBC = Path(__file__).with_name("exoid.dbc")
LONGEST_CYCLE = 1e9  # ms
FLOAT_LENGTHS = (16, 32, 64)

GAP = r"[ \t]*"
MESSAGE = re.compile(
    rf"^{GAP}BO_ +(\d+) +(\w+){GAP}:{GAP}(\d+) +\w+{GAP}$((?:\n{GAP}SG_ .*)*)", re.MULTILINE
)
SIGNAL = re.compile(
    rf"SG_ +(\w+){GAP}:{GAP}(\d+)\|(\d+)@1([+-]){GAP}\(([^,]+),([^)]+)\){GAP}"
    rf'\[[^]]*\]{GAP}"([^"]*)"'
)
STRIDE = re.compile(rf'^{GAP}BA_ +"NodeStride" +(\d+){GAP};', re.MULTILINE)
FLOAT = re.compile(rf"^{GAP}SIG_VALTYPE_ +(\d+) +(\w+){GAP}:{GAP}1{GAP};", re.MULTILINE)
PERIOD = re.compile(rf'^{GAP}BA_ +"GenMsgCycleTime" +BO_ +(\d+) +(\d+){GAP};', re.MULTILINE)


class DbcError(ValueError):
    """A DBC file that cannot be read or used, in one line: what, where, what to do."""


@cache
def exoid_messages() -> dict[str, MessagePlan]:
    """The messages of the node with the id 0, and those to any node, by name from exoid.dbc."""
    return messages_in(EXOID_DBC.read_text(encoding="utf-8"))


@cache
def node_stride() -> int:
    """How far the identifiers of a node lie above those of the node before it."""
    return stride_in(EXOID_DBC.read_text(encoding="utf-8"))


def stride_in(text: str) -> int:
    """The `NodeStride` of the text of a DBC; 0 where it has none."""
    found = STRIDE.search(text)
    return 0 if found is None else int(found[1])


def messages_in(text: str) -> dict[str, MessagePlan]:
    """The messages of a DBC's text that is laid out as exoid.dbc is, by name."""
    periods = {int(identifier): int(ms) / 1000 for identifier, ms in PERIOD.findall(text)}
    floats = FLOAT.findall(text)
    return {
        name: MessagePlan(
            name=name,
            identifier=int(identifier),
            extended=False,
            length=int(length),
            period=periods.get(int(identifier)),
            signals=tuple(
                little_endian_signal(*found, floating=(identifier, found[0]) in floats)
                for found in SIGNAL.findall(signals)
            ),
        )
        for identifier, name, length, signals in MESSAGE.findall(text)
    }


def little_endian_signal(
    name, start, length, sign, scale, offset, unit, *, floating: bool
) -> SignalPlan:
    return SignalPlan(
        name=name,
        start=int(start),
        length=int(length),
        big_endian=False,
        signed=sign == "-",
        floating=floating,
        scale=float(scale),
        offset=float(offset),
        unit=unit,
    )


def read_dbc(path: Path) -> list:
    """The messages of a DBC file, as cantools has them.

    **Raises** `DbcError` when cantools cannot read the file, or reads a damaged line of it.
    """
    fault = fault_of(path.read_bytes())
    if fault is not None:
        raise DbcError(f"{path} {fault}")
    from cantools.database.can import Database

    try:
        # `strict` would refuse a whole DBC for one signal that does not fit: plan_message looks
        # at the signals that are used.
        database = Database(strict=False)
        with quiet("cantools"):
            database.add_dbc_file(path)
    except OSError:
        raise
    except Exception as fault:
        # cantools has no family of exceptions for a bad file.
        raise DbcError(
            f"{path} is not a DBC file that cantools can read: {plain(str(fault))}"
        ) from fault
    return list(database.messages)


def plan_message(message, names: tuple[str, ...] | None = None) -> MessagePlan:
    """The decode plan of a cantools message, for the named signals (all, when None).

    **Raises** `DbcError` for a multiplexed signal, and for one that leaves the 8 bytes of a frame.
    """
    return MessagePlan(
        name=message.name,
        identifier=message.frame_id,
        extended=message.is_extended_frame,
        length=message.length,
        period=period_of(message),
        signals=tuple(
            plan_signal(message.name, signal)
            for signal in message.signals
            if names is None or signal.name in names
        ),
    )


def period_of(message) -> float | None:
    """How often a message is sent [s], where its DBC says so."""
    cycle = message.cycle_time
    if cycle is not None and not (isinstance(cycle, int | float) and 0 <= cycle < LONGEST_CYCLE):
        raise DbcError(f"{message.name} has the cycle time {cycle!r:.20}; it must be in ms.")
    return cycle / 1000 if cycle else None


def plan_signal(message: str, signal) -> SignalPlan:
    where = f"{message}.{signal.name}"
    if signal.multiplexer_ids:
        raise DbcError(f"{where} is multiplexed, which is not supported. Send it in its own frame.")
    if signal.is_float and signal.length not in FLOAT_LENGTHS:
        raise DbcError(f"{where} is a float of {signal.length} bits; it can be 16, 32 or 64.")
    if not signal.conversion.scale:
        raise DbcError(f"{where} has the factor 0, which leaves nothing of it.")
    big_endian = signal.byte_order == "big_endian"
    # A DBC names a big-endian signal by its most significant bit and numbers the bits of each byte
    # from the least significant one.
    start = signal.start + 7 - 2 * (signal.start % 8) if big_endian else signal.start
    if start + signal.length > WORD:
        raise DbcError(f"{where} lies beyond 8 bytes. CAN FD is not supported.")
    return SignalPlan(
        name=signal.name,
        start=start,
        length=signal.length,
        big_endian=big_endian,
        signed=signal.is_signed,
        floating=signal.is_float,
        scale=as_float(where, signal.conversion.scale),
        offset=as_float(where, signal.conversion.offset),
        unit=signal.unit or "",
    )


def as_float(where: str, number: int | float) -> float:
    """A factor or an offset; a DBC may write one of any length."""
    try:
        return float(number)
    except OverflowError as fault:
        raise DbcError(f"{where} has a factor or an offset that no number can hold.") from fault
