"""Tables of text: exoid's readers, and the csv module and NumPy beside them."""

import csv
import io
import re
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from exoid.recordings.columns import IN_DEGREES, NUMERIC
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.flat_table import flat
from exoid.recordings.formats.own_table import read_table, write_table
from exoid.recordings.formats.sheets import read_sheet
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.tables.sheet import Sheet

from .draw import text
from .reading import Format, Reading, Rows, Sample

TIME = np.arange(12) * 0.01
ANGLE = -90 + 70 * np.exp(-TIME) * np.cos(5 * TIME)  # deg
MISSING = ("", "nan", "na", "n/a", "null", "none", "-", "--")
DEGREE = np.pi / 180
BEFORE = re.compile(r"\A(?:\s*\n|[ \t]*#(?![^\n]*time_s)[^\n]*\n)+")  # no lines, and comments


def own_samples() -> tuple[Sample, ...]:
    """Exoid's own table, by its writer and by hand."""
    drop = Segment(TIME, raw_angle=np.radians(ANGLE), raw_angular_velocity=np.gradient(ANGLE))  # pyright: ignore[reportArgumentType]
    recording = Recording((drop, drop), Subject(), Protocol(), Sensors())
    rows = [f"{t:.2f},{a:.4f},{'' if n == 3 else n}" for n, (t, a) in enumerate(zip(TIME, ANGLE))]  # noqa: B905
    by_hand = "\n".join(["time_s, raw_angle_deg, what", *rows, ""])
    with TemporaryDirectory() as folder:
        path = Path(folder) / "own.csv"
        write_table(recording, path)
        return Sample(path.read_bytes()), Sample(by_hand.encode())


def read_own(path: Path) -> Reading:
    recording, notes = read_table(path)
    numbers = {k: v for k, v in flat(recording.segments).items() if isinstance(v, np.ndarray)}
    said = (note.removeprefix(f"{path}: ") for note in notes if "does not exist" not in note)
    return Reading(numbers, tuple(said))


def own_by_csv(path: Path, _sample: Sample) -> Rows:
    """The columns that exoid knows, by the csv module."""
    text = path.read_text(encoding="utf-8-sig", errors="replace")
    head, _, body = BEFORE.sub("", text).partition("\n")
    names = next(csv.reader([head], skipinitialspace=True))
    rows = [row for row in csv.reader(io.StringIO(body), strict=True) if row]
    cells = zip(*rows, strict=True)
    found = {
        n.strip(): [*map(number, c)]
        for n, c in zip(names, cells, strict=True)
        if n.strip() in NUMERIC
    }
    arrays = {name: np.array(each) for name, each in found.items()}
    arrays = {
        IN_DEGREES.get(n, n): np.radians(a) if n in IN_DEGREES else a for n, a in arrays.items()
    }
    segment = arrays.pop("segment", np.zeros(len(rows))).astype(int)
    measured = {n: a for n, a in arrays.items() if n != "time_s" and not np.isnan(a).all()}
    order = [name for name in NUMERIC if name in measured]
    return {"time_s": arrays["time_s"], "segment": segment, **{n: measured[n] for n in order}}


def number(cell: str, decimal: str = ".") -> float:
    """**Raises** `ValueError` for what is no number as every program writes one."""
    cell = cell.strip()
    if cell.lower() in MISSING:
        return float("nan")
    if (
        not cell.isascii()
        or "_" in cell
        or (decimal == "," and "." in cell)
        or cell.lower().lstrip("+-")[:1] in ("i", "n")
    ):
        raise ValueError(cell)
    return float(cell.replace(decimal, "."))


DIALECTS = {";,utf-8": (";", ","), "\t.utf-8": ("\t", "."), "|.utf-8": ("|", "."),
            " .utf-8": (" ", "."), ";.cp1252": (";", "."), ",.utf-16": (",", ".")}  # fmt: skip


def dialect_table(told: str, *columns: np.ndarray) -> bytes:
    """Time, angle and gyro as another program writes them: a title, units below the names."""
    separator, decimal = DIALECTS[told]
    rows = [
        separator.join(f"{each:.4f}".replace(".", decimal) for each in row)
        for row in zip(*columns, strict=True)
    ]
    names = separator.join(["Zeit", "Knie-Winkel", "gyro"])
    units = [separator.join(["s", "deg", "deg/s"])] if separator != " " else []
    title = ["Messung von heute", ""] if separator == ";" else []
    return "\n".join([*title, names, *units, *rows, ""]).encode(told[2:])


def dialect_samples() -> tuple[Sample, ...]:
    gyro = np.gradient(ANGLE)
    return tuple(Sample(dialect_table(told, TIME, ANGLE, gyro), told) for told in DIALECTS)


def read_columns_of(path: Path) -> Reading:
    """A sheet; every eighth file is read as a recording, too."""
    sheet = read_sheet(path)
    if sum(path.read_bytes()[-4:]) % 8 == 0:
        read_table(path)
    return Reading(numbers_of(sheet), (*sheet.notes, f"at {sheet.rate} Hz"))


def numbers_of(sheet: Sheet) -> Rows:
    """Columns by their place; what is no number as it is."""
    return {str(at): np.asarray(column.cells) for at, column in enumerate(sheet.columns)}


def by_csv(path: Path, sample: Sample) -> Rows:
    """The lines of numbers in the dialect in which the table was written, or in one that damage
    has made of it: tables of two dialects may have been joined.
    """
    for told in (sample.told, *DIALECTS):
        with suppress(ValueError):
            return in_dialect(path.read_bytes(), told)
    raise ValueError("no dialect")


def in_dialect(content: bytes, told: str) -> Rows:
    separator, decimal = DIALECTS[told]
    text = plain_text(content, told[2:])
    time, angle, gyro = lines_of_numbers(text.split("\n"), separator, decimal)
    fast = np.nanmax(np.abs(gyro), initial=0.0) > 35  # rad/s: without a unit these are degrees
    unit = DEGREE if "deg/s" in text.lower() or fast else 1.0
    return motion(time, angle) | {"raw_velocity_rad_s": gyro * unit}


def plain_text(content: bytes, encoding: str) -> str:
    """As it was written, or else in UTF-8 or Windows' western letters."""
    try:
        text = content.decode(encoding.replace("cp1252", "utf-8"))
    except UnicodeDecodeError:
        text = content.decode("cp1252", errors="replace")
    return text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")


def motion(time: np.ndarray, angle: np.ndarray) -> dict[str, np.ndarray]:
    return {"time_s": time, "segment": np.zeros(time.size, int), "raw_angle_rad": angle * DEGREE}


def lines_of_numbers(lines: list[str], separator: str, decimal: str) -> np.ndarray:
    """**Raises** `ValueError` where a line behind the first of them is another.

    Tabs that do not make lines of one length are blanks among others.
    """
    try:
        return np.array(rows_of(lines, separator, decimal)).T
    except ValueError:
        if separator != "\t":
            raise
        return np.array(rows_of(lines, " ", decimal)).T


def rows_of(lines: list[str], separator: str, decimal: str) -> list[list[float]]:
    rows: list[list[float]] = []
    for line in lines:
        cells = next(csv.reader([line], delimiter=separator), [])
        cells = line.split() if separator == " " else cells
        if not any(cell.strip() for cell in cells):
            if rows:
                break  # another block
            continue
        try:
            rows.append([number(cell, decimal) for cell in cells])
        except ValueError:
            if len(rows) > 1:
                raise
            rows = []  # one line of numbers above words is no sample
    return rows


def table_formats() -> dict[str, Format]:
    return {
        "own csv": Format(".csv", own_samples(), read_own, own_by_csv, drawn=text),
        "other csv": Format(".csv", dialect_samples(), read_own, by_csv, drawn=text),
    }
