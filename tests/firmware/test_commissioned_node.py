"""The firmware on an emulated Cortex-M0, commissioned over its serial line by `exoid node`."""

from contextlib import contextmanager
from pathlib import Path

import can
import numpy as np
import pytest
from command_line import Command
from emulated_node import SERIAL, Samples, emulated_node

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.decode import raw_values
from exoid.recordings.commissioning.commands import SET_ZERO, command
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.loading.can_log import read_can_log
from live_node import NO_WAIT

COUNT = 1000  # of the encoder, whose knee stands still
MIDDLE = 2048  # the count that is sent for 0 rad


@contextmanager
def still_node(flash: Path):
    """A node that is turned on, with what this flash holds."""
    nothing = np.zeros((1, 3), int)
    with emulated_node(Samples(np.array([COUNT]), nothing, nothing, np.zeros(1, int)), flash) as at:
        yield at


@pytest.fixture
def flash(tmp_path):
    folder = tmp_path / "flash"
    folder.mkdir()
    return folder


@pytest.fixture
def exoid(tmp_path, monkeypatch):
    """The command, as a user calls it; an emulator needs no time to start."""
    monkeypatch.setenv("CAN_CONFIG", '{"sleep_after_open": 0}')
    command = Command(tmp_path)

    def called(*arguments) -> str:
        done = command(*arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return called


def count_sent(channel: str, node: int = 0) -> int:
    """The encoder's count of the third EXO_RAW that comes of this node."""
    plan = exoid_messages()["EXO_RAW"]
    bus = LiveBus(BusAddress("slcan", channel, 500_000, NO_WAIT), lambda _: None)
    found = []
    try:
        while len(found) < 3:
            message = bus.receive()
            if message is not None and message.arbitration_id == plan.identifier + 16 * node:
                found.append(np.frombuffer(bytes(message.data), np.uint8).reshape(1, 8))
    finally:
        bus.close()
    return int(raw_values(found[-1], plan.signal("Angle"))[0])


def test_a_zero_that_is_set_moves_the_frames_and_survives_a_reset(exoid, flash):
    with still_node(flash) as channel:
        assert f"serial {SERIAL:08X}" in exoid("node", "show", "--channel", channel)
        assert count_sent(channel) == COUNT
        said = exoid("node", "zero", "--channel", channel)
        assert f"the zero was 2048 and is {COUNT}" in said
        assert count_sent(channel) == MIDDLE
    with still_node(flash) as channel:
        assert count_sent(channel) == MIDDLE
        assert f"zero {COUNT}" in exoid("node", "show", "--channel", channel)
    (flash / "slot0.bin").write_bytes(b"")
    with still_node(flash) as channel:
        assert count_sent(channel) == COUNT  # the settings are in the flash and nowhere else


def test_direction_and_id_that_are_set_survive_a_reset(exoid, flash):
    with still_node(flash) as channel:
        exoid("node", "set", "--channel", channel, "--direction", "falls", "--id", 3)
        exoid("node", "zero", "--channel", channel, "--angle", -90)
    with still_node(flash) as channel:
        said = exoid("node", "find", "--channel", channel).splitlines()[1].split()
        assert said[:5] == ["3", f"{SERIAL:08X}", "0.1.0", str((COUNT - 1024) % 4096), "falls"]
        assert count_sent(channel, node=3) == 1024  # a quarter of a turn below the extended knee


def test_a_write_that_was_cut_leaves_the_settings_before_it(exoid, flash):
    with still_node(flash) as channel:
        exoid("node", "zero", "--channel", channel)
        exoid("node", "zero", "--channel", channel, "--angle", 90)
        assert count_sent(channel) == 3072
    newer = flash / "slot1.bin"
    newer.write_bytes(newer.read_bytes()[:-1])
    with still_node(flash) as channel:
        assert count_sent(channel) == MIDDLE


def test_a_change_in_a_recording_is_told_by_its_log(exoid, flash, tmp_path):
    path = tmp_path / "leg.blf"
    with still_node(flash) as channel:
        bus = LiveBus(BusAddress("slcan", channel, 500_000, NO_WAIT), lambda _: None)
        with can.BLFWriter(path) as log:
            frames = 0
            while frames < 900:
                message = bus.receive()
                if message is not None:
                    log.on_message_received(message)
                    frames += 1
                    if frames == 600:
                        bus.send(command(SET_ZERO, SERIAL, Angle=0.0))
        bus.close()
    recording, quality = read_can_log(path)
    first, change = quality.commissioned
    assert first == "node 0: zero 2048, the encoder's count rises in extension, firmware 0.1.0"
    assert change.startswith(f"the zero from 2048 to {COUNT} was changed in the recording, at ")
    at = float(change.partition(", at ")[2].partition(" s")[0])
    angle = recording.segments[0].raw_angle
    assert angle is not None
    known = np.isfinite(angle)  # the log may end before the last tick's frames are whole
    jump = recording.segments[0].time[known][np.flatnonzero(np.diff(angle[known]))]
    assert jump == pytest.approx([at], abs=0.05)  # settings come within three ticks of the change
