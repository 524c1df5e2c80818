"""Runs whose processes are killed, at any moment, lose nothing and compute nothing twice."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.kept.parts import kept, keys_of, parts
from exoid.studies.engine.run_study import run_study
from study_runs import COMPUTED, DROPS, contents, in_this_process

SCRIPT = Path(sys.executable).with_name("exoid")


def started(folder: Path, results: Path, programs: Path, *more: str) -> subprocess.Popen:
    """The command, in a group of processes of its own."""
    return subprocess.Popen(
        [SCRIPT, "study", "run", folder, "-o", results, "--steps", "drops", *more],
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
    assert len(keys) == len(set(keys)) == len(kept(results)) == COMPUTED


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_worker_that_is_killed_costs_nothing_but_time(folder, expected, programs, tmp_path):
    running = started(folder, tmp_path, programs, "--workers", "1")
    victim = until(lambda: workers_of(running.pid))[0]
    until(lambda: parts(tmp_path) or running.poll() is not None)
    if running.poll() is None:
        os.kill(victim, signal.SIGKILL)
    said, complaints = running.communicate(timeout=600)
    assert (running.returncode, complaints) == (0, "")
    assert "wrote" in said
    assert contents(tmp_path) == contents(expected)


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_run_that_is_killed_goes_on_where_it_was(folder, expected, programs, tmp_path):
    running = started(folder, tmp_path, programs, "--workers", "1")
    until(lambda: parts(tmp_path) or running.poll() is not None)
    os.killpg(running.pid, signal.SIGKILL)
    running.communicate()
    done = kept(tmp_path)
    assert done
    with in_this_process():
        assert run_study(open_dataset(folder), tmp_path, DROPS).computed == COMPUTED - len(done)
    assert_nothing_is_lost_or_there_twice(tmp_path, expected)


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


@pytest.fixture
def cluster(programs, tmp_path_factory):
    """The address of a scheduler with one worker, and its process."""
    told = tmp_path_factory.mktemp("cluster") / "scheduler.json"
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


def test_a_scheduler_that_is_killed_is_told_and_the_next_run_goes_on(
    cluster, folder, expected, programs, tmp_path
):
    address, scheduler = cluster
    running = started(folder, tmp_path, programs, "--scheduler", address)
    until(lambda: parts(tmp_path) or running.poll() is not None)
    os.killpg(scheduler.pid, signal.SIGKILL)
    _, complaints = running.communicate(timeout=600)
    if running.returncode:  # else it was done before
        assert running.returncode == 2
        assert "the scheduler does not answer any more" in complaints
        assert complaints.count("\n") == 1
    with in_this_process():
        run_study(open_dataset(folder), tmp_path, DROPS)
    assert contents(tmp_path) == contents(expected)


def test_a_scheduler_that_is_not_there_is_told_with_what_to_do(folder, programs, tmp_path):
    running = started(folder, tmp_path, programs, "--scheduler", "tcp://127.0.0.1:9")
    _, complaints = running.communicate(timeout=600)
    assert running.returncode == 2
    assert complaints.startswith("exoid: tcp://127.0.0.1:9: no scheduler answers there.")
    assert complaints.count("\n") == 1


@pytest.mark.proof
@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("moment", range(10))
def test_at_any_moment_a_kill_loses_nothing(moment, folder, expected, programs, tmp_path):
    """Worker or run, between the start and somewhat beyond what a run usually takes."""
    draw = random.Random(moment)
    running = started(folder, tmp_path, programs, "--workers", "1")
    with suppress(subprocess.TimeoutExpired):
        running.wait(draw.uniform(1.0, 20.0))
    if running.poll() is None and draw.random() < 0.5:
        for victim in workers_of(running.pid):
            os.kill(victim, signal.SIGKILL)
        running.wait(600)
    elif running.poll() is None:
        os.killpg(running.pid, signal.SIGKILL)
    running.communicate()
    with in_this_process():
        run_study(open_dataset(folder), tmp_path, DROPS)
    assert_nothing_is_lost_or_there_twice(tmp_path, expected)
