"""Files that hypothesis draws: fields and lines of a text are changed, or frames of a log made up.

Bytes seldom make another number, name or line of what stands there; a strategy makes nothing else.
hypothesis draws from bytes that are given to it, so that a recipe stays one.
"""

import random
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import can
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.recordings.exo_node import EPOCH

from .mutate import WORDS
from .reading import Sample

LENGTH = 1 << 13  # bytes, more than a strategy needs
MOST = 4  # changes of one file
FIELD = re.compile(r"([^\s,;|#=\"()\[\]:@]+)")  # what separators part, of all formats of text
DIGITS = st.integers(-(10**6), 10**6)

Strategy = st.SearchStrategy[bytes]

numbers = st.one_of(
    st.builds("{}".format, DIGITS),
    st.builds(lambda digits, places: f"{digits / 10**places:.{places}f}", DIGITS,
              st.integers(1, 9)),
    st.builds("{}e{}".format, DIGITS, st.integers(-330, 330)),
    st.builds("{:X}".format, st.integers(0, 2**32)),
    st.builds(lambda sign, word: sign + word, st.sampled_from(["", "+", "-"]),
              st.sampled_from(["inf", "nan", "Infinity", "NA", "null", "1_0", "0x10", ".5", "5."])),
)  # fmt: skip
words = st.sampled_from([each.decode("latin1") for each in WORDS])


def text(sample: Sample) -> Strategy:
    """Changes of a text; `told` of a table in a dialect ends with its encoding."""
    return changed(sample.content, sample.told[2:] or "utf-8")


def log(_sample: Sample) -> Strategy:
    return logged()


@st.composite
def changed(draw, content: bytes, encoding: str) -> bytes:
    """A text with some of its fields, lines or columns changed."""
    lines = content.decode(encoding).split("\n")
    for _ in range(draw(st.integers(1, MOST))):
        draw(st.sampled_from(CHANGES))(draw, lines)
    end = draw(st.sampled_from(["\n", "\n", "\n", "\r\n"]))
    return end.join(lines).encode(encoding, errors="replace")


def field(draw, lines: list[str]) -> None:
    """Another number, word, or field of the file in the place of one."""
    at = draw(st.integers(0, len(lines) - 1))
    parts = FIELD.split(lines[at])
    if len(parts) > 1:
        others = FIELD.findall(lines[draw(st.integers(0, len(lines) - 1))]) or [""]
        which = 2 * draw(st.integers(0, len(parts) // 2 - 1)) + 1
        parts[which] = draw(st.one_of(numbers, numbers, st.sampled_from(others), words))
        lines[at] = "".join(parts)


def every(draw, lines: list[str]) -> None:
    """The same place of every line that has it: a column in another notation, or another one."""
    place = draw(st.integers(0, 12))
    write = draw(st.sampled_from(NOTATIONS))
    for at, line in enumerate(lines):
        parts = FIELD.split(line)
        if 2 * place + 1 < len(parts):
            parts[2 * place + 1] = write(parts[2 * place + 1])
            lines[at] = "".join(parts)


def exponential(cell: str) -> str:
    try:
        return f"{float(cell):.12e}"
    except ValueError:
        return cell


NOTATIONS: tuple[Callable[[str], str], ...] = (
    exponential,
    lambda cell: f'"{cell}"',
    lambda cell: f" {cell} ",
    lambda cell: cell.replace(".", ","),
    lambda cell: f"-{cell}",
    lambda cell: f"+{cell}",
    lambda cell: f"0{cell}",
    str.lower,
    str.upper,
    lambda cell: "",
)


def line(draw, lines: list[str]) -> None:
    """Twice, gone, at another place, empty, or a comment."""
    at, to = (draw(st.integers(0, len(lines) - 1)) for _ in range(2))
    kind = draw(st.integers(0, 4))
    if kind == 0:
        lines.insert(to, lines[at])
    elif kind == 1 and len(lines) > 1:
        del lines[at]
    elif kind == 2:
        lines[at], lines[to] = lines[to], lines[at]
    else:
        lines.insert(at, "" if kind == 3 else f"# {lines[to]}")


def shorter(draw, lines: list[str]) -> None:
    """A line with a field fewer, or one more."""
    at = draw(st.integers(0, len(lines) - 1))
    parts = FIELD.split(lines[at])
    if len(parts) > 3:
        which = 2 * draw(st.integers(0, len(parts) // 2 - 1))
        pair = parts[which : which + 2]
        parts[which : which + 2] = [] if draw(st.booleans()) else pair * 2
        lines[at] = "".join(parts)


CHANGES = (field, field, field, every, line, shorter)

times = st.integers(0, 10**6).map(lambda us: EPOCH + us / 1e6)


@st.composite
def message(draw) -> can.Message:
    """A frame of any kind."""
    kind = draw(st.sampled_from(["data", "data", "data", "remote", "error", "fd"]))
    extended = draw(st.booleans())
    data = draw(st.binary(max_size=8)) if kind in ("data", "fd") else b""
    return can.Message(
        timestamp=draw(times),
        arbitration_id=draw(st.integers(0, 2**29 - 1 if extended else 2**11 - 1)),
        is_extended_id=extended,
        is_remote_frame=kind == "remote",
        is_error_frame=kind == "error",
        is_fd=kind == "fd",
        bitrate_switch=kind == "fd" and draw(st.booleans()),
        dlc=draw(st.integers(0, 8)) if kind == "remote" else len(data),
        data=data,
    )


@st.composite
def logged(draw) -> bytes:
    """A BLF of frames of all kinds, in any order of time, as python-can writes it."""
    found = draw(st.lists(message(), min_size=1, max_size=12))
    with TemporaryDirectory() as folder:
        path = Path(folder) / "log.blf"
        with can.BLFWriter(path) as writer:
            for each in found:
                writer.on_message_received(each)
        return path.read_bytes()


def drawn(strategy: Strategy, chance: random.Random) -> bytes | None:
    """What hypothesis draws from bytes of `chance`; None where these are none it can use."""
    found, draw_from = drawer(strategy)
    found.clear()
    draw_from(chance.randbytes(LENGTH))
    return found[0] if found else None


@cache
def drawer(strategy: Strategy) -> tuple[list[bytes], Callable[[bytes], object]]:
    """Where a strategy leaves what it draws, and what makes it draw."""
    found: list[bytes] = []

    @settings(database=None, deadline=None)
    @given(strategy)
    def keep(content: bytes) -> None:
        found.append(content)

    return found, keep.hypothesis.fuzz_one_input  # pyright: ignore[reportFunctionMemberAccess]
