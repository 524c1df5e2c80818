"""What is written for other programs: JSON without what only Python has."""

import json
import math
from collections.abc import Collection, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.replacing import replacing
from exoid.files.visible import visible


def shown(one: Any, without: Collection[str] = (), **names: str) -> dict[str, Any]:
    """The fields of a dataclass, some of them under other `names`."""
    return {
        names.get(each.name, each.name): getattr(one, each.name)
        for each in fields(one)
        if each.name not in without
    }


def plain(value: Any) -> Any:
    """The value as JSON has it: no array, no NumPy number, null for what is not finite."""
    if is_dataclass(value):
        return plain(shown(value))
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return str(value) if isinstance(value, Path) else value


def write_json(document: Mapping[str, Any], path: str | Path) -> None:
    """Writes the document, in full or not at all.

    **Raises** `ValueError` or `OSError` (what to do) where the file cannot be written.
    """
    text = json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    with replacing(path) as part:  # people read it, too
        part.write_text(visible(text, "\n"), encoding="utf-8")
