"""Tasks that take turns, and what they ask answered together."""

import threading
import time
from types import SimpleNamespace

import numpy as np
import pytest

from exoid.fitting.solve.meeting import MEETING, SOLVE, Guest, meet
from exoid.fitting.solve.program_cache import called


def ask(number: float, shape: int = 3) -> float:
    """A question of one number, which a program would answer; its `shape` is part of its kind."""
    seen, stage = SimpleNamespace(time=[0.0] * shape), SimpleNamespace(steps=shape)
    task = SimpleNamespace(stage=stage)
    starts = np.array([number])
    return called(SOLVE, (starts, None, seen, None, None, None, task), None, None)


def doubled(log):
    """Answers all that is asked with its double, and notes how much that was."""

    def answer(asked):
        log.append(len(asked))
        return {at: 2 * float(each.leaves[0][0]) for at, each in enumerate(asked)}

    return answer


def test_what_all_ask_is_answered_at_once_and_to_each_its_own():
    log: list[int] = []
    tasks = [lambda n=n: ask(ask(float(n))) for n in range(5)]
    assert meet(tasks, doubled(log)) == [4.0 * n for n in range(5)]
    assert log == [5, 5]


def test_who_ends_early_or_fails_does_not_hold_up_the_others():
    def failing():
        ask(1.0)
        raise ValueError("no leg is like that")

    log: list[int] = []
    ended, failed, long = meet([lambda: 7.0, failing, lambda: ask(ask(ask(1.0)))], doubled(log))
    assert (ended, long) == (7.0, 8.0)
    assert isinstance(failed, ValueError)
    assert log == [2, 1, 1]


def test_only_one_moves_at_a_time_and_no_thread_is_left():
    moving, most = [0], [0]

    def task():
        for _ in range(3):
            moving[0] += 1
            time.sleep(1e-3)  # in which another would begin
            most[0] = max(most[0], moving[0])
            moving[0] -= 1
            ask(1.0)

    before = threading.active_count()
    meet([task] * 8, doubled([]))
    assert most[0] == 1
    assert threading.active_count() == before


def test_outside_of_a_meeting_nobody_waits():
    assert MEETING.get() is None
    meet([lambda: isinstance(MEETING.get(), Guest)], doubled([]))
    assert MEETING.get() is None


def test_questions_of_one_kind_have_the_same_shapes_and_about_the_same_steps():
    kinds = []

    def answer(asked):
        kinds.extend(each.kind for each in asked)
        return dict.fromkeys(range(len(asked)), 0.0)

    meet([lambda s=s: ask(1.0, s) for s in (3, 3, 100)], answer)
    assert kinds[0] == kinds[1] != kinds[2]


def test_where_a_program_breaks_down_all_are_told_and_no_thread_is_left():
    def broken(asked):
        raise RuntimeError("XLA")

    before = threading.active_count()
    with pytest.raises(RuntimeError, match="XLA"):
        meet([lambda: ask(1.0)] * 4, broken)
    assert threading.active_count() == before
