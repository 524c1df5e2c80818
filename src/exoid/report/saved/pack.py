"""A value as a node, by its annotation."""

import math
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import Any

import numpy as np

from exoid.report.saved.annotation import (
    LISTS,
    MAPPINGS,
    Annotation,
    axes,
    base,
    choose,
    is_array,
    is_record,
    kept,
    read,
)
from exoid.report.saved.node import DocumentError, Entries, Record, Values

KINDS = "biuf"  # of numbers that netCDF has, as NumPy calls them


def pack(value: Any, hint: Any, place: str, seen: dict[int, str]) -> Any:
    """The node of a value at a `place`; `seen` are the places of what was met, by identity."""
    said = read(hint)
    if value is None:
        return None
    if said.choices:
        return pack_chosen(value, choose(value, said.choices, place), place, seen)
    if said.type is Any:
        return pack_any(value, place)
    if is_array(said.type):
        return pack_array(value, said, place)
    if is_record(said.type):
        return pack_record(value, said.type, place, seen)
    if said.origin in LISTS:
        return pack_list(value, said, place, seen)
    if said.origin in MAPPINGS:
        return Entries(
            {
                name: pack(each, said.inside[1], f"{place}/{name}", seen)
                for name, each in named(value, place).items()
            }
        )
    return pack_plain(value, said, place)


def pack_chosen(value: Any, hint: Any, place: str, seen: dict[int, str]) -> Any:
    """One of several types: with its name."""
    if is_record(read(hint).type):
        return pack_record(value, None, place, seen)
    return Record({"class": read(hint).name, "value": pack(value, hint, place, seen)})


def pack_record(one: Any, expected: Any, place: str, seen: dict[int, str]) -> Record:
    """A dataclass; one that has an identity (`eq=False`) is written once."""
    of = type(one)
    if of.__eq__ is object.__eq__ and seen.setdefault(id(one), place) != place:
        return Record({"is": seen[id(one)]})
    inside = {
        name: pack(getattr(one, name), hint, f"{place}/{name}", seen)
        for name, hint in kept(of).items()
    }
    return Record(inside if of is expected else {"class": of.__qualname__, **inside})


def pack_list(value: Any, said: Annotation, place: str, seen: dict[int, str]) -> list[Any]:
    """A list or a tuple, of one type or of one for each place."""
    each = list(value)
    return [
        pack(one, hint, f"{place}/{number}", seen)
        for number, (one, hint) in enumerate(zip(each, said.of_each(len(each)), strict=True))
    ]


def pack_array(value: Any, said: Annotation, place: str) -> Values:
    array = np.asarray(value)
    if array.dtype.kind not in KINDS or array.dtype.name in ("float16", "longdouble", "bfloat16"):
        raise DocumentError(f"{place}: no file keeps an array of {array.dtype}.")
    return Values(array, axes(said.type), said.unit)


def pack_plain(value: Any, said: Annotation, place: str) -> Any:
    """A number, with its unit where it has one, or a word."""
    of = base(said.type)
    if issubclass(of, Enum):
        return value.name
    if isinstance(value, str | Path):
        return str(value)
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if of is float:
        number = float(value)
        return number if said.unit is None else Values(np.asarray(number), (), said.unit)
    if isinstance(value, int | np.integer):
        return int(value)
    raise DocumentError(f"{place}: no file keeps a {type(value).__name__} as {said.type}.")


def pack_any(value: Any, place: str) -> Any:
    """What is annotated by nothing: what JSON can hold. A tuple comes back as a list."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return Entries({"class": "float", "value": repr(value)})
    if isinstance(value, float) or (isinstance(value, int) and not isinstance(value, Enum)):
        return value
    for kinds, hint in ((str | Path, str), (Mapping, dict), (list | tuple, list)):
        if isinstance(value, kinds):
            return pack(value, hint, place, {})
    raise DocumentError(f"{place}: no file keeps a {type(value).__name__}.")


def named(value: Mapping[Any, Any], place: str) -> Mapping[str, Any]:
    """A mapping whose keys are words."""
    for name in value:
        if not isinstance(name, str):
            raise DocumentError(f"{place}: the key {name!r} is no word.")
    return value
