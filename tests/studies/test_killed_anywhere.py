"""Worker, scheduler or client is killed at any moment of a run, and nothing is lost."""

import os
import random
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from benchmarks.studies.people import drops, write

from exoid.fitting.result.fit_result import FitResult
from exoid.recordings.loading.load import load
from exoid.studies.batch.fit_many import fit_many
from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.run_study import run_study
from killed_runs import assert_nothing_is_lost_or_there_twice, cluster, started, until, workers_of
from study_runs import DROPS, in_this_process

pytestmark = [
    pytest.mark.proof,
    pytest.mark.skipif(sys.platform != "linux", reason="reads /proc"),
]
ENDED = 60.0  # s in which a worker notices that nobody waits for it
MOMENTS = pytest.mark.parametrize("moment", range(10))


@pytest.fixture(scope="module")
def usual(folder, programs, tmp_path_factory) -> float:
    """s that a run takes which nobody disturbs, its programs compiled."""
    for name in ("first", "second"):
        began = time.monotonic()
        running = started(folder, tmp_path_factory.mktemp(name), programs, "--workers", "1")
        running.communicate(timeout=600)
    return time.monotonic() - began


def killed_at(moment: int, usual: float, running: subprocess.Popen, victims) -> None:
    """Kill at a tenth of the run, of its own for every moment; the run then ends as it may."""
    share = (moment + random.Random(moment).random()) / 10
    with suppress(subprocess.TimeoutExpired):
        running.wait(share * usual)
    if running.poll() is None:
        for victim in victims():
            with suppress(ProcessLookupError):
                os.kill(victim, signal.SIGKILL)
    running.communicate(timeout=600)


def assert_the_next_run_completes_it(folder: Path, results: Path, expected: Path) -> None:
    with in_this_process():
        run_study(open_dataset(folder), results, DROPS)
    assert_nothing_is_lost_or_there_twice(results, expected)


@MOMENTS
def test_a_worker_may_be_killed_at_any_moment(moment, usual, folder, expected, programs, tmp_path):
    running = started(folder, tmp_path, programs, "--workers", "1")
    killed_at(moment, usual, running, lambda: workers_of(running.pid))
    assert running.returncode == 0  # another worker took over
    assert_the_next_run_completes_it(folder, tmp_path, expected)


@MOMENTS
def test_a_client_may_be_killed_at_any_moment_and_its_workers_end(
    moment, usual, folder, expected, programs, tmp_path
):
    running = started(folder, tmp_path, programs, "--workers", "1")
    orphans: list[int] = []

    def client() -> list[int]:
        orphans.extend(workers_of(running.pid))
        return [running.pid]

    killed_at(moment, usual, running, client)
    until(lambda: not any(Path(f"/proc/{each}/stat").exists() for each in orphans), ENDED)
    assert_the_next_run_completes_it(folder, tmp_path, expected)


@MOMENTS
def test_a_scheduler_may_be_killed_at_any_moment(
    moment, usual, folder, expected, programs, tmp_path
):
    results = tmp_path / "results"
    with cluster(programs, tmp_path / "scheduler.json") as (address, scheduler):
        running = started(folder, results, programs, "--scheduler", address)
        killed_at(moment, usual, running, lambda: [scheduler.pid])
    assert running.returncode in (0, 2)
    assert_the_next_run_completes_it(folder, results, expected)


def test_fits_are_the_same_to_the_last_bit_whatever_they_are_computed_with(tmp_path):
    """What a killed run left over is cut into other batches."""
    write(drops(6), tmp_path)
    each = [load(path).recording for path in sorted(tmp_path.glob("*.csv"))]
    together = ratios(each)
    assert len(together) == 6
    for size in (1, 4):
        parted = [one for at in range(0, len(each), size) for one in ratios(each[at : at + size])]
        for one, other in zip(together, parted, strict=True):
            for name in one:
                assert np.array_equal(told(one[name]), told(other[name]), equal_nan=True)


def ratios(recordings) -> list:
    return [each.ratios for each in fit_many(recordings) if isinstance(each, FitResult)]


def told(estimate) -> list[float]:
    return [np.nan if each is None else each for each in (estimate.value, estimate.standard_error)]
