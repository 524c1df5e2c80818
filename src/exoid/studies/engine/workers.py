"""The processes that compute: of this machine, or of a cluster that is there."""

import logging
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

from exoid.files.library_faults import quiet

UNKNOWN = 4 * 2**30  # bytes that are taken to be free where the system does not tell
SHARE = 0.8  # of the memory that is free, for all workers
# Small matrices only, and a process for every core: threads of libraries cost more than they bring.
ALONE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "NPROC": "1"}
PORT = "127.0.0.1:0"  # of the scheduler's page: any that is free, so that runs stand side by side
ANSWER = 15.0  # s that a scheduler has to answer
BEGINS = 3  # times that workers are started, where one dies in it
NONE = (
    "no process for the study stays alive while it starts: is there memory for it? Ask for fewer "
    "workers."
)
AGAIN = 1  # workers that a batch may take down before it is cut


@contextmanager
def workers(count: int | None, scheduler: str | None, needed: int) -> Iterator[Any]:
    """A client of dask.distributed: of `scheduler`, tcp://..., or of `count` processes here, each
    of which needs so many bytes.
    """
    import distributed  # noqa: F401  # its defaults are there before settings are put over them
    from dask import config

    with quiet("distributed"), config.set(settings()):
        if scheduler is not None:
            yield from client_of(scheduler)
        else:
            yield from local(count or affordable(needed), needed)


def settings() -> dict[str, object]:
    return {
        "distributed.scheduler.allowed-failures": AGAIN,
        "distributed.worker.daemon": True,
        "distributed.worker.profile.enabled": False,  # nobody looks at it, and it costs
        # A worker is told to give memory back at each turn; to get it again takes half of its time.
        "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": None,
        "distributed.admin.tick.limit": "1h",  # Python may be busy for long: that is no fault
        "distributed.comm.timeouts.connect": f"{ANSWER:g}s",
    }


def client_of(address: str) -> Iterator[Any]:
    from distributed import Client

    try:
        client = Client(address, timeout=ANSWER, set_as_default=False)
    except (OSError, ValueError) as fault:
        raise ValueError(
            f"{address}: no scheduler answers there. Start one with 'dask scheduler', and name its "
            "address as it says it, tcp://HOST:PORT."
        ) from fault
    with client:
        yield client


def local(count: int, needed: int) -> Iterator[Any]:
    from distributed import Client, LocalCluster

    os.environ.update({name: os.environ.get(name, value) for name, value in ALONE.items()})
    begin = partial(
        LocalCluster,
        n_workers=count,
        threads_per_worker=1,
        processes=True,
        memory_limit=max(needed, share_of(count)),
        dashboard_address=None,  # type: ignore[arg-type]  # it serves none
        scheduler_kwargs={"dashboard_address": PORT},
        silence_logs=logging.CRITICAL,
    )
    with begun(begin) as cluster, Client(cluster, set_as_default=False) as client:
        yield client


def begun(begin: Callable[[], Any]) -> Any:
    """A cluster; where a worker was killed while it started, another one.

    **Raises** `OSError` where none starts.
    """
    for _ in range(BEGINS - 1):
        with suppress(RuntimeError):
            return begin()
    try:
        return begin()
    except RuntimeError as fault:
        raise OSError(NONE) from fault


def affordable(needed: int) -> int:
    """As many workers as there are cores, or fewer where each would have less memory than `needed`
    [bytes].
    """
    return max(1, min(cores(), share_of(1) // needed))


def share_of(count: int) -> int:
    """What each of so many workers may take [bytes]."""
    return int(SHARE * free() / count)


def free() -> int:
    """The memory that nobody takes [bytes]."""
    try:
        return available(Path("/proc/meminfo").read_text(encoding="ascii"))
    except (OSError, LookupError, ValueError):
        pass
    try:
        return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return UNKNOWN


def available(told: str) -> int:
    """As Linux tells it: files that it keeps in memory give way."""
    lines = dict(line.split(":", 1) for line in told.splitlines())
    return int(lines["MemAvailable"].split()[0]) * 1024


def cores() -> int:
    """Those that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
