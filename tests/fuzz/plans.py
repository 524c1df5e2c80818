"""DBC files as canmatrix reads them, and sidecars as tomlkit does."""

import re
from contextlib import redirect_stdout
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from io import StringIO
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

from exoid.recordings.can.decode import WORD, MessagePlan, SignalPlan

from .reading import Rows, Sample, Unread

TWO_IN_A_LINE = re.compile(rb"^[ \t]*SG_[^\n]*[ \t]SG_[ \t]", re.MULTILINE)
DEFINED = re.compile(rb'^BA_DEF_ +BO_ +"GenMsgCycleTime" .*^BA_DEF_DEF_', re.MULTILINE | re.DOTALL)
TYPE_ABOVE = re.compile(rb"^SIG_VALTYPE_ .*^BO_ ", re.MULTILINE | re.DOTALL)
NO_FLOAT = re.compile(rb"^SIG_VALTYPE_ [^\n]*:(?!\s*[12]\s*;)", re.MULTILINE)


def plans_by_canmatrix(path: Path, _sample: Sample) -> Rows:
    """The decode plan of every message that can have one."""
    import canmatrix.formats.dbc

    content = path.read_bytes()
    if TWO_IN_A_LINE.search(content):
        raise Unread("canmatrix reads one signal of a line")
    if b"BA_DEF_DEF_" in content and not DEFINED.search(content):
        raise Unread("canmatrix has no default of what is not defined above it")
    if TYPE_ABOVE.search(content):
        raise Unread("canmatrix knows nothing of a message that stands below its SIG_VALTYPE_")
    if NO_FLOAT.search(content):
        raise Unread("canmatrix takes any SIG_VALTYPE_ for that of a float")
    with path.open("rb") as file, redirect_stdout(StringIO()) as said:
        matrix = canmatrix.formats.dbc.load(file, dbcImportEncoding="cp1252")
    if said.getvalue():
        raise Unread(said.getvalue())
    if len({repr(frame.arbitration_id) for frame in matrix.frames}) < len(matrix.frames):
        raise Unread("two messages of one identifier: canmatrix has one period for both")
    frames = [plan_of(frame, matrix) for frame in matrix.frames]
    return rows_of([each for each in frames if each is not None])


def rows_of(plans: list[MessagePlan]) -> Rows:
    """Messages and signals by their names: which of two comes first says nothing."""
    said = [repr(replace(each, signals=tuple(sorted(each.signals, key=repr)))) for each in plans]
    return {"plans": np.array(sorted(said), str)}


def plan_of(frame: Any, matrix: Any) -> MessagePlan | None:
    """None for a frame with a signal that is multiplexed or beyond 8 bytes."""
    signals = [signal_of(each) for each in frame.signals]
    if None in signals:
        return None
    identifier = frame.arbitration_id
    period = frame.cycle_time or int(float(frame.attribute("GenMsgCycleTime", matrix) or 0))
    return MessagePlan(
        name=frame.name,
        identifier=identifier.id,
        extended=bool(identifier.extended),
        length=frame.size,
        period=period / 1000 if period else None,
        signals=tuple(each for each in signals if each is not None),
    )


def signal_of(signal: Any) -> SignalPlan | None:
    big = not signal.is_little_endian
    start = signal.get_startbit(bit_numbering=1)
    start = start + 7 - 2 * (start % 8) if big else start
    floating = bool(signal.is_float)
    if (
        signal.mux_val is not None
        or start + signal.size > WORD
        or (floating and signal.size not in (16, 32, 64))
    ):
        return None
    return SignalPlan(
        name=signal.name,
        start=start,
        length=signal.size,
        big_endian=big,
        signed=bool(signal.is_signed),
        floating=floating,
        scale=float(signal.factor),
        offset=float(signal.offset) + 0.0,
        unit=(signal.unit or "").replace("\r", "\n"),
    )


def said_by_tomlkit(path: Path, _sample: Sample) -> Rows:
    """What the sidecar says, from another parser of TOML."""
    import tomlkit

    from .beside import read_beside

    def loads(text: str) -> dict[str, Any]:
        return plain(tomlkit.parse(text).unwrap())

    with patch("exoid.recordings.sidecar.tomllib.loads", loads):
        return read_beside(path).rows


def plain(value: Any) -> Any:
    """With offsets from UTC as Python's own parser has them."""
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, list):
        return [plain(each) for each in value]
    if isinstance(value, datetime) and value.tzinfo is not None:
        return value.replace(tzinfo=timezone(value.utcoffset() or timedelta()))
    return value
