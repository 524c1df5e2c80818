"""What stands between a dataclass and a file: None, numbers, words, lists, and these."""

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

BARE = ("float64", "int64", "bool")  # kinds of a number that need no mention


class DocumentError(ValueError):
    """What cannot be kept, or is not as it was kept: one line, to be put after the file's name."""


class OtherLayout(Exception):
    """The field of a document that this exoid has not, or the other way round."""


class Record(dict[str, Any]):
    """The fields of a dataclass; under `class` its name, where the annotation leaves that open.

    One that was met before has nothing but its place, under `is`.
    """


class Entries(dict[str, Any]):
    """What stands under names of its own, in its order."""


@dataclass(frozen=True, eq=False)
class Values:
    """An array, or a number, with its unit and the names of its axes."""

    array: np.ndarray
    axes: tuple[str, ...] = ()
    unit: str | None = None

    @property
    def bare(self) -> bool:
        """Is it one number, of the kind that Python has?"""
        return self.array.ndim == 0 and self.array.dtype.name in BARE


def in_json(node: Any) -> Any:
    """The node as JSON can hold it: an array with its kind and shape, "nan" and "inf" as words."""
    if isinstance(node, Values):
        return in_json(node.array.item()) if node.bare else in_json(spelled(node.array))
    if isinstance(node, dict):
        return {name: in_json(each) for name, each in node.items()}
    if isinstance(node, list):
        return [in_json(each) for each in node]
    if isinstance(node, float) and not math.isfinite(node):
        return repr(node)
    return node


def spelled(array: np.ndarray) -> dict[str, Any]:
    """An array as numbers in a row."""
    flat = array.ravel().tolist()
    return {"dtype": array.dtype.name, "shape": list(array.shape), "values": flat}


def arrayed(node: Any) -> np.ndarray:
    """The array that `in_json`, or a netCDF file, made of one."""
    if isinstance(node, dict):
        dtype = np.dtype(node["dtype"])
        values = [float(each) if isinstance(each, str) else each for each in node["values"]]
        return np.array(values, dtype).reshape(node["shape"])
    return np.asarray(float(node) if isinstance(node, str) else node)


def holds(node: Any, kind: type | tuple[type, ...]) -> bool:
    """Is the node of this kind, or is anything within it?"""
    if isinstance(node, kind):
        return True
    inside = node.values() if isinstance(node, dict) else node if isinstance(node, list) else ()
    return any(holds(each, kind) for each in inside)


def text(node: Any) -> str:
    """As JSON, with what UTF-8 has no sign for spelled out."""
    said = json.dumps(in_json(node), ensure_ascii=False)
    return said.encode("utf-8", "backslashreplace").decode()
