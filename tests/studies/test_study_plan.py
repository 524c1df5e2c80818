"""Which recordings a worker computes side by side."""

from itertools import chain
from pathlib import Path

from exoid.studies.dataset.entry import Entry, Participant
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.plan import FIRST, LARGEST, SMALLEST, Batch, plan, unlike
from exoid.studies.engine.settings import TOGETHER


def item(name: str, size: int = 1000, recording: str = "") -> Item:
    return Item(Entry(Path(name), name), Participant(""), recording or name, name, size)


def names(batches: list[Batch]) -> list[list[str]]:
    return [[each.entry.name for each in batch.items] for batch in batches]


def test_every_recording_is_in_one_batch_with_others_of_its_format_and_size():
    items = [item(f"{n}.csv") for n in range(100)] + [item("long.csv", 9000), item("a.blf", 1000)]
    batches = plan(items, 2)
    assert sorted(chain(*names(batches))) == sorted(each.entry.name for each in items)
    assert names(batches)[0] == ["long.csv"]  # what takes longest does not come last
    assert ["a.blf"] in names(batches)
    assert max(len(batch.items) for batch in batches) == 102 // 8  # four batches for each of two


def test_batches_are_neither_tiny_nor_huge():
    few = plan([item(f"{n}") for n in range(16)], 8)
    assert [len(batch.items) for batch in few] == [FIRST, FIRST, SMALLEST - FIRST, SMALLEST - FIRST]
    assert max(len(b.items) for b in plan([item(f"{n}") for n in range(5000)], 1)) == LARGEST
    assert len(plan([item(f"{n}", 40_000_000) for n in range(9)], 1)[0].items) == 1  # by bytes


def test_the_first_batch_of_each_worker_is_small_so_that_something_is_kept_soon():
    sizes = [len(batch.items) for batch in plan([item(f"{n}") for n in range(120)], 2)]
    assert sizes == [FIRST, FIRST, 15 - FIRST, 15 - FIRST, *([15] * 6)]


def test_every_diagnosis_is_kept_and_told_of_when_it_is_done():
    items = [item(f"{n}.csv") for n in range(200)]
    assert {len(batch.items) for batch in plan(items, 2, TOGETHER["diagnose"])} == {1}
    assert max(len(b.items) for b in plan(items, 2, TOGETHER["fit"])) == 25


def test_of_recordings_that_hold_the_same_the_first_is_computed():
    kept, again = unlike([item("a", recording="x"), item("b"), item("c", recording="x")])
    assert [each.entry.name for each in kept] == ["a", "b"]
    assert again == {"c": "a"}


def test_a_batch_is_halved_without_losing_one():
    one, other = Batch(tuple(item(str(n)) for n in range(5))).halves()
    assert names([one, other]) == [["0", "1"], ["2", "3", "4"]]
