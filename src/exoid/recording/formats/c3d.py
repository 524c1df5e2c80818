"""C3D, the file of motion capture: model angles among its points, sensors among analog channels.

Columns are LABEL.X, LABEL.Y, LABEL.Z of every point and LABEL of every analog channel. They come at
the rate of the points, or at that of the analog channels where the angle is one of these.
"""

from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from exoid.recording.tables.names import recognised
from exoid.recording.tables.sheet import Column, Place, Sheet, listed, printable

AXES = "XYZ"


def read_c3d(path: Path, wanted: Collection[str] = ()) -> Sheet:
    """Points and analog channels; `wanted` are the columns that a map names."""
    import ezc3d

    content = ezc3d.c3d(str(path))
    parameters = content["parameters"]
    points = point_columns(parameters, content["data"]["points"])
    analogs = analog_columns(parameters, content["data"]["analogs"])
    if not points and not analogs:
        raise ValueError("holds neither points nor analog channels.")
    point_rate = float(value(parameters, "POINT", "RATE", 0.0))
    analog_rate = float(value(parameters, "ANALOG", "RATE", 0.0)) or point_rate
    fast = fastest(points, analogs, wanted)
    columns, rate = (analogs, analog_rate) if fast else (points, point_rate)
    if not fast and points and analogs:
        columns = points + thinned(analogs, len(points[0].cells))
    sheet = Sheet(tuple(columns), Place("frame"), rate=rate or None)
    check_angle(sheet, wanted, points, analogs)
    return sheet


def value(parameters: Mapping[str, Any], group: str, name: str, default: Any) -> Any:
    """A parameter's first value."""
    held = parameters.get(group, {}).get(name, {}).get("value", [])
    return held[0] if len(held) else default


def labels(parameters: Mapping[str, Any], group: str, count: int) -> list[str]:
    """The names in LABELS, LABELS2, ..., one for each channel."""
    found: list[str] = []
    for name in ("LABELS", "LABELS2", "LABELS3", "LABELS4"):
        found += parameters.get(group, {}).get(name, {}).get("value", [])
    named = [printable(each) or f"{group.lower()} {number}" for number, each in enumerate(found)]
    return (named + [f"{group.lower()} {number}" for number in range(len(named), count)])[:count]


def point_columns(parameters: Mapping[str, Any], points: np.ndarray) -> list[Column]:
    """The three numbers of every point; in degrees those that are a model's angles."""
    names = labels(parameters, "POINT", points.shape[1])
    angles = {*map(printable, parameters.get("POINT", {}).get("ANGLES", {}).get("value", []))}
    length = str(value(parameters, "POINT", "UNITS", ""))
    turn = str(value(parameters, "POINT", "ANGLE_UNITS", "deg"))
    return [
        Column(
            f"{name}.{axis}",
            np.asarray(points[at, number], np.float64),
            turn if name in angles or "angle" in name.lower() else length,
        )
        for number, name in enumerate(names)
        for at, axis in enumerate(AXES)
    ]


def analog_columns(parameters: Mapping[str, Any], analogs: np.ndarray) -> list[Column]:
    units = parameters.get("ANALOG", {}).get("UNITS", {}).get("value", [])
    return [
        Column(
            name,
            np.asarray(analogs[0, number], np.float64),
            printable(units[number]) if number < len(units) else "",
        )
        for number, name in enumerate(labels(parameters, "ANALOG", analogs.shape[1]))
    ]


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


def check_angle(
    sheet: Sheet, wanted: Collection[str], points: list[Column], analogs: list[Column]
) -> None:
    """Say what the file holds where nobody says which of it is the angle."""
    if wanted or recognised(sheet.columns, "angle"):
        return
    held = [column.name.removesuffix(".X") for column in points if column.name.endswith(".X")]
    raise ValueError(
        f"has no knee angle by its name. Its points are {listed(held) or 'none'}, "
        f"its analog channels {listed([each.name for each in analogs]) or 'none'}. Name one with "
        '--column raw_angle_deg="LABEL.X" for a point, or ="LABEL" for an analog channel.'
    )
