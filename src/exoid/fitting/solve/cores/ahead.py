"""Programs made ahead of their need, by a second process.

To trace a program keeps all threads of a process waiting: another core helps only another process.
What that one does leaves programs in the folder; whoever comes to one that the other makes, waits.
"""

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from threading import Lock
from typing import Any

from exoid.fitting.solve.cores.second_process import SecondProcess
from exoid.fitting.solve.cores.side_by_side import MOST

LOG = logging.getLogger("exoid")
_offered: list["Ahead"] = []  # of who computes now


class Ahead:
    """Tasks of a second process, which begins where the first program is missing."""

    def __init__(self, task: Callable[..., Any], arguments: tuple):
        self.first = task, arguments
        self.process: SecondProcess | None = None
        self.begun, self.lock = MOST < 2, Lock()  # on one core it would only be in the way

    def begin(self, prepare: Callable[..., None], given: tuple) -> None:
        with self.lock:
            if self.begun:
                return
            self.begun = True
            try:
                self.process = SecondProcess(prepare, *given)
            except OSError as fault:  # no room for one: all programs are made here
                LOG.debug("no second process: %s", fault)
                return
        self.add(*self.first)

    def add(self, task: Callable[..., Any], arguments: tuple) -> None:
        """Nobody looks at what comes of it, nor whether that process still lives."""
        if self.process is not None:
            with suppress(RuntimeError):
                self.process.submit(task, *arguments)

    def close(self) -> None:
        with self.lock:
            self.begun = True
            if self.process is not None:
                self.process.close(at_once=True)
                self.process = None


@contextmanager
def ahead(task: Callable[..., Any], *arguments: Any) -> Iterator[None]:
    """Meanwhile a second process does the task, should a program be missing. What it asks for must
    be of modules that another process finds.
    """
    offered = Ahead(task, arguments)
    _offered.append(offered)
    try:
        yield
    finally:
        _offered.remove(offered)
        offered.close()


def end_all() -> None:
    """Whoever ends this process, while other threads still compute, ends theirs as well."""
    for each in list(_offered):
        each.close()


def is_missing(prepare: Callable[..., None], *given: Any) -> None:
    """A program is missing; `prepare`, so given, readies a second process to make others."""
    for each in _offered:
        each.begin(prepare, given)


def beside(task: Callable[..., Any], *arguments: Any) -> None:
    """The second process does this task, too, if it has begun."""
    for each in _offered:
        each.add(task, arguments)
