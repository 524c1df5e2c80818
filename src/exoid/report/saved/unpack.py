"""A value back from its node, by its annotation."""

from collections.abc import Sequence
from dataclasses import MISSING, dataclass, fields
from enum import Enum
from pathlib import Path
from typing import Any

import jax
import numpy as np

from exoid.report.saved.annotation import (
    LISTS,
    MAPPINGS,
    Annotation,
    base,
    class_called,
    is_array,
    is_record,
    kept,
    read,
)
from exoid.report.saved.node import DocumentError, OtherLayout, arrayed


@dataclass(frozen=True)
class Reader:
    """What is known while a document is read."""

    own: Sequence[type]  # classes of a user
    met: dict[str, Any]  # dataclasses by their place


def unpack(node: Any, hint: Any, place: str, by: Reader) -> Any:
    """The value that `pack` was given."""
    said = read(hint)
    if node is None:
        return None
    if said.choices:
        return unpack_chosen(node, said, place, by)
    if said.type is Any:
        return unpack_any(node)
    if is_array(said.type):
        return unpack_array(node, said.type)
    if is_record(said.type):
        return unpack_record(node, [said.type], place, by)
    if said.origin in LISTS:
        return unpack_list(node, said, place, by)
    if said.origin in MAPPINGS:
        return {
            name: unpack(each, said.inside[1], f"{place}/{name}", by) for name, each in node.items()
        }
    return unpack_plain(node, said)


def unpack_chosen(node: Any, said: Annotation, place: str, by: Reader) -> Any:
    """One of several types, by its name."""
    for each in said.choices:
        if not is_record(read(each).type) and read(each).name == node.get("class"):
            return unpack(node["value"], each, place, by)
    records = [found for each in said.choices if is_record(found := read(each).type)]
    return unpack_record(node, records, place, by)


def unpack_record(node: Any, of: Sequence[type], place: str, by: Reader) -> Any:
    """A dataclass of one of these types, or one that was met before."""
    if "is" in node:
        return by.met[node["is"]]
    exact = class_of(node, of, by.own) if "class" in node else of[0]
    hints = kept(exact)
    required = {each.name for each in fields(exact) if is_required(each)}
    for name in sorted((set(node) - {"class"} - set(hints)) | (required & set(hints) - set(node))):
        raise OtherLayout(f"{place}/{name}")
    inside = {
        name: unpack(node[name], hint, f"{place}/{name}", by)
        for name, hint in hints.items()
        if name in node
    }
    return by.met.setdefault(place, exact(**inside))


def class_of(node: Any, of: Sequence[type], own: Sequence[type]) -> type:
    """The class that a record names: of exoid, of a user, or of a formula that was found."""
    from exoid.mismatch.novel.formula import features_called, term_called

    name = node["class"]
    if features_called(name):
        sizes = [float(arrayed(each)) for field, each in node.items() if field != "class"]
        return term_called(name, tuple(sizes))
    found = class_called(name, of, own)
    if found is None:
        raise DocumentError(
            f"it holds the class {name}, which exoid does not have: a term of one's own. Give the "
            "class by `terms`, or its file by --terms."
        )
    return found


def is_required(field: Any) -> bool:
    return field.default is MISSING and field.default_factory is MISSING


def unpack_list(node: Any, said: Annotation, place: str, by: Reader) -> Any:
    """A tuple, or a list where the annotation says no more than a sequence."""
    each = [
        unpack(one, hint, f"{place}/{number}", by)
        for number, (one, hint) in enumerate(zip(node, said.of_each(len(node)), strict=True))
    ]
    return tuple(each) if said.origin is tuple else each


def unpack_array(node: Any, hint: Any) -> Any:
    array = arrayed(node)
    if getattr(hint, "array_type", hint) is not jax.Array:
        return array
    with jax.enable_x64(True):  # else float64 would lose half of its bits
        return jax.numpy.asarray(array)


def unpack_plain(node: Any, said: Annotation) -> Any:
    """A number or a word, as its type."""
    if isinstance(node, np.ndarray):
        node = node.item()
    of = base(said.type)
    if issubclass(of, Enum):
        return of[node]
    return of(node) if of in (float, int, bool) or issubclass(of, Path) else node


def unpack_any(node: Any) -> Any:
    if isinstance(node, dict):
        if list(node) == ["class", "value"] and node["class"] == "float":
            return float(node["value"])
        return {name: unpack_any(each) for name, each in node.items()}
    return [unpack_any(each) for each in node] if isinstance(node, list) else node
