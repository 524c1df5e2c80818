"""Runs of a study as processes of their own, which can be killed."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from exoid.studies.engine.kept.parts import keys_of
from study_runs import COMPUTED, contents, parts

SCRIPT = Path(sys.executable).with_name("exoid")


def started(
    folder: Path, results: Path, programs: Path, *more: str, steps: str = "drops"
) -> subprocess.Popen:
    """The command, in a group of processes of its own."""
    return subprocess.Popen(
        [SCRIPT, "study", "run", folder, "-o", results, "--steps", steps, *more],
        env={**os.environ, "XDG_CACHE_HOME": str(programs)},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def children(process: int) -> list[int]:
    found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process)], capture_output=True)
    return [int(word) for word in found.stdout.split()]


def workers_of(process: int) -> list[int]:
    """The processes that compute: those that Python's multiprocessing spawned."""
    return [
        child
        for child in children(process)
        if b"spawn_main" in Path(f"/proc/{child}/cmdline").read_bytes()
    ]


def until(what, seconds: float = 240.0):
    """What `what` gives, once it gives something."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := what():
            return found
        time.sleep(0.02)
    raise TimeoutError("it did not happen")


def assert_nothing_is_lost_or_there_twice(results: Path, expected: Path) -> None:
    assert contents(results) == contents(expected)
    keys = [key for part in parts(results) for key in keys_of(part)]
    assert len(keys) == len(set(keys)) == COMPUTED


def dask(*arguments: str, programs: Path) -> subprocess.Popen:
    """A scheduler or a worker of a cluster."""
    return subprocess.Popen(
        [SCRIPT.with_name("dask"), *arguments],
        env={**os.environ, "XDG_CACHE_HOME": str(programs)},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


@contextmanager
def cluster(programs: Path, told: Path) -> Iterator[tuple[str, subprocess.Popen]]:
    """The address of a scheduler with one worker, and its process."""
    where = ("--scheduler-file", str(told))
    scheduler = dask(
        *("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", *where),
        programs=programs,
    )
    until(lambda: told.is_file() and told.stat().st_size)
    worker = dask("worker", *where, "--nthreads", "1", "--no-dashboard", programs=programs)
    yield json.loads(told.read_text())["address"], scheduler
    for each in (worker, scheduler):
        with suppress(ProcessLookupError):
            os.killpg(each.pid, signal.SIGKILL)
        each.wait()
