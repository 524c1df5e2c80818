"""The same task for many: as one after the other, and at once."""

from threading import Barrier

import pytest

from exoid.fitting.solve.cores import side_by_side as module
from exoid.fitting.solve.cores.side_by_side import side_by_side


def test_results_come_in_the_order_of_what_was_given():
    assert side_by_side(lambda number: number**2, range(20)) == [n**2 for n in range(20)]
    assert side_by_side(str, [1]) == ["1"]
    assert side_by_side(str, []) == []


def test_two_tasks_run_at_once(monkeypatch):
    monkeypatch.setattr(module, "MOST", 2)
    meeting = Barrier(2, timeout=20.0)  # s; broken unless both wait there together
    side_by_side(lambda _: meeting.wait(), range(2))


def test_one_core_does_one_after_the_other(monkeypatch):
    monkeypatch.setattr(module, "MOST", 1)
    done = []
    side_by_side(done.append, range(5))
    assert done == [0, 1, 2, 3, 4]


def test_what_fails_is_raised():
    with pytest.raises(ZeroDivisionError):
        side_by_side(lambda number: 1 / number, [1, 0, 2])
