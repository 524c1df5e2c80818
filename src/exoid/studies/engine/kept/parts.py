"""What a run keeps while it goes on: of every step the rows of every batch, each written once and
whole.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from exoid.files.replacing import replacing
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.not_kept import NotKept

FOLDER = ".parts"  # hidden: a data set that holds the results does not take them for recordings
DONE, FOUND = "recordings", "quantities"


def folder_of(results: Path, step: str, digest: str) -> Path:
    """Where the parts of a step lie: with other settings it has another folder."""
    return results / FOLDER / f"{step}-{digest}"


def keep(folder: Path, batch: str, recordings: pa.Table, quantities: pa.Table) -> None:
    """Both tables of the batch of that name, the recordings last: they say that all is there.

    **Raises** `NotKept` where they cannot be written.
    """
    for name, table in ((FOUND, quantities), (DONE, recordings)):
        try:
            folder.mkdir(exist_ok=True)
            with replacing(folder / f"{name}-{batch}.parquet") as path:
                pq.write_table(table, path)
        except OSError as fault:
            raise NotKept(fault.errno or 0, fault.strerror or str(fault), str(folder)) from fault


def is_kept(folder: Path, batch: str) -> bool:
    """Was it computed before, by a worker that was killed before it could say so?"""
    return (folder / f"{DONE}-{batch}.parquet").is_file()


def parts(folder: Path) -> list[Path]:
    """The recordings of every batch that was kept."""
    return sorted(folder.glob(f"{DONE}-*.parquet"))


def keys_of(part: Path) -> list[str]:
    return pq.read_table(part, columns=["key"])["key"].to_pylist()


def kept(folder: Path) -> dict[str, Path]:
    """By the key of every recording that is done, the part that has it."""
    found: dict[str, Path] = {}
    for part in parts(folder):
        for key in keys_of(part):
            found.setdefault(key, part)
    return found


def missing_in(folders: Mapping[str, Path], items: Sequence[Item]) -> dict[str, list[Item]]:
    """The recordings that no part of a step has, by the steps that lack some."""
    found = {}
    for step, folder in folders.items():
        there = kept(folder)
        found[step] = [item for item in items if item.key not in there]
    return {step: left for step, left in found.items() if left}


def named(folder: Path, names: Mapping[str, str]) -> dict[Path, dict[str, str]]:
    """By part, the keys to take from it, of those that have names, with these."""
    found: dict[Path, dict[str, str]] = {}
    for key, part in kept(folder).items():
        if key in names:
            found.setdefault(part, {})[key] = names[key]
    return found


def quantities_beside(part: Path) -> Path:
    return part.with_name(part.name.replace(DONE, FOUND, 1))
