"""The firmware on an emulated Cortex-M0 commands a torque, as `exoid node` lets it."""

import os
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from emulated_node import ENCODER_SILENT, SERIAL, Samples, emulated_node

from exoid.recordings.commissioning.commands import LOAD, command
from exoid.recordings.commissioning.dialogue import Dialogue
from exoid.recordings.commissioning.download import download
from exoid.recordings.commissioning.torque_host import ENABLE, ENABLED, Commanded, TorqueHost
from exoid.recordings.commissioning.torque_parameters import TorqueParameters, from_data
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress, CanBusError
from live_node import NO_WAIT

COUNT = 1500  # of the encoder: the knee is at -48 deg
ANGLE = (COUNT - 2048) * 2 * np.pi / 4096  # rad
LEG = TorqueParameters(8.0, 0.1, 2.0, 0.3, 0.2, 0.3, 0.5, 0.25, 1.0, 1.0, 5.0, 50.0)
SCRIPT = Path(sys.executable).with_name("exoid")
COUNTS = 1 / 1024  # N m, a count of the frame
TICK = 0.01  # s
LATE = 0.3  # s, of a busy machine
TRIES = 8  # on a busy machine a host is late, and the node goes by its own time
UNHEARD = "it did not hear this host"


@contextmanager
def node(flash: Path, faults: np.ndarray | None = None):
    """A node whose leg rests; `faults` befall it from when a host opens the channel, one a tick."""
    faults = np.zeros(1, int) if faults is None else faults
    nothing = np.zeros((faults.size, 3), int)
    with emulated_node(Samples(np.full(faults.size, COUNT), nothing, nothing, faults), flash) as at:
        yield at


@contextmanager
def talking(channel: str):
    bus = LiveBus(BusAddress("slcan", channel, 500_000, NO_WAIT))
    try:
        yield Dialogue(bus)
    finally:
        bus.close()


@pytest.fixture
def flash(tmp_path):
    folder = tmp_path / "flash"
    folder.mkdir()
    return folder


@pytest.fixture(autouse=True)
def patience(monkeypatch):
    monkeypatch.setattr("exoid.recordings.commissioning.torque_host.ARMING", 10.0)


def host_on(dialogue: Dialogue) -> TorqueHost:
    (there,) = dialogue.find()
    return TorqueHost(dialogue.bus, there, 5.0)


def enabled(host: TorqueHost, seconds: float) -> tuple[Commanded | None, list[Commanded]]:
    """What ended it, and all that was told."""
    ended, told = None, []
    for _ in range(TRIES):
        told.clear()
        host.arm()
        ended = host.enable(seconds, told.append)
        if ended is None or UNHEARD not in ended.doubts:
            break
    return ended, told


def test_what_is_downloaded_is_commanded_after_a_reset_too(flash):
    with node(flash) as channel, talking(channel) as dialogue:
        (there,) = dialogue.find()
        assert there.parameters is None
        held = download(dialogue, there, LEG)
        assert (held.values, held.stored) == (from_data(LEG.data), True)
    with node(flash) as channel, talking(channel) as dialogue:
        host = host_on(dialogue)
        ended, told = enabled(host, 0.6)
        assert ended is None
        host.stop()
    expected = 0.5 * 8.0 * np.cos(ANGLE + 0.1) + 0.25 * 2.0 * ANGLE
    assert told[-1].torque == pytest.approx(expected, abs=2 * COUNTS)  # and the filter's rounding
    steps = np.diff([0.0, *(each.torque for each in told)])
    assert np.abs(steps).max() <= LEG.rate_limit * TICK + COUNTS  # a tick's own, none was lost
    assert host.told is not None
    assert (host.told.torque, host.told.permit) == (0.0, 0)


def test_a_part_that_is_damaged_or_out_of_order_changes_nothing(flash):
    with node(flash) as channel, talking(channel) as dialogue:
        (there,) = dialogue.find()
        download(dialogue, there, LEG)
        for place in (3, 24):
            with pytest.raises(CanBusError, match="did not get the parameters in one piece"):
                dialogue.order(there, LOAD, Place=place, Data=0)
        damaged = command(LOAD, SERIAL, Place=0, Data=7)
        damaged.data[5] ^= 1
        dialogue.bus.send(damaged)
        (after,) = dialogue.find()
        assert after.parameters is not None
        assert after.parameters.values == from_data(LEG.data)


def test_parameters_that_are_damaged_in_flash_are_none(flash, monkeypatch):
    monkeypatch.setattr("exoid.recordings.commissioning.torque_host.ARMING", 3.0)  # in vain
    with node(flash) as channel, talking(channel) as dialogue:
        download(dialogue, dialogue.find()[0], LEG)
    slot = flash / "slot2.bin"
    kept = bytearray(slot.read_bytes())
    kept[20] ^= 0x10
    slot.write_bytes(kept)
    with (
        node(flash) as channel,
        talking(channel) as dialogue,
        pytest.raises(CanBusError, match=r"is not armed: .*it holds no whole parameters"),
    ):
        host_on(dialogue).arm()


def test_a_sensor_that_dies_cuts_the_torque_at_its_tick(flash):
    with node(flash) as channel, talking(channel) as dialogue:
        download(dialogue, dialogue.find()[0], LEG)
    faults = np.zeros(6000, int)
    faults[np.arange(6000) % 400 > 380] = ENCODER_SILENT  # every four seconds
    with node(flash, faults) as channel, talking(channel) as dialogue:
        host = host_on(dialogue)
        ended, told = enabled(host, 20.0)
        assert ended is not None
        assert ended.doubts[0] == "its encoder does not answer"
        torques = [each.torque for each in told]
        assert torques[-1] == 0.0
        assert abs(torques[-2]) > 1.0  # no ramp
        later = []
        host.keep_saying(ENABLE, 1.0, lambda now: later.append(now) is None)
        assert len(later) > 10
        assert not any(each.torque for each in later)  # though the encoder answers again
        _, again = enabled(host, 0.3)
        assert any(each.permit == ENABLED for each in again)


def test_a_host_that_is_killed_cuts_the_torque(flash, tmp_path):
    """The heartbeat ends with the process: the node's tenth tick behind it has no torque."""
    with node(flash) as channel:
        with talking(channel) as dialogue:
            download(dialogue, dialogue.find()[0], LEG)
            host = host_on(dialogue)
            _, told = enabled(host, 0.3)
            assert told[-1].permit == ENABLED
            last, after = time.monotonic(), []
            while time.monotonic() < last + 0.1 + LATE:
                heard = host.heard(dialogue.bus.receive())
                after += [] if heard is None else [heard]
            assert sum(each.permit == ENABLED for each in after) <= 10 + LATE / TICK
            assert (after[-1].torque, after[-1].permit) == (0.0, 0)
            assert after[-1].doubts == (UNHEARD,)
        killed(channel, tmp_path)
        with talking(channel) as dialogue:
            host, heard = host_on(dialogue), None
            while heard is None:
                heard = host.heard(dialogue.bus.receive())
            assert (heard.torque, heard.permit) == (0.0, 0)


def killed(channel: str, cache: Path) -> None:
    """The real command, killed once it has said a torque."""
    environment = os.environ | {
        "XDG_CACHE_HOME": str(cache),
        "CAN_CONFIG": '{"sleep_after_open": 0}',
    }
    asked = ("--enable", "--limit", "2", "--seconds", "60")
    for _ in range(TRIES):
        process = subprocess.Popen(
            [SCRIPT, "node", "torque", "--channel", channel, *asked],
            env=environment,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(3)]
        process.send_signal(signal.SIGKILL)
        process.wait(10)
        process.stdout.close()
        if lines[2].endswith(" N m\n"):
            break
    assert "is armed." in lines[0]
    assert lines[2].endswith(" N m\n")
