"""`exoid live`: what it says of a leg while it moves, from a cable or from a file."""

import json
import os
import signal
import subprocess
import sys
import time

import can
import numpy as np
import pytest
from command_line import HEEDING, LIMIT, SCRIPT, refusal
from sessions import EPOCH, LEG, RATIOS, TWO_DROPS, session, write_frames
from test_record_command import terminal

from exoid.cli.inputs.reading import EXAMPLE
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.motion.split import split
from live_node import Cable
from node_frames import frames

FAST = 1000.0  # frames/s; the node itself sends 310
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
BODY = ("--body-mass", 74, "--height", 1.78)
READY = 60.0  # s in which the estimator is compiled on a busy machine


def as_sent(recording, **options):
    """The frames of a session, as the node sends them."""
    given = {"epoch": EPOCH, "jitter": 0.0, "config_crc": config_crc(), **options}
    return list(frames(recording.segments[0], np.random.default_rng(3), **given))


@pytest.fixture(scope="module")
def drops():
    return session(*TWO_DROPS)


@pytest.fixture(scope="module")
def log(drops, tmp_path_factory):
    """Two drops, as a log with its sidecar."""
    path = tmp_path_factory.mktemp("live") / "two.blf"
    return write_frames(as_sent(drops), drops, path)


def rows_of(path) -> list[dict]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def near_truth(ratios: dict) -> None:
    for name, truth in RATIOS.items():
        found = ratios[name]
        assert abs(found["value"] - truth) < LIKELY * found["standard_error"], name


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


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "give a recording to follow, or --channel of a bus: neither is given"),
        (["leg.blf", "--channel", "x"], "both are given"),
        (["leg.blf", "-o", "other.blf"], "-o is of a bus"),
        (["leg.blf", "--duration", "3"], "--duration is of a bus"),
        (["--channel", "x", "--flip", "all"], "--flip is of a recording"),
        (["leg.blf", "--speed", "fast"], "--speed fast: give a number such as 1 or 2.5, or max"),
        (["leg.blf", "--speed", "0"], "--speed 0"),
        (["leg.blf", "--speed", "inf"], "--speed inf"),
        (["leg.blf"], "leg.blf: No such file or directory"),
        (["leg.blf", "--until", "weight=2%"], "--until weight=2%: there is no 'weight'"),
        (["leg.blf", "--until", "inertia=1%", "--until", "inertia=2%"], "names a quantity twice"),
        (["leg.blf", "--with", "friction"], "there is no such term"),
        (["leg.blf", "--with", "hysteresis"], "it has a memory of its own"),
        (["leg.blf", "--with", "gyro_bias"], "it is estimated in any case"),
        (["leg.blf", "--with", "stiffness_rest_angle"], "cannot be estimated live"),
        (["leg.blf", "--with", "coulomb_friction=0.1"], "Name it alone"),
        (["leg.blf", "--json-lines", "nowhere/rows"], "the folder nowhere does not exist"),
        (["leg.blf", "--body-mass", "7700"], "--body-mass is 7700 kg"),
        (["--channel", "x", "--added-mass-distance", "0.4"], "without --added-mass"),
        (["--channel", "x", "-o", "leg.csv"], "a recording ends in .blf"),
        (["--channel", "x", "--segment"], "the standard input is no terminal"),
        (["--channel", "no-port"], "slcan no-port cannot be opened"),
        (["--channel", "x", "--port", "70000"], "'--port'"),
    ],
)
def test_an_absurd_option_is_refused(command, tmp_path, options, said):
    done = command("live", *options, cwd=tmp_path)
    assert said in refusal(done)
    assert not list(tmp_path.iterdir())


def test_what_is_there_is_not_replaced(command, log, tmp_path):
    (tmp_path / "rows").write_text("old")
    done = command("live", log, "--json-lines", tmp_path / "rows")
    assert "exists. Name another file, or replace it with --force" in refusal(done)
    assert (tmp_path / "rows").read_text() == "old"


def test_a_page_without_its_packages_is_refused_in_one_line(command, log, monkeypatch):
    from exoid.files import extras

    found = extras.find_spec
    monkeypatch.setattr(
        extras, "find_spec", lambda name: None if name == "uvicorn" else found(name)
    )
    done = command("live", log, "--serve")
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1] == (
        'exoid: a page is served by uvicorn, which is missing: pip install "exoid[live]"'
    )


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
    cable.stream(messages(as_sent(drops)), FAST).join()
    said, told = process.communicate(timeout=LIMIT)
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
    assert os.linesep not in said[:1]
