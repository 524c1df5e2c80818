"""Which recordings are computed together."""

import hashlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from exoid.studies.engine.kept.item import Item

LARGEST = 64  # recordings of a batch: more no longer fill the lanes of programs any better
SMALLEST = 8  # where there are as many
FIRST = 2  # of the first batch of each worker: something is kept soon, and its lanes are full
SHARES = 4  # batches for each worker, at least, so that all end at about the same time
LARGEST_BYTES = 64e6  # of their files


@dataclass(frozen=True)
class Batch:
    """Recordings of about one shape, which a worker computes side by side."""

    items: tuple[Item, ...]

    @property
    def name(self) -> str:
        """By its content: the same batch is kept in the same place, whoever computes it."""
        return hashlib.sha256(" ".join(item.key for item in self.items).encode()).hexdigest()[:32]

    def halves(self) -> tuple["Batch", "Batch"]:
        middle = len(self.items) // 2
        return Batch(self.items[:middle]), Batch(self.items[middle:])


def unlike(items: Iterable[Item]) -> tuple[list[Item], dict[str, str]]:
    """The recordings without those of which another holds the same; and of these, by name, the
    other's name.
    """
    first: dict[str, Item] = {}
    again: dict[str, str] = {}
    for item in items:
        kept = first.setdefault(item.recording, item)
        if kept is not item:
            again[item.entry.name] = kept.entry.name
    return list(first.values()), again


def plan(items: Sequence[Item], count: int, most: int = LARGEST) -> list[Batch]:
    """Batches for so many workers, each of one format, about one size and `most` recordings, the
    largest first; the first of each worker is small.
    """
    buckets: dict[tuple[str, int], list[Item]] = {}
    for item in items:
        bucket = item.entry.path.suffix.lower(), item.size.bit_length()
        buckets.setdefault(bucket, []).append(item)
    share = len(items) // (SHARES * count)
    most = min(most, max(SMALLEST, share))
    ordered = sorted(buckets.items(), key=lambda each: (-each[0][1], each[0][0]))
    batches = [batch for _, own in ordered for batch in cut(own, most)]
    return [*small(batches[:count]), *batches[count:]]


def small(batches: Sequence[Batch]) -> list[Batch]:
    """The begins of all, then their rests."""
    begins = [Batch(batch.items[:FIRST]) for batch in batches]
    rests = [Batch(batch.items[FIRST:]) for batch in batches]
    return [*begins, *(rest for rest in rests if rest.items)]


def cut(items: Sequence[Item], most: int) -> list[Batch]:
    largest = max(item.size for item in items)
    count = int(min(most, max(1, LARGEST_BYTES // max(largest, 1))))
    return [Batch(tuple(items[at : at + count])) for at in range(0, len(items), count)]
