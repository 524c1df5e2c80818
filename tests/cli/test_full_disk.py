"""A disk that is full is told in one line with what to do, and keeps no half of anything."""

import os
import subprocess
from errno import EDQUOT, EIO, ENOSPC, EROFS
from pathlib import Path

import pytest
from command_line import refusal

TINY = "size=16k"  # less than the recording of `exoid example`


@pytest.fixture
def full(monkeypatch):
    """A disk that takes a new file, but nothing into it; the error's number can be chosen."""

    def filled(number: int) -> None:
        usual = Path.open

        def opening(self, mode="r", *options, **more):
            if self.name.endswith(".part") and "w" in mode:
                raise OSError(number, os.strerror(number))
            return usual(self, mode, *options, **more)

        monkeypatch.setattr(Path, "open", opening)

    return filled


@pytest.fixture
def disk(tmp_path):
    """A real one of a few kilobytes, where this user may mount it."""
    there = tmp_path / "disk"
    there.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", TINY, "tmpfs", str(there)]
    try:
        subprocess.run(mount, check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("this user may not mount a disk")
    yield there
    subprocess.run(["umount", str(there)], check=True)


@pytest.mark.parametrize(
    ("number", "advice"),
    [
        (ENOSPC, "Make room there, or name another disk."),
        (EDQUOT, "Delete files of yours there, or name another disk."),
        (EROFS, "Name a disk that can be written to."),
        (EIO, "The disk, or the way to it, fails: name another."),
    ],
)
def test_a_disk_that_takes_nothing_is_told_with_what_to_do(command, full, tmp_path, number, advice):
    full(number)
    there = tmp_path / "first" / "second"
    line = refusal(command("example", there))
    assert line == f"exoid: {there / 'session.blf'}: {os.strerror(number)}. {advice}"
    assert not list(tmp_path.iterdir())


def test_a_folder_that_was_there_stays(command, full, tmp_path):
    full(ENOSPC)
    (tmp_path / "mine").mkdir()
    refusal(command("example", tmp_path / "mine" / "new"))
    assert [each.name for each in tmp_path.iterdir()] == ["mine"]
    assert not list((tmp_path / "mine").iterdir())


def test_a_real_full_disk_is_left_as_it_was(command, disk):
    for done in (command("example", disk / "new"), command("simulate", disk / "leg.csv")):
        assert refusal(done).endswith("on device. Make room there, or name another disk.")
        assert not list(disk.iterdir())
