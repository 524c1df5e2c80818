"""Runs whose processes are killed, at any moment, lose nothing and compute nothing twice."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from study_runs import COMPUTED, DROPS, contents, in_this_process

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.kept.parts import kept, keys_of, parts
from exoid.studies.engine.run_study import run_study

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
