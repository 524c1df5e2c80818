"""Whoever reads what a command says may be gone: what was asked for is written all the same."""

import os
import subprocess
from errno import ENOSPC
from pathlib import Path

import pytest
from command_line import LIMIT, SCRIPT

FULL = Path("/dev/full")
needs_full = pytest.mark.skipif(not FULL.exists(), reason=f"{FULL} is absent: no disk that is full")
NAMED = '[subject]\nkind = "leg"\nid = "A"\n'  # is said before the files are written


@pytest.fixture
def run(command, recordings, tmp_path):
    """`exoid drops` of somebody with a name, to a document; its exit code and what stderr heard."""
    (tmp_path / "drop.csv").write_bytes((recordings / "drop.csv").read_bytes())
    (tmp_path / "drop.toml").write_text(NAMED)

    def ran(
        recording="drop.csv", environment=(), redirected="", **options
    ) -> subprocess.CompletedProcess[str]:
        words = ["drops", recording, "--json", "drops.json"]
        return subprocess.run(
            ["sh", "-c", f'exec "$@" {redirected}', "sh", SCRIPT, *words],
            **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "timeout": LIMIT, **options},
            cwd=tmp_path,
            env=command.environment | dict(environment),
            text=True,
        )

    return ran


@pytest.fixture
def unread():
    """A pipe whose reader has gone."""
    reads, writes = os.pipe()
    os.close(reads)
    yield writes
    os.close(writes)


@pytest.mark.parametrize("buffered", ["", "1"])
def test_a_reader_that_is_gone_costs_no_file(run, unread, tmp_path, buffered):
    done = run(stdout=unread, environment={"PYTHONUNBUFFERED": buffered})
    assert (done.returncode, done.stderr) == (0, "wrote drops.json\n")
    assert (tmp_path / "drops.json").stat().st_size > 1000


def test_nor_does_one_who_is_told_what_was_noticed(run, recordings, unread, tmp_path):
    done = run(recordings / "session.blf", stderr=unread)
    assert done.returncode == 0
    assert "first flexion amplitude" in done.stdout
    assert (tmp_path / "drops.json").stat().st_size > 1000


@needs_full
def test_a_full_disk_below_what_is_said_costs_no_file_and_is_told(run, tmp_path):
    with FULL.open("w") as full:
        done = run(stdout=full)
    assert done.returncode == 1
    assert done.stderr.splitlines() == [
        "wrote drops.json",
        f"exoid: standard output: {os.strerror(ENOSPC)}. What was said there is cut. Make room, "
        "or send it elsewhere.",
    ]
    assert (tmp_path / "drops.json").stat().st_size > 1000


@pytest.mark.parametrize("closed", [">&-", "<&- >&- 2>&-"])
def test_a_command_runs_with_its_streams_closed(run, tmp_path, closed):
    done = run(redirected=closed)
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == ("" if "2" in closed else "wrote drops.json\n")
    assert (tmp_path / "drops.json").stat().st_size > 1000


def test_a_sign_that_the_terminal_lacks_stops_no_table(run):
    done = run(environment={"PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stderr) == (0, "wrote drops.json\n")
    assert r"\xb1 is one standard error" in done.stdout


def test_a_terminal_that_says_it_has_no_width_is_shown_all(run):
    done = run(environment={"COLUMNS": "0"})
    assert (done.returncode, done.stderr) == (0, "wrote drops.json\n")
    assert "is one standard error" in done.stdout
