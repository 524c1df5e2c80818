"""The node on an emulated Cortex-M0, its sensors exposed to any motion, its slcan on a pty."""

import atexit
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from firmware_tools import QEMU, make, need

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.measured.segment import Segment

TURN = 4096  # counts
FULL_SCALE = (-32768, 32767)  # counts of a 16-bit register
SERIAL = 0xC0FFEE02  # of the emulated board
PACE = ("-icount", "shift=4")  # 16 ns an instruction: a busy machine makes it late, not lossy
STARTING = 10.0  # s within which QEMU names its pty
PTY = re.compile(rb"char device redirected to (\S+)")

ENCODER_SILENT, IMU_SILENT, MAGNET_MISSING, MAGNET_WEAK, MAGNET_STRONG, IMU_RESET = (
    1 << bit for bit in range(6)
)


@dataclass(frozen=True, eq=False)
class Samples:
    """What the chips' registers show at each tick, along their own axes: positive y is flexion."""

    count: np.ndarray  # time; AS5600, 0..4095
    gyro: np.ndarray  # time, axis; counts of 70 mdps
    accel: np.ndarray  # time, axis; counts of 0.122 mg
    faults: np.ndarray  # time; bits above

    def stream(self) -> bytes:
        """The records that the emulated node reads, one a tick."""
        columns = (self.count, self.faults, *self.gyro.T, *self.accel.T)
        return np.stack(columns, axis=1).astype("<i4").astype("<u2").tobytes()


def samples_of(log: Segment) -> Samples:
    """The registers behind a log's raw channels; where the encoder has none, it is silent."""
    assert log.raw_angle is not None
    size = log.time.size
    lost = np.isnan(log.raw_angle)
    count = counts("EXO_RAW", "Angle", np.where(lost, 0.0, log.raw_angle)) % TURN
    gyro, accel = np.zeros((size, 3), int), np.zeros((size, 3), int)
    gyro[:, 1] = -counts("EXO_RAW", "GyroY", log.raw_angular_velocity)
    accel[:, 0] = counts("EXO_ACC", "AccelX", log.raw_acceleration_x)
    accel[:, 2] = counts("EXO_ACC", "AccelZ", log.raw_acceleration_z)
    limited = (np.clip(each, *FULL_SCALE) for each in (gyro, accel))
    return Samples(count, *limited, np.where(lost, ENCODER_SILENT, 0))


def counts(message: str, signal: str, values) -> np.ndarray:
    """Values in their unit as the counts that exoid.dbc gives them."""
    plan = exoid_messages()[message].signal(signal)
    return np.rint((np.asarray(values) - plan.offset) / plan.scale).astype(int)


@contextmanager
def emulated_node(samples: Samples, flash: Path | None = None) -> Iterator[str]:
    """Runs the firmware at 100 Hz of real time; gives the pty on which it talks slcan.

    The motion begins when the host opens the channel, with the filter at its start, and stays at
    its last sample. QEMU may take a second to notice a host. Leaving ends the emulator, which the
    host sees as a device that is unplugged. Settings are kept in the folder `flash`.
    """
    need("qemu-system-arm")
    with tempfile.TemporaryDirectory() as own:
        folder = str(flash or own)
        Path(folder, "samples.bin").write_bytes(samples.stream())
        Path(folder, "board.bin").write_bytes(SERIAL.to_bytes(4, "little"))
        for slot in ("slot0.bin", "slot1.bin", "slot2.bin"):
            Path(folder, slot).touch()
        with Path(folder, "qemu.log").open("wb") as said:
            command = [*QEMU, *PACE, "-serial", "pty", "-kernel", image()]
            emulator = subprocess.Popen(
                command, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said
            )
        try:
            yield pty_of(emulator, Path(folder, "qemu.log"))
        finally:
            emulator.terminate()
            emulator.wait(timeout=10)


def pty_of(emulator: subprocess.Popen, log: Path) -> str:
    """The name of the emulator's pty, once it has told it."""
    end = time.monotonic() + STARTING
    while time.monotonic() < end and emulator.poll() is None:
        if found := PTY.search(log.read_bytes()):
            return found[1].decode()
        time.sleep(0.01)
    raise RuntimeError(f"QEMU names no pty: {log.read_text()}")


@cache
def image() -> Path:
    """The firmware for the emulated board, made once in a run of the tests."""
    folder = Path(tempfile.mkdtemp(prefix="exoid-firmware-"))
    atexit.register(shutil.rmtree, folder)
    return make("m0_node.elf", folder)
