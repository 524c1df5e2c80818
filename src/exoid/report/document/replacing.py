"""A file that is put in place when it is whole."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A file to write beside `path`, moved into its place when the block has succeeded.

    What was there before survives any failure. A pipe or a device is written to directly.
    """
    path = Path(path)
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file to write in it.")
    if not path.parent.is_dir():
        raise ValueError(f"{path}: the folder {path.parent} does not exist. Make it first.")
    if path.exists() and not path.is_file():
        yield path
        return
    target = path.resolve()  # a link stays a link
    part = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        yield part
        with part.open("rb+") as file:
            os.fsync(file.fileno())
        part.replace(target)
    finally:
        part.unlink(missing_ok=True)
