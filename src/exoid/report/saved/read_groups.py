"""A node back from the groups of a netCDF file."""

import json
from typing import Any
from urllib.parse import unquote

import numpy as np

from exoid.report.saved.rows import from_columns
from exoid.report.saved.write_groups import IN, RESERVED


def read_group(group: Any) -> Any:
    """The node that was written into a group of an HDF5 file, which every netCDF file is."""
    told = plain(group.attrs[IN]) if IN in group.attrs else None
    if isinstance(told, dict):
        return read_table(group, **told)
    found: dict[str, Any] = {
        spoken(name): plain(each) for name, each in group.attrs.items() if not hidden(name)
    }
    for name, each in group.items():
        if not hasattr(each, "shape"):
            found[spoken(name)] = read_group(each)
        elif not is_axis(each):
            found[spoken(name)] = read_variable(each)
    if told is None:
        return found
    if isinstance(told, list):
        return {name: found[name] for name in told}
    return [found[str(number)] for number in range(told)]


def read_table(group: Any, index: str, listed: bool) -> Any:
    """The rows of a table, under their names where it has some."""
    columns = {name: cells(each) for name, each in group.items() if not is_axis(each)}
    names = columns.pop(index, [])
    rows = from_columns(columns, group[index].size)
    return rows if listed else dict(zip(names, rows, strict=True))


def cells(variable: Any) -> list[Any]:
    """What `column` was given."""
    found = read_variable(variable).tolist()
    if variable.attrs.get(IN) == "JSON":
        return [json.loads(each) for each in found]
    for row in np.atleast_1d(variable.attrs.get("none", np.zeros(0, int))).tolist():
        found[row] = None
    return found


def read_variable(variable: Any) -> Any:
    """An array, or the text that was too long for an attribute."""
    if variable.dtype.kind == "O":
        words = variable.asstr()[()]
        return words if variable.shape else json.loads(words)
    values = np.asarray(variable[()])
    return values.astype(bool) if variable.attrs.get("dtype") == "bool" else values


def is_axis(variable: Any) -> bool:
    """Is it nothing but the size of an axis?"""
    return variable.attrs.get("NAME", b"").startswith(b"This is a netCDF dimension but not")


def hidden(name: str) -> bool:
    """Is an attribute the library's own?"""
    return name in RESERVED or name.startswith("_")


def plain(kept: Any) -> Any:
    """An attribute, as `write_plain` was given it."""
    return json.loads(kept) if isinstance(kept, str) else np.asarray(kept).item()


def spoken(name: str) -> str:
    """What `legible` was given."""
    return unquote(name.removesuffix("%"), errors="surrogatepass")
