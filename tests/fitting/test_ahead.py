"""A second process makes programs ahead, and no program is made twice at a time."""

import os
import signal
import threading
import time
from multiprocessing import get_context
from pathlib import Path

import pytest

from exoid.fitting.solve.compiled import kept_program
from exoid.fitting.solve.compiled.kept_program import alone_at
from exoid.fitting.solve.cores import ahead as made_ahead
from exoid.fitting.solve.cores.ahead import ahead, beside, end_all, is_missing
from exoid.fitting.solve.cores.second_process import SecondProcess


def leave(name: str, folder: Path) -> None:
    (folder / name).write_text(str(os.getpid()))


def waited_for(path: Path) -> str:
    for _ in range(600):
        if path.exists() and path.read_text():
            return path.read_text()
        threading.Event().wait(0.1)
    raise AssertionError(f"nobody wrote {path}")


@pytest.fixture
def two_cores(monkeypatch):
    monkeypatch.setattr(made_ahead, "MOST", 2)


@pytest.mark.usefixtures("two_cores")
def test_the_second_process_begins_with_the_first_program_that_is_missing(tmp_path):
    with ahead(leave, "first", tmp_path):
        beside(leave, "too_soon", tmp_path)
        assert not made_ahead._offered[0].begun
        is_missing(int)
        beside(leave, "then", tmp_path)
        writers = {waited_for(tmp_path / name) for name in ("first", "then")}
    assert len(writers) == 1
    assert writers != {str(os.getpid())}
    assert not (tmp_path / "too_soon").exists()
    assert not made_ahead._offered


@pytest.mark.usefixtures("two_cores")
def test_what_still_runs_in_the_second_process_ends_with_the_diagnosis():
    with ahead(time.sleep, 600):
        is_missing(int)
        (process,) = made_ahead._offered[0].process.pool._processes.values()
    process.join(10)
    assert not process.is_alive()


@pytest.mark.usefixtures("two_cores")
def test_who_ends_while_a_thread_computes_ends_what_that_one_began(tmp_path):
    """An interrupt finds the main thread; the one that computes is left where it is."""
    going = threading.Event()

    def compute() -> None:
        with ahead(leave, "first", tmp_path):
            is_missing(int)
            going.wait()

    thread = threading.Thread(target=compute)
    thread.start()
    try:
        waited_for(tmp_path / "first")
        (process,) = made_ahead._offered[0].process.pool._processes.values()
        end_all()
        assert not process.is_alive()
    finally:
        going.set()
        thread.join()


def start_and_stay(folder: Path, forked: bool) -> None:
    """Start a second process, and be killed; one `forked` off this holds all its pipes."""
    process = SecondProcess(int)
    process.submit(leave, "second", folder).result()
    if not forked or os.fork():
        leave("begun", folder)
    else:
        leave("forked", folder)
    time.sleep(600)


@pytest.mark.parametrize(
    "forked",
    [
        False,
        pytest.param(True, marks=pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")),
    ],
)
def test_a_second_process_ends_with_one_that_is_killed(tmp_path, forked):
    starter = get_context("spawn").Process(target=start_and_stay, args=(tmp_path, forked))
    starter.start()
    names = ("second", "begun", "forked") if forked else ("second", "begun")
    second, _, *beside = (int(waited_for(tmp_path / name)) for name in names)
    starter.kill()
    starter.join(10)
    try:
        outlives = not any(gone(second) for _ in range(100))
    finally:
        for process in beside:
            os.kill(process, signal.SIGKILL)
    if outlives:
        os.kill(second, signal.SIGKILL)
    assert not outlives, "the second process outlives who started it"


def gone(process: int) -> bool:
    """It is looked at ten times a second."""
    time.sleep(0.1)
    return not alive(process)


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def test_on_one_core_there_is_no_second_process(tmp_path, monkeypatch):
    monkeypatch.setattr(made_ahead, "MOST", 1)
    with ahead(leave, "first", tmp_path):
        is_missing(int)
        assert made_ahead._offered[0].process is None


def test_who_comes_to_a_program_that_another_process_makes_waits_for_it(tmp_path):
    path, other = tmp_path / "a.program", SecondProcess(int)
    try:
        with alone_at(path):
            done = other.submit(makes, path)
            done_too_soon = threading.Event().wait(3.0) or done.done()
            path.write_text("here")
        assert not done_too_soon
        assert done.result(60) == "here"
    finally:
        other.close(at_once=False)


def makes(path: Path) -> str:
    with alone_at(path):
        return path.read_text() if path.exists() else "nobody made it"


def test_a_program_is_made_where_no_folder_can_be_locked(tmp_path):
    with alone_at(tmp_path / "missing" / "deeper" / "a.program"):
        pass


def test_nobody_waits_for_ever_for_a_process_that_stands_still(tmp_path, monkeypatch):
    monkeypatch.setattr(kept_program, "PATIENCE", 0.2)
    path = tmp_path / "a.program"
    with alone_at(path), alone_at(path):
        path.write_text("made twice")
