"""Runs whose processes are killed lose nothing and compute nothing twice."""

import os
import signal
import subprocess
import sys

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.run_study import run_study
from killed_runs import assert_nothing_is_lost_or_there_twice, cluster, started, until, workers_of
from study_runs import COMPUTED, DROPS, contents, in_this_process, kept, parts

NOBODY = "tcp://127.0.0.1:9"
HASTY = (
    "from exoid.studies.engine import workers; workers.ANSWER = 1.0; "
    "from exoid.cli import main; main()"
)


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_worker_that_is_killed_costs_nothing_but_time(folder, expected, programs, tmp_path):
    running = started(folder, tmp_path, programs, "--workers", "1")
    victim = until(lambda: workers_of(running.pid))[0]
    until(lambda: parts(tmp_path) or running.poll() is not None)
    if running.poll() is None:
        os.kill(victim, signal.SIGKILL)
    said, complaints = running.communicate(timeout=600)
    assert running.returncode == 0
    assert all(each.startswith("exoid: drops: ") for each in complaints.splitlines())
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


def test_a_scheduler_that_is_killed_is_told_and_the_next_run_goes_on(
    folder, expected, programs, tmp_path
):
    results = tmp_path / "results"
    with cluster(programs, tmp_path / "scheduler.json") as (address, scheduler):
        running = started(folder, results, programs, "--scheduler", address)
        until(lambda: parts(results) or running.poll() is not None)
        os.killpg(scheduler.pid, signal.SIGKILL)
        _, complaints = running.communicate(timeout=600)
    if running.returncode:  # else it was done before
        assert running.returncode == 2
        assert "the scheduler does not answer any more" in complaints.splitlines()[-1]
        assert "Traceback" not in complaints
    with in_this_process():
        run_study(open_dataset(folder), results, DROPS)
    assert contents(results) == contents(expected)


def test_a_scheduler_that_is_not_there_is_told_with_what_to_do(folder, tmp_path):
    asked = ["study", "run", folder, "-o", tmp_path, "--steps", "drops", "--scheduler", NOBODY]
    done = subprocess.run([sys.executable, "-c", HASTY, *asked], capture_output=True, text=True)
    assert done.returncode == 2
    last, complaints = done.stderr.splitlines()[-1], done.stderr
    assert last.startswith("exoid: tcp://127.0.0.1:9: no scheduler answers there.")
    assert "Traceback" not in complaints
