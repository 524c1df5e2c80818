"""What a run keeps while it goes on: the rows of every batch, each written once and whole."""

from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from exoid.files.replacing import replacing
from exoid.studies.engine.kept.not_kept import NotKept

FOLDER = ".parts"  # hidden: a data set that holds the results does not take them for recordings
DONE, FOUND = "recordings", "quantities"


def keep(results: Path, batch: str, recordings: pa.Table, quantities: pa.Table) -> None:
    """Both tables of the batch of that name, the recordings last: they say that all is there.

    **Raises** `NotKept` where they cannot be written.
    """
    for name, table in ((FOUND, quantities), (DONE, recordings)):
        try:
            with replacing(results / FOLDER / f"{name}-{batch}.parquet") as path:
                pq.write_table(table, path)
        except OSError as fault:
            where = str(results / FOLDER)
            raise NotKept(fault.errno or 0, fault.strerror or str(fault), where) from fault


def is_kept(results: Path, batch: str) -> bool:
    """Was it computed before, by a worker that was killed before it could say so?"""
    return (results / FOLDER / f"{DONE}-{batch}.parquet").is_file()


def parts(results: Path) -> list[Path]:
    """The recordings of every batch that was kept."""
    return sorted((results / FOLDER).glob(f"{DONE}-*.parquet"))


def keys_of(part: Path) -> list[str]:
    return pq.read_table(part, columns=["key"])["key"].to_pylist()


def kept(results: Path) -> dict[str, Path]:
    """By the key of every recording that is done, the part that has it."""
    found: dict[str, Path] = {}
    for part in parts(results):
        for key in keys_of(part):
            found.setdefault(key, part)
    return found


def quantities_beside(part: Path) -> Path:
    return part.with_name(part.name.replace(DONE, FOUND, 1))
