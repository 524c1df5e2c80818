"""OpenSim's storages: exoid's reader, and the csv module beside it."""

import re
from contextlib import suppress
from pathlib import Path

from .draw import text
from .reading import Format, Rows, Sample, Unread
from .tables import ANGLE, TIME, lines_of_numbers, motion, read_own

WORDS_BETWEEN = re.compile(r"(?m)^[-\d.e]+\t(?![-\d.e]+\t)[^\t\n]*\t[-\d.e]+$")


def below_header(path: Path, _sample: Sample) -> Rows:
    """The lines of numbers below the first `endheader`, or the last: damage may have put a header
    into another.
    """
    content = path.read_text(encoding="utf-8-sig")
    for most in (1, 0):
        body = re.split(r"(?im)^\s*endheader\s*$", content, maxsplit=most)[-1]
        with suppress(ValueError):
            time, _, angle = lines_of_numbers(body.split("\n"), "\t", ".")
            return motion(time, angle)
    if WORDS_BETWEEN.search(content):
        raise Unread("words in a column that is not read")
    raise ValueError("no lines of numbers")


def opensim_samples() -> tuple[Sample, ...]:
    rows = [f"{t:.8f}\t0.5\t{a:.8f}" for t, a in zip(TIME, ANGLE, strict=True)]
    head = ["Coordinates", "version=1", f"nRows={TIME.size}", "nColumns=3", "inDegrees=yes", "",
            "Units are S.I. units", "endheader", "time\tpelvis_tx\tknee_angle_r"]  # fmt: skip
    return (Sample("\n".join([*head, *rows, ""]).encode()),)


def opensim_formats() -> dict[str, Format]:
    return {"opensim": Format(".mot", opensim_samples(), read_own, below_header, drawn=text)}
