"""A second process, for what need not wait."""

import gc
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context, parent_process
from threading import Thread
from typing import Any

LOOKS = 1.0  # s, after which a starter is looked for


class SecondProcess:
    """Does one task after another, from the first on, and ends with who started it, however that
    one ends.
    """

    def __init__(self, prepare: Callable[..., None], *given: Any):
        with unheard():
            self.pool = ProcessPoolExecutor(1, get_context("spawn"), begin, (prepare, *given))

    def submit(self, task: Callable[..., Any], *arguments: Any) -> Future:
        """What the task will return; it and its arguments can be pickled."""
        with unheard():
            return self.pool.submit(task, *arguments)

    def close(self, *, at_once: bool) -> None:
        """It ends, `at_once` or when the task ends that runs."""
        for process in list((self.pool._processes or {}).values()) if at_once else ():
            process.terminate()
        self.pool.shutdown(cancel_futures=True)
        del self.pool
        gc.collect()  # its semaphores go with it, as they would not with this process


def begin(prepare: Callable[..., None], *given: Any) -> None:
    """Prepare this process for its tasks. It waits for them at a queue that it holds open itself:
    a starter that was killed would never be missed there.
    """
    Thread(target=end_with_starter, daemon=True).start()
    prepare(*given)


def end_with_starter() -> None:
    """A starter's other children may hold what would tell its end open: it is looked for, too."""
    starter = parent_process()
    assert starter is not None
    while starter.is_alive() and os.getppid() == starter.pid:
        starter.join(LOOKS)
    os._exit(0)


@contextmanager
def unheard() -> Iterator[None]:
    """What this thread starts meanwhile hears no Ctrl-C, not even before it is prepared: a process
    inherits what its starter blocks. Here it is heard afterwards, unless another thread takes it.
    """
    if not hasattr(signal, "pthread_sigmask"):  # Windows
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
