"""`exoid live` of files: what it says of a leg, when it ends, and what it does not say."""

import json
import time

import numpy as np
import pytest
from command_line import refusal
from live_runs import LIKELY, as_sent, near_truth, rows_of
from sessions import LEG, TWO_DROPS, session, write_frames

from exoid.cli.inputs.reading import EXAMPLE
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.splitting.split import split


@pytest.fixture(scope="module")
def drops():
    return session(*TWO_DROPS)


@pytest.fixture(scope="module")
def log(drops, tmp_path_factory):
    """Two drops, as a log with its sidecar."""
    path = tmp_path_factory.mktemp("live") / "two.blf"
    return write_frames(as_sent(drops), drops, path)


def test_a_log_is_followed_to_its_end(command, log, tmp_path):
    done = command("live", log, "--json-lines", tmp_path / "rows.jsonl")
    assert done.returncode == 0, done.stderr
    first, *table = done.stdout.splitlines()
    assert "2 drops so far" in first
    assert table[0].startswith("gravity over inertia")
    assert "±" in table[0]
    rows = rows_of(tmp_path / "rows.jsonl")
    times = np.array([each["time_s"] for each in rows])
    np.testing.assert_allclose(np.diff(times), 0.1, atol=0.0101)  # a sample comes every 10 ms
    near_truth(rows[-1]["ratios"])
    assert rows[-1]["state"]["drops"] == 2
    assert rows[-1]["absolute"] == {}  # motion alone does not tell it
    assert {each["unit"] for each in rows[-1]["ratios"].values()} == {"1/s^2", "1/s"}


def test_a_table_is_followed_too(command, drops, tmp_path):
    write_table(split(drops), tmp_path / "two.csv")
    done = command("live", tmp_path / "two.csv", "--json-lines", tmp_path / "rows.jsonl")
    assert done.returncode == 0, done.stderr
    assert "faulty" not in done.stderr  # the pause between two segments is none of the stream
    near_truth(rows_of(tmp_path / "rows.jsonl")[-1]["ratios"])


def test_lines_for_another_program_have_stdout_to_themselves(command, log):
    done = command("live", log, "--json-lines", "-")
    assert done.returncode == 0, done.stderr
    assert [json.loads(each)["trust"] for each in done.stdout.splitlines()]
    assert "gravity over inertia" in done.stderr


def test_a_goal_that_is_reached_ends_it_with_0(command, log, tmp_path):
    options = ("--until", "gravity_over_inertia=1%", "--until", "damping_over_inertia=0.1")
    done = command("live", log, *options, "--json-lines", tmp_path / "rows.jsonl")
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == (
        "enough: gravity_over_inertia=1%, damping_over_inertia=0.1 is reached"
    )
    assert rows_of(tmp_path / "rows.jsonl")[-1]["state"]["drops"] == 1


def test_a_goal_that_is_not_reached_ends_it_with_1_and_a_sentence(command, log):
    done = command("live", log, "--until", "inertia=2%")
    assert done.returncode == 1
    assert done.stdout.splitlines()[-1] == "not enough yet: inertia=2%: it is not known"


def test_the_bundled_example_tells_what_it_was_simulated_with(command, tmp_path):
    done = command("live", EXAMPLE, "--until", "inertia=2%", "--json-lines", tmp_path / "rows")
    assert done.returncode == 0, done.stderr
    known = rows_of(tmp_path / "rows")[-1]
    near_truth(known["ratios"])
    inertia = known["absolute"]["inertia"]
    assert abs(inertia["value"] - LEG["inertia"]) < LIKELY * inertia["standard_error"]


@pytest.mark.slow
def test_it_agrees_with_the_fit_of_the_example(command, tmp_path):
    document = command.document(EXAMPLE, "--multistart", 8, folder=tmp_path)
    command("live", EXAMPLE, "--json-lines", tmp_path / "rows")
    for name, live in rows_of(tmp_path / "rows")[-1]["ratios"].items():
        fit = document["ratios"][name]
        apart = abs(live["value"] - fit["value"])
        assert apart < 3 * np.hypot(live["standard_error"], fit["standard_error"]), name


def test_dry_friction_is_estimated_where_it_is_asked_for(command, log, tmp_path):
    done = command("live", log, "--with", "coulomb_friction", "--json-lines", tmp_path / "rows")
    assert done.returncode == 0, done.stderr
    terms = rows_of(tmp_path / "rows")[-1]["terms"]
    level = terms["coulomb_friction.level_over_inertia"]
    assert abs(level["value"]) < LIKELY * level["standard_error"]  # there is none


def test_at_its_own_pace_a_file_takes_its_time(command, log):
    begin = time.monotonic()
    done = command("live", log, "--speed", 4, "--until", "gravity_over_inertia=1%", "--no-refine")
    assert done.returncode == 0, done.stderr
    assert time.monotonic() - begin > float(done.stdout.split()[0]) / 4 - 0.1


def test_two_nodes_of_one_id_are_told_and_no_number_is(command, drops, tmp_path):
    other = [
        (at + 0.002, identifier, data) for at, identifier, data in as_sent(session(*TWO_DROPS[:1]))
    ]
    mixed = []
    for at, identifier, data in other:
        turned = bytearray(data)
        if identifier == 0x101:
            turned[6] = (turned[6] + 100) % 256  # a counter of its own
        mixed.append((at, identifier, bytes(turned)))
    sent = sorted(as_sent(drops) + mixed, key=lambda each: each[0])
    path = write_frames(sent, drops, tmp_path / "two.blf")
    done = command("live", path, "--json-lines", tmp_path / "rows")
    assert done.returncode == 1
    assert "two nodes send with the same ids" in done.stdout.splitlines()[0]
    assert "±" not in done.stdout
    assert len(rows_of(tmp_path / "rows")) < 10


def test_firmware_that_means_something_else_tells_no_number(command, drops, tmp_path):
    path = write_frames(as_sent(drops, config_crc=0xBEEF), drops, tmp_path / "other.blf")
    assert "ConfigCrc 0xBEEF" in refusal(command("live", path))
