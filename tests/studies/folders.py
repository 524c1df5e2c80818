"""Folders of small recordings, as studies have them."""

from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

HANGING = -np.pi / 2  # rad


def table_of(seed: float = 0.0, rate: float = 100.0, seconds: float = 3.0) -> str:
    """exoid's own table of one leg that swings down from 20 deg below the horizontal.

    Each seed swings a little differently, so that no two of them hold the same.
    """
    time = np.arange(round(seconds * rate)) / rate
    swing = HANGING + (1.2 + 0.01 * seed) * np.exp(-0.4 * time) * np.cos(5 * time)
    rows = (f"{t:.4f},{angle:.6f}" for t, angle in zip(time, swing, strict=True))
    return "\n".join(["time_s,raw_angle_rad", *rows, ""])


def study(folder: Path, names: Iterable[str], sidecars: Mapping[str, str] | None = None) -> Path:
    """A folder with a recording under each name, and these sidecars."""
    for seed, name in enumerate(names):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(table_of(seed), encoding="utf-8")
    for name, text in (sidecars or {}).items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder
