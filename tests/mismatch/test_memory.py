"""A diagnosis stays within the memory that the documentation states."""

import os
import subprocess
import sys

import pytest

from exoid.recordings.formats.own_table import write_table
from legs import drop, recording

STATED = 1.5e9  # bytes
DIAGNOSE = "import sys, exoid; print(exoid.diagnose(sys.argv[1], multistart=8).verdict)"


@pytest.mark.proof
@pytest.mark.skipif(sys.platform != "linux", reason="others count memory in other units")
def test_ten_drops_of_a_minute_at_200_hz_are_diagnosed_in_the_memory_that_is_stated(tmp_path):
    path = tmp_path / "long.csv"
    drops = [drop(duration=60.0, step=0.005, seed=seed) for seed in range(10)]
    write_table(recording(*drops), path)
    process = subprocess.Popen(
        [sys.executable, "-c", DIAGNOSE, str(path)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    said = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    assert status == 0, said
    assert 1024 * used.ru_maxrss < STATED
