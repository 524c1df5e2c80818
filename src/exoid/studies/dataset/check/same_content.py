"""Files that hold the same under two names: by size, then by their begin, then in full."""

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable
from hashlib import sha256
from pathlib import Path

CHUNK = 2**20  # bytes
BEGIN = 2**14  # bytes


def same_content(paths: Iterable[Path]) -> list[list[Path]]:
    """Groups of files that hold the same; those that are empty or cannot be read are left out."""
    groups = split([*paths], lambda path: path.stat().st_size)
    for key in (begin_of, hash_of):
        groups = [part for group in groups for part in split(group, key)]
    return groups


def split(group: list[Path], key: Callable[[Path], Hashable]) -> list[list[Path]]:
    """The parts of a group with one key that have two members or more."""
    parts: dict[Hashable, list[Path]] = defaultdict(list)
    for path in group:
        try:
            parts[key(path)].append(path)
        except OSError:  # it is unreadable, which is said of it anyway
            continue
    return [part for found, part in parts.items() if found and len(part) > 1]


def begin_of(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(BEGIN)


def hash_of(path: Path) -> bytes:
    """Of the whole file, in pieces: it may be larger than memory."""
    found = sha256()
    with path.open("rb") as file:
        while piece := file.read(CHUNK):
            found.update(piece)
    return found.digest()
