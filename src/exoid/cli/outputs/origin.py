"""How a result came about: the command, the files, the versions, the time."""

import hashlib
import platform
import shlex
import sys
from collections.abc import Iterable, Mapping
from datetime import datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

COMPUTED_WITH = ("jax", "jaxlib", "equinox", "optimistix", "diffrax", "numpy", "scipy", "plotly")


def origin_of(files: Iterable[Path], settings: Mapping[str, Any]):
    """What a report says of itself; call it where the command is done."""
    from exoid.report.parts.origin import Origin

    versions = {name: version(name) for name in ("exoid", *COMPUTED_WITH)}
    return Origin(
        command=shlex.join(["exoid", *sys.argv[1:]]),
        made=datetime.now().astimezone().strftime("%Y-%m-%d %H:%M:%S %z"),
        settings={
            name.replace("_", " "): in_words(value)
            for name, value in settings.items()
            if value is not None
        },
        versions={**versions, "Python": platform.python_version()},
        files={str(path): sha256_of(path) for path in files},
    )


def sha256_of(path: Path) -> str:
    """What tells a file from any other."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def inputs(recordings: Iterable[Path], *others: Path | None) -> list[Path]:
    """Every file that was read: recordings with their sidecars, and others where they are given."""
    beside = [name for path in recordings for name in (path, path.with_suffix(".toml"))]
    return [path for path in (*beside, *others) if path is not None and path.is_file()]


def in_words(value: Any) -> str:
    """A setting as a person writes it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {in_words(each)}" for name, each in value.items())
    if isinstance(value, list | tuple):
        return ", ".join(map(in_words, value))
    return "open" if value is None else str(value)
