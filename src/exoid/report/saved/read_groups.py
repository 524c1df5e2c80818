"""A node back from the groups of a netCDF file."""

import json
from typing import Any
from urllib.parse import unquote

import numpy as np

from exoid.report.saved.rows import from_columns
from exoid.report.saved.write_groups import IN


def read_group(group: Any) -> Any:
    """The node that was written into a group."""
    said = group.attrs.get(IN)
    told = json.loads(said) if isinstance(said, str) else said
    if isinstance(told, dict):
        return read_table(group, **told)
    found: dict[str, Any] = {
        spoken(name): plain(each) for name, each in group.attrs.items() if name != IN
    }
    found |= {spoken(name): read_variable(each) for name, each in group.variables.items()}
    found |= {spoken(name): read_group(each) for name, each in group.groups.items()}
    if told is None:
        return found
    if isinstance(told, list):
        return {name: found[name] for name in told}
    return [found[str(number)] for number in range(int(told))]


def read_table(group: Any, index: str, listed: bool) -> Any:
    """The rows of a table, under their names where it has some."""
    columns = {name: cells(each) for name, each in group.variables.items()}
    count = group.dimensions[index].size
    names = columns.pop(index, [])
    rows = from_columns(columns, count)
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
    values = variable[...]
    if variable.dtype.kind == "O" or isinstance(values, str):
        return json.loads(str(values)) if not variable.dimensions else np.asarray(values)
    values = np.asarray(values)
    return values.astype(bool) if variable.attrs.get("dtype") == "bool" else values


def plain(kept: Any) -> Any:
    """An attribute, as `write_plain` was given it."""
    return json.loads(kept) if isinstance(kept, str) else kept.item()


def spoken(name: str) -> str:
    """What `legible` was given."""
    return unquote(name.removesuffix("%"), errors="surrogatepass")
