"""The same task for many, on all cores: a compiled program runs on one and lets others run."""

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Given = TypeVar("Given")
Result = TypeVar("Result")
MOST = min(8, os.cpu_count() or 1)  # at once: each holds the memory of a program's run


def side_by_side(task: Callable[[Given], Result], each: Iterable[Given]) -> list[Result]:
    """`task` of each, in their order."""
    waiting = list(each)
    if len(waiting) < 2 or MOST < 2:
        return [task(one) for one in waiting]
    with ThreadPoolExecutor(min(MOST, len(waiting))) as pool:
        return list(pool.map(task, waiting))
