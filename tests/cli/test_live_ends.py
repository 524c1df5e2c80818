"""What ends `exoid live`, and what does not: neither a reader of its lines nor a full disk does."""

import os
import time
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from live_runs import BODY, FAST, as_sent
from sessions import TWO_DROPS, session, write_frames
from test_live_cable import messages

from exoid.cli.inputs.reading import EXAMPLE
from exoid.cli.live.watched import Watched
from exoid.recordings.can.logs.log_files import read_log
from exoid.watching.board import Board
from exoid.watching.origin import Origin
from live_node import Cable

FULL = Path("/dev/full")


@pytest.fixture(scope="module")
def drops():
    return session(*TWO_DROPS)


@pytest.fixture(scope="module")
def log(drops, tmp_path_factory):
    return write_frames(as_sent(drops), drops, tmp_path_factory.mktemp("live") / "two.blf")


def test_lines_that_a_full_disk_does_not_take_are_told_and_the_rest_goes_on(command, log):
    if not FULL.exists():
        pytest.skip("this system has no /dev/full")
    done = command("live", log, "--json-lines", FULL, *BODY)
    assert done.returncode == 1
    assert "2 drops so far" in done.stdout.splitlines()[0]
    (said,) = (line for line in done.stderr.splitlines() if "no more lines" in line)
    assert said.startswith(f"exoid: {FULL} gets no more lines: No space left on device. Make room")


def test_a_reader_who_has_seen_enough_ends_nothing(command, log, tmp_path):
    os.mkfifo(tmp_path / "pipe")

    def read_one() -> None:
        with (tmp_path / "pipe").open(encoding="utf-8") as lines:
            lines.readline()

    reader = Thread(target=read_one)
    reader.start()
    done = command("live", log, "--json-lines", tmp_path / "pipe", *BODY)
    reader.join()
    assert done.returncode == 0, done.stderr
    assert "2 drops so far" in done.stdout.splitlines()[0]


def test_what_is_kept_goes_on_where_the_estimator_fails(command, drops, tmp_path, monkeypatch):
    def failing(self, **options):
        raise MemoryError

    monkeypatch.setattr(Origin, "company", failing)
    monkeypatch.setenv("CAN_CONFIG", '{"sleep_after_open": 0}')
    cable = Cable(tmp_path / "port")
    sent = messages(as_sent(drops))
    sending = Thread(target=lambda: (cable.heard(), cable.stream(sent, FAST)))
    sending.start()
    begin = time.monotonic()
    options = ("-o", tmp_path / "leg.blf", "--duration", 3, "--no-refine", *BODY)
    done = command("live", "--channel", cable.path, *options)
    assert time.monotonic() - begin > 3.0
    sending.join()
    cable.pull_out()
    assert done.returncode == 1
    assert "out of memory" in done.stderr.splitlines()[-1]
    assert "the estimator has failed" in done.stderr
    frames = read_log(tmp_path / "leg.blf").frames
    assert len(frames) > 2.0 * FAST  # frames, of 3 s on a busy machine


class Busy:
    """A company that makes a fit for ever."""

    busy = fits = True

    def look(self, board) -> None:
        pass

    def close(self) -> None:
        self.busy = False


class Shown:
    def __init__(self):
        self.board, self.said = Board(), []

    def tell(self, sentence: str) -> None:
        self.said.append(sentence)


def test_who_loses_patience_waits_for_nobody_and_was_told_for_what():
    company: Any = Busy()
    panel: Any = Shown()
    asked: list[int] = []
    watched = Watched(lambda: company, panel, [])
    begin = time.monotonic()
    watched.end(lambda: not asked.append(1) and len(asked) < 4, over="the file is over")
    assert time.monotonic() - begin < 5.0
    assert not company.busy
    assert panel.board.over == "the file is over"
    (said,) = panel.said
    assert said.startswith("the file is over; the batch fit of its drops is still made: Ctrl-C")


def test_a_mass_that_an_option_names_has_no_place_of_the_sidecars(command):
    """The sidecar's is 0 m where its own mass is 0 kg."""
    done = command("live", EXAMPLE, "--added-mass", 1)
    assert done.returncode == 0, done.stderr
    assert "drop 1 with 1 kg" in done.stderr
    done = command("live", EXAMPLE, "--added-mass", 1, "--added-mass-distance", 0)
    assert done.returncode == 2
    assert "the added mass of 1 kg is said to sit 0 m from" in done.stderr.splitlines()[-1]
