"""Frozen dataclasses as groups of a netCDF file, field by field, and back.

A number is a variable with its unit, an array one over the dimensions that its type names, a word
an attribute, anything else that JSON can hold an attribute with its JSON. A dataclass within is a
group below; a list of plain ones is a table of one row each. None is left out; in a table it is NaN
or an empty text.
"""

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from exoid.report.saved.estimate_arrays import Groups, Table
from exoid.report.saved.field_kinds import Kind, kinds


def to_groups(one: Any, path: str, *, without: Sequence[str] = ()) -> dict[str, Table]:
    """A dataclass as the group `path` and those below it; fields that are named stay out."""
    import xarray

    numbers, words, below = {}, {}, {}
    for name, each in kinds(type(one)).items():
        value, place = getattr(one, name), f"{path}/{name}"
        if value is None or name in without:
            continue
        if each.role in ("number", "array"):
            dims = each.type.dim_str.split() if each.role == "array" else ()
            numbers[name] = (dims, np.asarray(value), each.units)
        elif each.role == "group":
            below |= to_groups(value, place)
        elif each.role == "rows":
            below[place] = to_rows(value, each.type[1])
        elif each.role == "groups":
            for number, item in enumerate(value):
                below |= to_groups(item, f"{place}/{number}")
        else:
            words[name] = value if each.role == "word" else text(value)
    return {path: xarray.Dataset(numbers, attrs=words), **below}


def from_groups(of: Any, groups: Groups, path: str, **given: Any) -> Any:
    """What `to_groups` was given; fields that were left out are `given`."""
    own = groups[path]
    found = dict(given)
    for name, each in kinds(of).items():
        place = f"{path}/{name}"
        if name in given:
            continue
        if each.optional and not (name in own or name in own.attrs or place in groups):
            found[name] = None
        elif each.role in ("number", "array"):
            found[name] = value_of(own[name].values, each)
        elif each.role == "group":
            found[name] = from_groups(each.type, groups, place)
        elif each.role == "rows":
            found[name] = each.type[0](from_rows(each.type[1], groups[place]))
        elif each.role == "groups":
            found[name] = each.type[0](items(each.type[1], groups, place))
        else:
            found[name] = value_of(own.attrs[name], each)
    return of(**found)


def items(of: Any, groups: Groups, path: str) -> list[Any]:
    """The groups 0, 1, 2, ... below a group."""
    found = []
    while f"{path}/{len(found)}" in groups:
        found.append(from_groups(of, groups, f"{path}/{len(found)}"))
    return found


def to_rows(each: Sequence[Any], of: Any) -> Table:
    """A table of one row for each; what is within a field is named FIELD.FIELD."""
    import xarray

    columns = {}
    for name, one in leaves(of).items():
        values = [inner(row, name) for row in each]
        if one.role == "number":
            known = [np.nan if value is None else value for value in values]
            column = np.array(known, dtype=float if one.optional else one.type)
        elif one.role == "word":
            column = np.array(["" if value is None else value for value in values], dtype=object)
        else:
            column = np.array([text(value) for value in values], dtype=object)
        columns[name] = ("row", column, one.units)
    return xarray.Dataset(columns)


def from_rows(of: Any, table: Table, prefix: str = "") -> list[Any]:
    """What `to_rows` was given."""
    columns = {}
    for name, each in kinds(of).items():
        if each.role == "group":
            columns[name] = from_rows(each.type, table, f"{prefix}{name}.")
            continue
        cells = table[f"{prefix}{name}"].values.tolist()
        columns[name] = [None if missing(cell, each) else value_of(cell, each) for cell in cells]
    return [
        of(**dict(zip(columns, row, strict=True))) for row in zip(*columns.values(), strict=True)
    ]


def leaves(of: Any, prefix: str = "") -> dict[str, Kind]:
    """The columns of a table of plain dataclasses."""
    found = {}
    for name, each in kinds(of).items():
        within = each.role == "group"
        found |= leaves(each.type, f"{prefix}{name}.") if within else {f"{prefix}{name}": each}
    return found


def inner(one: Any, name: str) -> Any:
    for part in name.split("."):
        one = getattr(one, part)
    return one


def value_of(kept: Any, each: Kind) -> Any:
    """What was kept, as its type; a file has no truth values, only 0 and 1."""
    if each.role == "array":
        return kept.astype(bool) if "bool" in each.type.dtypes else kept
    if each.role in ("number", "word"):
        return each.type(kept)
    found = json.loads(kept)
    return tuple(found) if each.type is tuple else found


def missing(cell: Any, each: Kind) -> bool:
    """Does a cell stand for None?"""
    return each.optional and (cell == "" if isinstance(cell, str) else bool(cell != cell))


def text(value: Any) -> str:
    """Anything that JSON can hold; floats come back as they were."""
    return json.dumps(value, ensure_ascii=False, default=str)
