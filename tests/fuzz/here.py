"""Other libraries' readers without a start of Python for each file."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from mmap import mmap
from unittest.mock import patch

from exoid.files.foreign import MEMORY, Arrays, sound, tried, unpacked

HOLDERS = (
    "can.logs.log_files",
    "formats.c3d",
    "formats.matlab",
    "formats.parquet",
    "formats.excel",
)


@contextmanager
def in_this_process(mark: mmap) -> Iterator[None]:
    """Stands in for `read_apart` wherever that is called; `mark` is 1 while a library reads.

    Who shares the mark knows whether it was the library over which this process ended: in a process
    of its own, as commands start one, it would have been contained.
    """

    def here(reader, path, advice: str, *, library: str = "numpy") -> Arrays:
        mark[0] = 1
        try:
            content = tried(reader, path, MEMORY)
        finally:
            mark[0] = 0
        return sound(unpacked(content), path, advice)

    with ExitStack() as patches:
        for each in HOLDERS:
            patches.enter_context(patch(f"exoid.recordings.{each}.read_apart", here))
        yield
