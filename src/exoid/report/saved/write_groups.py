"""A node as groups of a netCDF file.

A record is a group. Its words are attributes, written as in JSON; a number is an attribute, or a
variable where it has a unit; an array is a variable; what is within is a group below. Lists and
mappings of records that are alike are tables. The attribute `in` says of a group what is no record:
a list of so many, a mapping with these names, or a table and its index.
"""

from collections.abc import Mapping
from typing import Any
from urllib.parse import quote

import numpy as np

from exoid.report.saved.node import Entries, Record, Values, holds, text
from exoid.report.saved.rows import to_columns

IN = "in"  # no name of a field
LONGEST = 30_000  # bytes of an attribute; HDF5 takes 64 kB
LARGEST = 2**63  # of an integer
LEGIBLE = " ()[]{}+-=,:;@!#$&'*<>|~^"
INDICES = ("row", "name", "key", "entry", "item")
RESERVED = (IN, "CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST")  # by HDF5, but for the first
MOST_ABSENT = 4000  # rows that an attribute can list


def write_group(group: Any, node: Mapping[str, Any], above: Mapping[str, int]) -> None:
    """Put a record, or what stands under names, into a group; `above` are axes of outer groups."""
    sizes = dict(above)
    if isinstance(node, Entries):
        group.attrs[IN] = text(list(node))
    below = {}
    for key, each in node.items():
        name = legible(key)
        if isinstance(each, Values) and each.array.size:
            write_array(group, name, each, axes_of(each, node, sizes))
        elif isinstance(each, dict | list) and holds(each, (Record, Values)):
            below[name] = each
        else:
            write_plain(group, name, each)
    for name, each in below.items():
        inner = group.create_group(name)
        if isinstance(each, Record) or not write_table(inner, each, sizes):
            write_each(inner, each, sizes)


def write_each(group: Any, node: Any, above: Mapping[str, int]) -> None:
    """What is no table: a group for each."""
    if isinstance(node, list):
        group.attrs[IN] = np.int64(len(node))
        node = Record({str(number): each for number, each in enumerate(node)})
    write_group(group, node, above)


def write_table(group: Any, node: Any, above: Mapping[str, int]) -> bool:
    """A row for each, where they are alike."""
    listed = isinstance(node, list)
    columns = to_columns(node if listed else list(node.values()))
    if columns is None:
        return False
    taken = {*above, *columns}
    index = next(each for each in INDICES[not listed :] if each not in taken)
    group.attrs[IN] = text({"index": index, "listed": listed})
    group.dimensions[index] = len(node)
    for name, cells in (columns if listed else {index: list(node), **columns}).items():
        values, about = column(cells)
        write_variable(group, name, (index,), values, about)
    return True


def column(cells: list[Any]) -> tuple[np.ndarray, dict[str, Any]]:
    """Cells as one array, and what it needs to know to give them back."""
    units = [each.unit for each in cells if isinstance(each, Values) and each.unit]
    about: dict[str, Any] = {"units": units[0]} if units else {}
    absent = [row for row, cell in enumerate(cells) if cell is None]
    if absent:
        about["none"] = np.array(absent)
    plain = [each.array.item() if isinstance(each, Values) else each for each in cells]
    types = {type(each) for each in plain if each is not None}
    if len(absent) > MOST_ABSENT:
        types.add(None.__class__)
    if types <= {float}:
        return np.array([np.nan if each is None else each for each in plain]), about
    if types == {bool}:
        return np.array([bool(each) for each in plain]), about
    if types == {int} and all(each is None or abs(each) < LARGEST for each in plain):
        return np.array([0 if each is None else each for each in plain]), about
    if types == {str} and all(each is None or storable(each) for each in plain):
        return np.array(["" if each is None else each for each in plain], dtype=object), about
    return np.array([text(each) for each in plain], dtype=object), {**about, IN: "JSON"}


def write_plain(group: Any, name: str, node: Any) -> None:
    """A number as it is, and anything else as JSON."""
    small = isinstance(node, int) and not isinstance(node, bool) and abs(node) < LARGEST
    if isinstance(node, float) or small:
        group.attrs[name] = np.asarray(node)[()]
        return
    said = text(node)
    if len(said.encode()) < LONGEST:
        group.attrs[name] = said
    else:
        write_variable(group, name, (), np.array(said, dtype=object), {})


def write_array(group: Any, name: str, node: Values, axes: tuple[str, ...]) -> None:
    for axis, size in zip(axes, node.array.shape, strict=True):
        if axis not in group.dimensions or group.dimensions[axis].size != size:
            group.dimensions[axis] = size
    units = {} if node.unit is None else {"units": node.unit}
    write_variable(group, name, axes, node.array, units)


def write_variable(group: Any, name: str, axes: Any, values: np.ndarray, about: dict) -> None:
    """A truth is 0 or 1 of kind bool, as xarray has it."""
    import h5py

    if values.dtype == bool:
        values, about = values.astype("i1"), {**about, "dtype": "bool"}
    kind = h5py.string_dtype() if values.dtype == object else values.dtype
    made = group.create_variable(name, axes, dtype=kind, data=values)
    for key, each in about.items():
        made.attrs[key] = each


def axes_of(node: Values, record: Mapping[str, Any], sizes: dict[str, int]) -> Any:
    """Names for the axes of an array, each with one size here and above."""
    found: list[str] = []
    known = node.axes if len(node.axes) == node.array.ndim else ()
    for number, size in enumerate(node.array.shape):
        axis = known[number] if known and known[number].isidentifier() else "axis"
        axis = f"other_{axis}" if axis in found else axis
        while (
            axis in found
            or sizes.get(axis, size) != size
            or (axis in record and not runs_along(record[axis], axis, size))
        ):
            axis = f"{axis}_{size}"
        sizes[axis] = size
        found.append(axis)
    return tuple(found)


def runs_along(node: Any, axis: str, size: int) -> bool:
    """Is it what the points of an axis are at?"""
    return isinstance(node, Values) and node.axes == (axis,) and node.array.shape == (size,)


def storable(word: str) -> bool:
    """Can HDF5 keep it as it is?"""
    return "\0" not in word and word.encode("utf-8", "ignore").decode() == word


def legible(key: str) -> str:
    """A name that HDF5 takes."""
    if key in RESERVED or key[:1] in ("_", "."):
        return f"%{ord(key[0]):02X}{legible(key[1:])}"
    return quote(key, LEGIBLE, errors="surrogatepass") or "%"
