"""The processes that compute a study."""

import socket
import subprocess
import sys
from contextlib import suppress
from unittest.mock import Mock

import pytest

from exoid.studies.engine import workers as module
from exoid.studies.engine.settings import Settings

TWICE = """
import os

from exoid.studies.engine.workers import workers

if __name__ == "__main__":
    for again in range(2):
        with workers(1, None, 2**29) as client:
            print(client.submit(sum, (1, again)).result())
            print(client.submit(os.getenv, "MALLOC_TRIM_THRESHOLD_", "as usual").result())
"""


@pytest.fixture(scope="module")
def twice(tmp_path_factory):
    script = tmp_path_factory.mktemp("runs") / "twice.py"  # what spawns processes is a file
    script.write_text(TWICE)
    with socket.socket() as other:
        other.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        with suppress(OSError):  # another has it already, which is as well
            other.bind(("127.0.0.1", 8787))
            other.listen()
        return subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=600)


def test_two_runs_in_one_process_have_workers_and_nothing_is_said_of_a_cluster_beside(twice):
    assert (twice.stdout.splitlines()[::2], twice.stderr) == (["1", "2"], "")


def test_a_worker_keeps_the_memory_that_it_will_need_again(twice):
    """Dask would have it given back at each turn, which takes as long as the work."""
    assert twice.stdout.splitlines()[1::2] == ["as usual"] * 2


@pytest.mark.parametrize(
    ("steps", "gigabytes", "count"),
    [
        (("drops",), 4.0, 6),  # 3.2 of them are shared out, half of one for each
        (("drops", "fit"), 4.0, 1),
        (("diagnose",), 11.0, 4),
        (("diagnose",), 64.0, 16),
        (("diagnose",), 1.0, 1),  # it may still be enough
    ],
)
def test_there_are_no_more_workers_than_have_the_memory_that_steps_need(
    steps, gigabytes, count, monkeypatch
):
    monkeypatch.setattr(module, "cores", lambda: 16)
    monkeypatch.setattr(module, "free", lambda: int(gigabytes * 2**30))
    assert module.affordable(Settings(steps).memory) == count


def test_memory_that_linux_fills_with_files_is_free():
    told = "MemTotal: 8000 kB\nMemFree: 100 kB\nMemAvailable:    6000 kB\nHugePages_Total: 0\n"
    assert module.available(told) == 6000 * 1024


def test_a_worker_that_is_killed_while_it_starts_is_started_again():
    died = [RuntimeError("Nanny failed to start"), RuntimeError("Nanny failed to start")]
    begin = Mock(side_effect=[*died, "cluster"])
    assert module.begun(begin) == "cluster"
    with pytest.raises(OSError, match="fewer workers"):
        module.begun(Mock(side_effect=died * 2))
