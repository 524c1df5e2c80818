"""Damaged files of every format end in one sentence, a report or their own rows; and a reader that
does otherwise is found.
"""

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from mmap import mmap
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.fuzz import judge, worker
from tests.fuzz.here import in_this_process
from tests.fuzz.judge import ALONE, FAULT, HANG, NAMES, PLAIN, SAME, TOLD, WRONG, format_of, mutant
from tests.fuzz.reading import Reading, Unread

ROOT = Path(__file__).parents[2]
EACH = [50, pytest.param(150, marks=pytest.mark.proof)]  # mutants of each format


def run(*arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    places = os.pathsep.join([str(ROOT), *sys.path])
    call = [sys.executable, "-m", "tests.fuzz", *arguments]
    return subprocess.run(
        call, cwd=folder, env=os.environ | {"PYTHONPATH": places}, capture_output=True, text=True
    )


@pytest.mark.slow
@pytest.mark.parametrize("each", EACH)
def test_damaged_files_of_every_format_are_read_as_they_should_be(tmp_path, each):
    done = run("--mutants", str(each), "--minutes", "10", folder=tmp_path)
    kept = (tmp_path / "fuzz-failures.txt").read_text()
    assert done.returncode == 0, kept
    rows = {line[:11].strip(): line[11:].split() for line in done.stdout.strip().split("\n")[1:]}
    assert rows.keys() == {*NAMES, "all"}
    assert {int(rows[name][0]) for name in NAMES} == {each}
    assert [*map(int, rows["all"][-4:-1])] == [0, 0, 0]


def test_a_recipe_is_the_same_file_in_another_process(tmp_path):
    """Among them one that bytes changed, and one that hypothesis drew."""
    for name, number in (("can blf", 40), ("can asc", 41), ("other csv", 42), ("xlsx", 43)):
        path = tmp_path / "mutant"
        run("--replay", f"{name}:3:{number}", "--write", str(path), folder=tmp_path)
        assert path.read_bytes() == mutant(name, 3, number)[0]


def test_hypothesis_draws_a_share_of_the_files_whose_fields_it_knows(monkeypatch):
    asked = []

    def draw(strategy, chance):
        asked.append(strategy)
        return b"drawn"

    monkeypatch.setattr(judge, "drawn", draw)
    made = [mutant("own csv", 5, number)[0] for number in range(200)]
    # 60 of 200 are expected, with a standard deviation of 6.5
    assert 30 < made.count(b"drawn") == len(asked) < 90
    assert [mutant("npz", 5, number)[0] for number in range(20)].count(b"drawn") == 0


@pytest.mark.parametrize("name", [name for name in NAMES if format_of(name).drawn is not None])
@settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_a_file_with_other_fields_is_read_as_it_should_be(tmp_path, name, data):
    """What fails here is the smallest such file."""
    which = data.draw(st.integers(0, len(format_of(name).samples) - 1))
    content = data.draw(judge.strategy_of(name, which))
    with in_this_process(mmap(-1, 1)):
        found = judge.verdict(name, content, which, tmp_path)
    assert found.kind not in judge.FAILED, found.why


# A reader that does what none should is found


@pytest.fixture
def reader(monkeypatch):
    """Puts another reader in the place of that of python-can's CSV."""
    made = format_of("can csv")
    rows = {"a": np.arange(3.0)}

    def put(read, **changes):
        first = []

        def sound_first(path):
            if not first:
                first.append(path)
                return Reading(rows, ())
            return read(path)

        changed = replace(made, samples=made.samples[:1], read=sound_first, **changes)
        monkeypatch.setattr(judge, "format_of", lambda _: changed)
        judge.original.cache_clear()

    yield put
    judge.original.cache_clear()


def broken(path):
    raise KeyError("no such block")


def talkative(path):
    raise ValueError("two\nlines")


def exhausted(path):
    raise MemoryError


def other_rows(path):
    return Reading({"a": np.arange(4.0)}, ())


def told_rows(path):
    return Reading({"a": np.arange(4.0)}, ("one is missing",))


@pytest.mark.parametrize(
    ("read", "kind"),
    [
        (broken, FAULT),
        (talkative, FAULT),
        (exhausted, HANG),
        (other_rows, WRONG),
        (told_rows, TOLD),
    ],
)
def test_what_a_reader_should_not_do_is_found(reader, tmp_path, read, kind):
    reader(read, oracle=lambda path, sample: {"a": np.arange(5.0)})
    assert judge.judged("can csv", 0, 1, tmp_path).kind == kind


def test_rows_that_an_oracle_reads_too_are_what_nobody_can_tell(reader, tmp_path):
    reader(other_rows, oracle=lambda path, sample: {"a": np.arange(4.0)})
    assert judge.judged("can csv", 0, 1, tmp_path).kind == PLAIN
    reader(lambda path: Reading({"a": np.arange(3.0)}, ()), oracle=None)
    assert judge.judged("can csv", 0, 1, tmp_path).kind == SAME


def unread(path, sample):
    raise Unread("a kind that it does not know")


def strict(path, sample):
    raise KeyError("no such block")


@pytest.mark.parametrize(
    ("oracle", "stricter", "kind"),
    [(unread, False, ALONE), (strict, False, WRONG), (strict, True, ALONE)],
)
def test_rows_that_no_oracle_reads_are_counted_as_such(reader, tmp_path, oracle, stricter, kind):
    reader(other_rows, oracle=oracle, stricter=stricter)
    assert judge.judged("can csv", 0, 1, tmp_path).kind == kind


def looping(path):
    while True:
        pass


def dying(path):
    os._exit(3)


@pytest.mark.filterwarnings("ignore:.*fork")  # the copy reads two files and ends
@pytest.mark.parametrize(("read", "letter"), [(looping, b"H"), (dying, b"F")])
def test_a_reader_that_loops_or_dies_is_found_and_the_next_file_read(
    reader, tmp_path, monkeypatch, read, letter
):
    reader(read)
    monkeypatch.setattr(worker, "SECONDS", 0.1)
    letters = tmp_path / "letters"
    child = os.fork()
    if child == 0:
        monkeypatch.setattr(worker, "format_of", judge.format_of)
        worker.work("can csv", 0, 0, [60.0, 2], str(letters))
    assert os.waitpid(child, 0)[1] == 0
    assert letters.read_bytes() == 2 * letter


def test_an_oracle_that_loops_is_ended(monkeypatch):
    begin = time.monotonic()
    monkeypatch.setattr(judge, "PATIENCE", 0.1)
    with pytest.raises(TimeoutError), judge.asked():
        looping(None)
    assert time.monotonic() - begin < 30
    assert judge.ASKED[0] == 0  # the next to end is exoid again


def test_an_oracle_that_dies_does_not_count_against_exoid():
    judge.ASKED[0] = 1
    assert worker.ended(signal.SIGSEGV, False) == ALONE
    judge.ASKED[0] = 0
    assert worker.ended(signal.SIGSEGV, False) == FAULT
