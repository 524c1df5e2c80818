"""Whatever a library does over a damaged file, we get its arrays or one sentence."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import foreign_readers
import numpy as np
import pytest

from exoid.files import foreign
from exoid.files.foreign import ForeignError, read_apart
from exoid.recordings.loading.can_log import read_can_log

# A job that a shell runs in the background ignores Ctrl-C, and so would what it starts.
CALL = """
import signal, sys; from pathlib import Path
signal.signal(signal.SIGINT, signal.default_int_handler)
import foreign_readers; from exoid.files.foreign import read_apart
read_apart(foreign_readers.marking, Path(sys.argv[1]), "")
"""


@pytest.fixture
def path(tmp_path):
    found = tmp_path / "leg.dat"
    found.write_bytes(b"\x01\x02\xff")
    return found


@pytest.fixture
def impatient(monkeypatch):
    """A limit that a reader which never ends reaches soon."""
    monkeypatch.setattr(foreign, "SECONDS", 1.0)


def test_arrays_come_back_and_nothing_that_the_library_prints(path, capfd):
    arrays = read_apart(foreign_readers.good, path, "Export it again.")
    np.testing.assert_array_equal(arrays["bytes"], np.array([1, 2, 255], np.uint8))
    assert str(arrays["name"]) == "é"
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("reader", [foreign_readers.looping, foreign_readers.deaf])
def test_a_reader_that_never_ends_is_ended(path, reader, impatient):
    told = rf"{path}: reading it took longer than 1 s: it is damaged.* Export it again\."
    with pytest.raises(ForeignError, match=told):
        read_apart(reader, path, "Export it again.")


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("broken", "it is damaged, or not what its name says"),
        ("dying", r"its reader broke down \(-?\d+\)"),
        ("pickling", "it is damaged, or not what its name says"),
        ("greedy", r"it takes more than 1\.1 GB of memory"),
    ],
)
def test_a_reader_that_fails_is_one_sentence(path, name, reason):
    if name == "greedy" and sys.platform != "linux":
        pytest.skip("memory is limited on Linux alone")
    with pytest.raises(ForeignError, match=rf"leg\.dat cannot be read: {reason}") as caught:
        read_apart(getattr(foreign_readers, name), path, "Export it again.")
    assert str(caught.value).isprintable()
    assert str(caught.value).endswith("Export it again.")


def test_a_missing_file_is_not_called_damaged(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"none\.dat"):
        read_apart(foreign_readers.good, tmp_path / "none.dat", "")


@pytest.mark.skipif(sys.platform != "linux", reason="a process follows its parent on Linux alone")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_a_reader_ends_with_the_process_that_wants_it(path, number):
    places = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    caller = subprocess.Popen(
        [sys.executable, "-c", CALL, str(path)],
        env=os.environ | {"PYTHONPATH": places},
        stderr=subprocess.DEVNULL,
    )
    told = path.with_suffix(".pid")
    wait_for(lambda: told.exists() and told.read_text())
    reader = Path("/proc", told.read_text())
    assert reader.exists()
    caller.send_signal(number)
    caller.wait(60)
    wait_for(lambda: not reader.exists() or "\nState:\tZ" in (reader / "status").read_text())


def wait_for(done, seconds=60):
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end
        time.sleep(0.05)


def test_a_damaged_link_of_an_mf4_file_does_not_hold_us_up(shared, impatient):
    with pytest.raises(ValueError, match=r"loop\.mf4: reading it took longer than 1 s"):
        read_can_log(shared / "faults" / "loop.mf4")
