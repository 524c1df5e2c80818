"""What is written for other programs: JSON without what only Python has."""

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from exoid.report.document.replacing import replacing


def plain(value: Any) -> Any:
    """The value as JSON has it: no array, no NumPy number, null for what is not finite."""
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
    with replacing(path) as part:
        part.write_text(text, encoding="utf-8")
