"""`exoid live` on a cable: recorded, stalled, pulled out, silent, and before a person."""

import signal
import subprocess
import sys
import time

import can
import pytest
from command_line import HEEDING, LIMIT, SCRIPT
from live_runs import BODY, FAST, LIKELY, READY, as_sent, rows_of
from sessions import RATIOS, TWO_DROPS, session
from test_record_command import terminal

from live_node import Cable


@pytest.fixture(scope="module")
def drops():
    return session(*TWO_DROPS)


@pytest.fixture
def cable(tmp_path):
    made = Cable(tmp_path / "port")
    yield made
    made.pull_out()


@pytest.fixture
def start(command, cable):
    """`exoid live` on the cable."""
    environment = command.environment | {"CAN_CONFIG": '{"sleep_after_open": 0}'}
    running = []

    def started(*options, **streams) -> subprocess.Popen[str]:
        arguments = ("live", "--channel", cable.path, *BODY, *options)
        process = subprocess.Popen(
            [sys.executable, "-c", HEEDING, SCRIPT, *map(str, arguments)],
            env=environment,
            stdout=subprocess.PIPE,
            text=True,
            **{"stdin": subprocess.DEVNULL, "stderr": subprocess.PIPE, **streams},
        )
        running.append(process)
        return process

    yield started
    for process in running:
        process.kill()
        process.communicate()


def messages(sent) -> list[can.Message]:
    return [
        can.Message(timestamp=at, arbitration_id=identifier, is_extended_id=False, data=data)
        for at, identifier, data in sent
    ]


def test_a_leg_on_a_cable_is_recorded_and_its_replay_is_the_same(
    command, start, cable, drops, tmp_path
):
    rows = tmp_path / "live.jsonl"
    process = start("-o", tmp_path / "leg.blf", "--json-lines", rows, "--no-refine")
    cable.heard()
    cable.stream(messages(as_sent(drops)), FAST).join()
    cable.taken()
    wait_for(lambda: rows.exists() and 'drops": 2' in rows.read_text())
    process.send_signal(signal.SIGINT)
    said, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0, told
    assert f"next: exoid fit {tmp_path / 'leg.blf'}" in said
    assert "gravity over inertia" in said
    again = command("live", tmp_path / "leg.blf", "--json-lines", tmp_path / "again.jsonl")
    assert again.returncode == 0, again.stderr
    live, replayed = rows.read_text().splitlines(), (tmp_path / "again.jsonl").read_text()
    assert replayed.splitlines() == live


def wait_for(condition) -> None:
    end = time.monotonic() + READY
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.1)


def test_it_ends_by_itself_where_the_goal_is_reached(start, cable, drops):
    process = start("--until", "gravity_over_inertia=1%", "--no-refine")
    cable.heard()
    sending = cable.stream(messages(as_sent(drops)), FAST)
    said, told = process.communicate(timeout=LIMIT)
    cable.let_go(sending)
    assert process.returncode == 0, told
    assert said.splitlines()[-1] == "enough: gravity_over_inertia=1% is reached"
    assert not list(cable.path.parent.glob("*.blf"))  # nobody asked to keep it


def test_a_stream_that_stalls_bursts_and_comes_back_is_told_and_followed(
    start, cable, drops, tmp_path
):
    rows = tmp_path / "rows"
    process = start("--json-lines", rows, "--no-refine")
    cable.heard()
    sent = messages(as_sent(drops))
    cable.stream(sent[:1200], FAST).join()
    time.sleep(2.6)  # it stalls, and what it could not send comes at once
    cable.send(*sent[1200:1500])
    cable.taken()
    cable.pull_out()
    cable.plug_in()
    cable.heard()
    cable.stream(sent[1800:2400], FAST).join()
    cable.taken()
    wait_for(lambda: rows.exists() and '"time_s": 7' in rows.read_text())
    process.send_signal(signal.SIGTERM)
    _, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0, told
    assert "2 s without a frame of the node: it has fallen silent" in told
    assert "is gone" in told
    assert "is back" in told
    trusts = {each["trust"] for each in rows_of(rows)}
    assert "faulty" in trusts
    for each in rows_of(rows):
        for name, found in each["ratios"].items():
            if each["trust"] == "faulty":
                assert found["value"] is None
            else:
                assert abs(found["value"] - RATIOS[name]) < LIKELY * found["standard_error"]


def test_a_silent_bus_is_named(start):
    process = start("--duration", 2.5)
    said, told = process.communicate(timeout=LIMIT)
    assert (process.returncode, said) == (2, "")
    assert "nothing was heard from slcan" in told.splitlines()[-1]


def test_a_person_at_a_terminal_sees_a_panel(start, cable, drops):
    with terminal() as (_, program, read_until):
        process = start("--no-refine", stderr=program)
        cable.heard()
        cable.stream(messages(as_sent(drops)), FAST)
        read_until("moving freely")
        shown = read_until("1 drop so far")
        assert "exoid live" in shown
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=LIMIT)
    assert process.returncode == 0
    assert "stiffness over inertia" in said
