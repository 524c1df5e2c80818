"""Batches through workers that fail in every way."""

from contextlib import nullcontext
from dataclasses import dataclass
from errno import ENOSPC
from pathlib import Path

import pytest

from exoid.studies.dataset.entry import Entry, Participant
from exoid.studies.engine import carry_out as module
from exoid.studies.engine.carry_out import carry_out
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.not_kept import NotKept
from exoid.studies.engine.plan import Batch


@dataclass(frozen=True, eq=False)
class Ended:
    """A task that has ended."""

    fault: Exception | None = None
    status: str = "finished"

    def exception(self):
        return self.fault


class Workers:
    def as_current(self):
        return nullcontext()

    def nthreads(self):
        return {"one": 1}


@pytest.fixture(autouse=True)
def _at_once(monkeypatch):
    monkeypatch.setattr(module, "ended", lambda client, running, patience: running[:1])


def batch_of(count: int) -> Batch:
    each = (Entry(Path(str(n)), str(n)) for n in range(count))
    return Batch(tuple(Item(one, Participant(""), one.name, one.name, 1) for one in each))


def test_what_takes_its_worker_down_is_found_among_the_others():
    computed, heard = [], []

    def submit(batch: Batch) -> Ended:
        names = [item.entry.name for item in batch.items]
        if "37" in names:
            return Ended(MemoryError(), "error")
        computed.extend(names)
        return Ended()

    lost = carry_out(Workers(), [batch_of(64)], submit, heard.append)
    assert [item.entry.name for item in lost] == ["37"]
    assert sorted(computed, key=int) == [str(n) for n in range(64) if n != 37]
    assert sum(heard) == 64


def test_a_disk_that_takes_nothing_ends_the_run():
    full = NotKept(ENOSPC, "No space left on device", "results/.parts")
    with pytest.raises(NotKept, match="No space left"):
        carry_out(Workers(), [batch_of(4)], lambda batch: Ended(full, "error"), lambda count: None)


def test_a_scheduler_that_is_gone_is_told_with_what_to_do():
    with pytest.raises(OSError, match=r"scheduler does not answer.* run it again"):
        carry_out(
            Workers(), [batch_of(4)], lambda batch: Ended(status="cancelled"), lambda count: None
        )


def test_only_a_few_batches_wait_for_each_worker():
    waiting: list[int] = []
    submitted = 0

    def submit(batch: Batch) -> Ended:
        nonlocal submitted
        submitted += 1
        return Ended()

    def heard(count: int) -> None:
        waiting.append(submitted - len(waiting))

    carry_out(Workers(), [batch_of(1)] * 50, submit, heard)
    assert submitted == 50
    assert max(waiting) == module.AHEAD


def test_where_nothing_goes_on_the_run_ends_and_says_what_to_look_at(monkeypatch):
    import distributed

    def late(running, **options):
        raise distributed.TimeoutError

    monkeypatch.undo()
    monkeypatch.setattr(distributed, "wait", late)
    with pytest.raises(OSError, match=r"no batch .* in 2 min: does the file system stall"):
        carry_out(
            Workers(), [batch_of(4)], lambda batch: Ended(), lambda count: None, patience=120.0
        )
