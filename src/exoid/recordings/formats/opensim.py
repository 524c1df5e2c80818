"""OpenSim's motions (.mot) and storages (.sto): a header, `endheader`, then columns and rows.

Rotations are in degrees where the header says inDegrees=yes; times are in seconds. What is an angle
there no unit tells: a coordinate named after a knee is taken for one.
"""

import re
from dataclasses import replace
from pathlib import Path

from exoid.files.text_file import read_text
from exoid.recordings.tables.dialect import BLANK, Dialect, rows_in
from exoid.recordings.tables.layout import sheet_of_rows
from exoid.recordings.tables.names import recognised
from exoid.recordings.tables.sheet import Place, Sheet

END = re.compile(r"^\s*endheader\s*$", re.IGNORECASE | re.MULTILINE)
IN_DEGREES = re.compile(r"^\s*inDegrees\s*=\s*(\w+)", re.IGNORECASE | re.MULTILINE)
ROWS = re.compile(r"^\s*nRows\s*=\s*(\d{1,12})\s*$", re.IGNORECASE | re.MULTILINE)
DIALECTS = {True: Dialect("\t", "."), False: Dialect(BLANK, ".")}


def read_opensim(path: Path) -> Sheet:
    """The columns of a motion or storage file.

    **Raises** `ValueError` where there is no header, or nothing below it.
    """
    text = read_text(path)
    end = END.search(text)
    if end is None:
        raise ValueError("has no line endheader, as OpenSim's files have. Export it again.")
    head, body = text[: end.end()], text[end.end() :].removeprefix("\n")
    line = head.count("\n") + 2  # the first below endheader
    rows = rows_in(body.rstrip("\n").split("\n"), DIALECTS["\t" in body])
    sheet = sheet_of_rows(rows, Place("line", line))
    announced, found = ROWS.search(head), len(sheet.columns[0].cells)
    if announced is not None and announced[1] != str(found):
        note = f"its header announces {announced[1]} rows, and it holds {found}."
        sheet = replace(sheet, notes=(*sheet.notes, note))
    told = IN_DEGREES.search(head)
    if told is None:
        return sheet
    unit = "deg" if told[1].lower() in ("yes", "true", "1") else "rad"
    columns = (replace(c, unit=unit) if recognised((c,), "angle") else c for c in sheet.columns)
    return replace(sheet, columns=tuple(columns))
