"""`exoid record`: from a serial cable to a log that `exoid fit` reads, whatever ends it."""

import json
import os
import pty
import select
import signal
import subprocess
import sys
import time
import tomllib
from contextlib import contextmanager

import can
import numpy as np
import pytest
from command_line import HEEDING, LIMIT, SCRIPT
from sessions import EPOCH, RATIOS, TWO_DROPS, session

from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.loading.can_log import read_can_log
from live_node import Cable
from node_frames import frames

FAST = 1000.0  # frames/s; the node itself sends 310
NODE = 310.0  # frames/s
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
BODY = ("--body-mass", 74, "--height", 1.78)


@pytest.fixture(scope="module")
def sent():
    """Two drops, as the node sends them."""
    log = session(*TWO_DROPS).segments[0]
    generator = np.random.default_rng(3)
    return [
        can.Message(timestamp=at, arbitration_id=identifier, is_extended_id=False, data=data)
        for at, identifier, data in frames(
            log, generator, epoch=EPOCH, jitter=0.0, config_crc=config_crc()
        )
    ]


@pytest.fixture
def cable(tmp_path):
    made = Cable(tmp_path / "port")
    yield made
    made.pull_out()


@pytest.fixture
def start(command, cable, tmp_path):
    """`exoid record` on the cable, with its port open; it writes NAME in a folder of its own."""
    environment = command.environment | {"CAN_CONFIG": '{"sleep_after_open": 0}'}
    running = []

    def started(name: str, *options, **streams) -> subprocess.Popen[str]:
        options = ("--channel", cable.path, "-o", tmp_path / name, *options)
        process = subprocess.Popen(
            [sys.executable, "-c", HEEDING, SCRIPT, "record", *map(str, options)],
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


@pytest.mark.proof
def test_a_thousand_frames_a_second_are_recorded_without_a_loss_and_fitted(
    command, start, cable, sent, tmp_path
):
    process = start("leg.blf", *BODY, "--note", "bare leg")
    cable.heard()
    begin = time.monotonic()
    cable.stream(sent, FAST).join()
    assert len(sent) / (time.monotonic() - begin) > 0.8 * FAST
    cable.taken()
    process.send_signal(signal.SIGINT)
    said, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0, told
    assert f"{len(sent)} frames" in said.splitlines()[0]
    assert said.splitlines()[-1] == f"next: exoid fit {tmp_path / 'leg.blf'}"
    assert [row.tobytes() for row in read_log(tmp_path / "leg.blf").frames.data] == [
        bytes(m.data) for m in sent
    ]
    done = command("fit", tmp_path / "leg.blf", "--strict", "--json", tmp_path / "fit.json")
    assert done.returncode == 0, done.stderr
    document = json.loads((tmp_path / "fit.json").read_text())
    assert "74 kg and 1.78 m" in document["fit"]["prior"]
    for name, truth in RATIOS.items():
        found = document["ratios"][name]
        assert abs(found["value"] - truth) < LIKELY * found["standard_error"]


def test_a_killed_recording_has_lost_less_than_a_second(start, cable, sent, tmp_path):
    process = start("leg.blf", *BODY)
    cable.heard()
    begin = time.monotonic()
    cable.stream(sent, NODE)
    time.sleep(2.3)
    process.kill()
    passed = time.monotonic() - begin
    recording, quality = read_can_log(tmp_path / "leg.blf")
    assert recording.segments[0].time[-1] > passed - 1.0
    assert quality.gaps == ()
    assert tomllib.loads((tmp_path / "leg.toml").read_text())["subject"]["body_mass_kg"] == 74


def test_a_recording_ends_by_itself_after_its_duration(start, cable, sent, tmp_path):
    process = start("leg.log", "--duration", 1)
    cable.heard()
    cable.stream(sent, NODE)
    said, _ = process.communicate(timeout=LIMIT)
    assert process.returncode == 0
    assert read_can_log(tmp_path / "leg.log")[0].segments[0].time[-1] == pytest.approx(1, abs=0.1)
    assert "--body-mass KG --height M" in said  # nobody has said whose leg it is


@contextmanager
def terminal():
    """A terminal with somebody before it: what was shown is collected, keys can be pressed."""
    person, program = pty.openpty()
    shown = []

    def read_until(text: str) -> str:
        while text not in "".join(shown):
            ready, _, _ = select.select([person], [], [], LIMIT)
            assert ready, f"{text!r} did not come after {''.join(shown)[-300:]!r}"
            shown.append(os.read(person, 10_000).decode(errors="replace"))
        return "".join(shown)

    yield person, program, read_until
    os.close(person)
    os.close(program)


def test_a_person_at_a_terminal_is_asked_sees_the_motion_and_marks_it(start, cable, sent, tmp_path):
    with terminal() as (person, program, read_until):
        process = start("leg.blf", "--segment", "--height", 1.78, stdin=program, stderr=program)
        for question, answer in (("Body mass", b"seven\n74\n"), ("Mass added", b"\n")):
            read_until(question)
            os.write(person, answer)
        read_until("keys: d")
        cable.stream(sent, NODE)
        read_until("deg/s")
        os.write(person, b"d")
        assert "[drop 1]" in read_until("[drop 1]")
        time.sleep(1.0)
        os.write(person, b"c")
        assert "[cycle 2]" in read_until("[cycle 2]")
        time.sleep(0.6)
        os.write(person, b" ")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=LIMIT) == 0
    known = tomllib.loads((tmp_path / "leg.toml").read_text())
    assert known["subject"] == {"body_mass_kg": 74.0, "height_m": 1.78}
    assert known["protocol"]["kind"] == ["passive", "active"]
    (first, second), (cut, end) = (
        known["protocol"][f"segment_{each}_s"] for each in ("start", "end")
    )
    assert second == cut
    assert cut - first == pytest.approx(1.0, abs=0.4)  # keys are looked at ten times a second
    assert end - second == pytest.approx(0.6, abs=0.4)


def test_a_key_before_the_first_frame_is_answered_and_marks_nothing(start, cable, sent, tmp_path):
    with terminal() as (person, program, read_until):
        process = start("leg.log", *BODY, "--segment", stdin=program, stderr=program)
        read_until("Mass added")
        os.write(person, b"\n")
        read_until("keys: d")
        os.write(person, b"xd")
        time.sleep(1.0)  # keys are looked at ten times a second
        cable.stream(sent, NODE)
        said = " ".join(read_until("deg/s").split())
        assert "'d' marks nothing: no frame has come yet. Press it again" in said
        assert "'x'" not in said
        os.write(person, b"d")
        read_until("[drop 1]")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=LIMIT) == 0
    known = tomllib.loads((tmp_path / "leg.toml").read_text())
    assert len(known["protocol"]["segment_start_s"]) == 1


def test_a_silent_bus_is_named_and_leaves_nothing_behind(start, cable, tmp_path):
    process = start("leg.blf", "--duration", 2.5)
    said, told = process.communicate(timeout=LIMIT)
    assert (process.returncode, said) == (2, "")
    assert "2 s without a frame of the node: nothing comes" in told
    assert "nothing was recorded" in told.splitlines()[-1]
    assert [each.name for each in tmp_path.iterdir()] == [cable.path.name]


def test_a_pulled_cable_does_not_end_a_recording(start, cable, sent, tmp_path):
    process = start("leg.blf")
    cable.heard()
    cable.stream(sent[:310], FAST).join()
    cable.taken()
    cable.pull_out()
    cable.plug_in()
    cable.heard()
    cable.stream(sent[930:1240], FAST).join()
    cable.taken()
    process.send_signal(signal.SIGTERM)
    said, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0
    assert "is gone" in told
    assert "is back" in told
    assert "gap of 2.0" in said
    assert len(read_log(tmp_path / "leg.blf").frames) == 620


def test_a_full_disk_is_named_in_the_last_line(start, cable, sent, tmp_path):
    (tmp_path / "leg.blf").symlink_to("/dev/full")
    process = start("leg.blf", "--force")
    cable.heard()
    cable.stream(sent, NODE)
    said, told = process.communicate(timeout=LIMIT)
    assert (process.returncode, said) == (2, "")
    assert "No space left on device" in told.splitlines()[-1]


def test_a_terminal_that_goes_away_does_not_end_a_recording(start, cable, sent, tmp_path):
    with terminal() as (person, program, read_until):
        process = start(
            "leg.blf", *BODY, "--segment", stdin=program, stderr=program, start_new_session=True
        )
        read_until("Mass added")
        os.write(person, b"\n")
        read_until("keys: d")
        cable.stream(sent[:310], NODE).join()
        read_until("deg/s")
    process.send_signal(signal.SIGHUP)  # what a kernel sends when the connection drops
    time.sleep(0.5)
    cable.stream(sent[310:620], NODE).join()
    cable.taken()
    assert process.poll() is None
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=LIMIT) == 0
    assert len(read_log(tmp_path / "leg.blf").frames) == 620


def test_a_pipe_that_nobody_reads_any_more_does_not_end_a_recording(start, cable, sent, tmp_path):
    process = start("leg.blf", *BODY)
    cable.heard()
    process.stderr.close()
    process.stdout.close()
    cable.stream(sent[:310], NODE).join()
    cable.taken()
    cable.pull_out()  # which would be told
    cable.plug_in()
    cable.heard()
    cable.stream(sent[310:620], NODE).join()
    cable.taken()
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=LIMIT) == 0
    assert len(read_log(tmp_path / "leg.blf").frames) == 620


def test_a_sidecar_that_appeared_meanwhile_is_told_and_stays(start, cable, sent, tmp_path):
    process = start("leg.blf", *BODY)
    cable.heard()
    (tmp_path / "leg.toml").write_text("# another's\n")
    cable.stream(sent[:310], NODE).join()
    cable.taken()
    process.send_signal(signal.SIGINT)
    said, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0, told
    assert f"{tmp_path / 'leg.toml'} was written by another meanwhile and stays" in told
    assert (tmp_path / "leg.toml").read_text() == "# another's\n"
    beside = tomllib.loads((tmp_path / "leg.recorded.toml").read_text())
    assert beside["subject"]["body_mass_kg"] == 74
    assert "leg.recorded.toml" in said


def test_a_sidecar_that_cannot_be_written_is_told_and_the_recording_goes_on(
    start, cable, sent, tmp_path
):
    process = start("leg.blf", *BODY)
    cable.heard()
    (tmp_path / "leg.toml").mkdir()
    cable.stream(sent[:310], NODE).join()
    cable.taken()
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=LIMIT)
    assert process.returncode == 0, told
    assert f"the sidecar cannot be written: {tmp_path / 'leg.toml'}" in told
    assert len(read_log(tmp_path / "leg.blf").frames) == 310
