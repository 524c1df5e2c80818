"""C3D, the file of motion capture: model angles among its points, sensors among analog channels.

Columns are LABEL.X, LABEL.Y, LABEL.Z of every point and LABEL of every analog channel. They come at
the rate of the points, or at that of the analog channels where the angle is one of these.
"""

import math
import os
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays, read_apart
from exoid.recordings.formats.c3d_header import BLOCK, differences, header_of
from exoid.recordings.tables.names import recognised
from exoid.recordings.tables.sheet import Column, Place, Sheet, listed, printable

AXES = "XYZ"
FRONT = 256 * BLOCK  # bytes, within which the parameters begin
LABELS = ("LABELS", "LABELS2", "LABELS3", "LABELS4")


def read_c3d(path: Path, wanted: Collection[str] = ()) -> Sheet:
    """Points and analog channels; `wanted` are the columns that a map names.

    **Raises** `ValueError` that says what is in the file where nothing tells which is the angle.
    """
    content = read_apart(channels, path, "Export it again.", library="ezc3d")
    points, analogs = point_columns(content), analog_columns(content)
    if not points and not analogs:
        raise ValueError("holds neither points nor analog channels.")
    point_rate, analog_rate = content["rates"].tolist()
    fast = fastest(points, analogs, wanted)
    columns, rate = (analogs, analog_rate or point_rate) if fast else (points, point_rate)
    if not fast and analogs:
        columns = points + thinned(analogs, len(points[0].cells))
    sheet = Sheet(tuple(columns), Place("frame"), rate=rate or None, notes=notes_of(content))
    if not wanted and not recognised(sheet.columns, "angle"):
        raise ValueError(told(points, analogs))
    return sheet


def channels(path: Path) -> Arrays:
    """What the file holds, as arrays; in a process of its own."""
    import ezc3d

    content = ezc3d.c3d(str(path))
    point, analog = (content["parameters"].get(group, {}) for group in ("POINT", "ANALOG"))
    points = np.asarray(content["data"]["points"][:3], np.float64)
    return {
        "points": points,
        "analogs": np.asarray(content["data"]["analogs"][0], np.float64),
        "rates": np.array([first(point, "RATE", 0.0), first(analog, "RATE", 0.0)], np.float64),
        "point_labels": np.array([each for name in LABELS for each in held(point, name)], str),
        "analog_labels": np.array([each for name in LABELS for each in held(analog, name)], str),
        "angles": np.array(held(point, "ANGLES"), str),
        "point_units": np.array([first(point, "UNITS", ""), first(point, "ANGLE_UNITS", "deg")]),
        "analog_units": np.array(held(analog, "UNITS"), str),
        "differences": np.array(differences_in(path, point, analog, points.shape[2]), str),
    }


def differences_in(
    path: Path, point: Mapping[str, Any], analog: Mapping[str, Any], frames: int
) -> list[str]:
    """What the file says of itself in two ways."""
    per_frame = first(analog, "RATE", 0.0) / (first(point, "RATE", 0.0) or math.nan)
    used = first(analog, "USED", 0)
    told = {
        "points": first(point, "USED", 0),
        "analogs": used * per_frame if used else 0,
        "start": first(point, "DATA_START", math.nan),
        "rate": first(point, "RATE", math.nan),
        "scale": first(point, "SCALE", math.nan),
        "frames": first(point, "FRAMES", math.nan),
    }
    with path.open("rb") as file:
        header, size = header_of(file.read(FRONT)), os.fstat(file.fileno()).st_size
    return [*differences(header, told, frames, size)]


def notes_of(content: Arrays) -> tuple[str, ...]:
    said = content["differences"].tolist()
    return tuple(f"{each} Is the file damaged? Export it again." for each in said[:1])


def held(group: Mapping[str, Any], name: str) -> list[Any]:
    """A parameter's values."""
    return [*group.get(name, {}).get("value", [])]


def first(group: Mapping[str, Any], name: str, default: Any) -> Any:
    return next(iter(held(group, name)), default)


def labelled(labels: np.ndarray, count: int, kind: str) -> list[str]:
    """A name for each channel; those without one are numbered."""
    names = [printable(each) for each in labels.tolist()[:count]]
    names += [""] * (count - len(names))
    return [name or f"{kind} {number}" for number, name in enumerate(names, 1)]


def point_columns(content: Arrays) -> list[Column]:
    """The three numbers of every point; in degrees those that are a model's angles."""
    points = content["points"]
    angles = {printable(each) for each in content["angles"].tolist()}
    length, turn = map(str, content["point_units"].tolist())
    return [
        Column(
            f"{name}.{axis}",
            points[at, number],
            turn if name in angles or "angle" in name.lower() else length,
        )
        for number, name in enumerate(labelled(content["point_labels"], points.shape[1], "point"))
        for at, axis in enumerate(AXES)
    ]


def analog_columns(content: Arrays) -> list[Column]:
    analogs, units = content["analogs"], [printable(each) for each in content["analog_units"]]
    names = labelled(content["analog_labels"], analogs.shape[0], "analog")
    units += [""] * (len(names) - len(units))
    return [Column(*each) for each in zip(names, analogs, units, strict=False)]


def fastest(points: list[Column], analogs: list[Column], wanted: Collection[str]) -> bool:
    """Is the angle an analog channel?"""
    if not points:
        return True
    if wanted:
        return {*wanted} <= {column.name for column in analogs}
    return not recognised(tuple(points), "angle") and bool(recognised(tuple(analogs), "angle"))


def thinned(analogs: list[Column], frames: int) -> list[Column]:
    """Of several analog samples in a frame, the first, which is taken with the picture."""
    per_frame = max(1, len(analogs[0].cells) // max(frames, 1))
    kept = [np.asarray(column.cells)[::per_frame][:frames] for column in analogs]
    return [
        Column(column.name, cells, column.unit)
        for column, cells in zip(analogs, kept, strict=True)
        if cells.size == frames
    ]


def told(points: list[Column], analogs: list[Column]) -> str:
    """What the file holds, where nobody says which of it is the angle."""
    held = [column.name.removesuffix(".X") for column in points if column.name.endswith(".X")]
    return (
        f"has no knee angle by its name. Its points are {listed(held) or 'none'}, its analog "
        f"channels {listed([each.name for each in analogs]) or 'none'}. Name one: "
        'columns={"raw_angle_deg": "LABEL.X"} for a point, or "LABEL" for an analog channel.'
    )
