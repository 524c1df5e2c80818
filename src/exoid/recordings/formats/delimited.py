"""Text tables as spreadsheets, labs and motion capture write them, in whatever dialect."""

import csv
from dataclasses import replace
from pathlib import Path

from exoid.files.text_file import content_of, plain_lines, read_text
from exoid.recordings.tables.dialect import rows_of
from exoid.recordings.tables.layout import are_units, sheet_of_rows
from exoid.recordings.tables.names import called
from exoid.recordings.tables.sheet import Place, Sheet

LABVIEW, LABVIEW_TIME = "LabVIEW Measurement", "X_Value"  # first line; its name of the time [s]
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
ANGLES = {"angle_rad", "raw_angle_rad", "angle_deg", "raw_angle_deg"}
RATES = {"velocity_rad_s", "raw_velocity_rad_s", "velocity_deg_s", "raw_velocity_deg_s"}


def read_delimited(path: Path) -> Sheet:
    """The table in a text file, by its own dialect."""
    return sheet_of_text(legible(path))


def sheet_of_text(text: str) -> Sheet:
    if not text.strip():
        raise ValueError("the file is empty. Copy it again.")
    sheet = sheet_of_rows(rows_of(text), Place("line", 1))
    return replace(sheet, time=LABVIEW_TIME) if text.startswith(LABVIEW) else sheet


def legible(path: Path) -> str:
    """The text of a table: UTF-8, UTF-16 as Excel writes it, or else Windows' western letters.

    **Raises** `ValueError` for what is no text, and for a table of exoid's own that is not UTF-8.
    """
    content = content_of(path)
    if content[:2] in UTF_16 and not is_own(content[:4096].decode("latin-1")):
        try:
            return plain_lines(content.decode("utf-16"))
        except UnicodeDecodeError as error:
            raise ValueError("is damaged UTF-16 text. Export it as CSV in UTF-8.") from error
    try:
        return read_text(path)
    except ValueError as error:
        western = isinstance(error.__cause__, UnicodeDecodeError) and b"\0" not in content
        if not western or is_own(content[:4096].decode("latin-1")):
            raise
    return plain_lines(content.decode("cp1252", errors="replace"))


def is_own(text: str) -> bool:
    """Is this written as exoid's own table is: its time and angle, commas, no row of units, and no
    gyro under another name?
    """
    try:
        names, below = [
            [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True), [])]
            for line in (*text.split("\n", 2)[:2], "")[:2]
        ]
    except csv.Error:
        return False
    own = "time_s" in names and bool(ANGLES & {*names}) and not are_units(below)
    return own and (bool(RATES & {*names}) or not any(called(name, "gyro") for name in names))
