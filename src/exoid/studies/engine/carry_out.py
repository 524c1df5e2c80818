"""All batches through the workers; what takes a worker down is found among the others."""

from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.not_kept import NotKept
from exoid.studies.engine.plan import Batch

AHEAD = 3  # batches that wait for each worker, so that none waits for the next
GONE = "the scheduler does not answer any more. What was done is kept: run it again, once it does."
STALLED = 1800.0  # s without any batch done, after which something is wrong
TAKEN_DOWN = (
    "it took the process that computed it down, more than once: it may take more memory than a "
    "worker has. Give fewer workers more of it, or cut the recording shorter."
)


def carry_out(
    client: Any,
    batches: Sequence[Batch],
    submit: Callable[[Batch], Any],
    told: Callable[[int], None],
    *,
    patience: float = STALLED,
) -> list[Item]:
    """Compute all; the recordings that took their worker down, each alone. `told` hears how many
    were done, each time some are.

    **Raises** `NotKept` where results cannot be written, `OSError` where nothing goes on.
    """
    waiting, running, lost = deque(batches), {}, []
    while waiting or running:
        while waiting and len(running) < AHEAD * count_of(client):
            batch = waiting.popleft()
            running[submit(batch)] = batch
        for future in ended(client, list(running), patience):
            batch, fault = running.pop(future), fault_of(future)
            if fault is None:
                told(len(batch.items))
            elif isinstance(fault, NotKept):
                raise fault
            elif len(batch.items) > 1:
                waiting.extendleft(reversed(batch.halves()))
            else:
                lost += batch.items
                told(1)
    return lost


def count_of(client: Any) -> int:
    """How many workers there are just now; one where they are still to come."""
    try:
        return max(1, len(client.nthreads()))
    except OSError as fault:
        raise OSError(GONE) from fault


def ended(client: Any, running: list[Any], patience: float) -> list[Any]:
    """Those that have, once one has."""
    from distributed import CancelledError, wait
    from distributed import TimeoutError as Late

    try:
        with client.as_current():
            some: Any = wait(running, timeout=patience, return_when="FIRST_COMPLETED")
            return list(some.done)
    except CancelledError as fault:
        raise OSError(GONE) from fault
    except Late as fault:
        raise OSError(
            f"no batch of recordings was done in {patience / 60:.0f} min: does the file system "
            "stall, or are there no workers? What was done is kept: run it again."
        ) from fault


def fault_of(future: Any) -> BaseException | None:
    """Why a batch has no result."""
    if future.status == "finished":
        return None
    if future.status == "error":
        return future.exception()
    raise OSError(GONE)
