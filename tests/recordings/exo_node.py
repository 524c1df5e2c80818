"""The node as it appears on the bus: frames of exoid.dbc from a motion, with a clock of its own."""

from dataclasses import dataclass, field
from datetime import datetime
from functools import cache
from pathlib import Path
from unittest.mock import patch

import can
import cantools
import numpy as np

from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.can.node.config_crc import LEARNED, config_crc, learning_crc

EPOCH = 1_600_000_000.0  # s; when the host's clock began to log
FRAME = 0.00027  # s; one frame on a bus of 500 kbit/s
GYRO = 0.0012217304763960308  # rad/s per count


@cache
def codec():
    return cantools.database.load_file(EXOID_DBC)


def knee_angle(time):
    """A slow swing about the hanging leg [rad]."""
    return -np.pi / 2 + 0.9 * np.cos(3.0 * time)


def knee_velocity(time):
    return -2.7 * np.sin(3.0 * time)


@dataclass
class Node:
    """A node that runs at `skew` times the host's pace, its clock from `device_start` seconds.

    The motion it sees is in the host's time, which is the true one.
    """

    device_start: float = 12.34
    first_counter: int = 250
    skew: float = 1.0
    config_crc: int = field(default_factory=config_crc)
    jitter: float = 0.0015  # s, mean of the exponential delay of the host
    status: dict[int, dict[str, int]] = field(default_factory=dict)
    mountings: dict[int, tuple[int, int]] = field(default_factory=dict)  # by tick: zero, reversed
    node: int = 0
    serial: int = 0xC0FFEE01
    commissioned: int = 1

    def messages(self, ticks: int, begin: float = 0.0, seed: int = 0) -> list[can.Message]:
        """All frames of so many ticks, from `begin` seconds of host time."""
        rng = np.random.default_rng(seed)
        found = []
        for tick in range(ticks):
            for place, (name, values) in enumerate(self.frames(tick)):
                on_bus = begin + tick * 0.01 / self.skew + place * FRAME
                on_bus += 0.005 if name == "EXO_TIME" else 0.0
                delay = rng.exponential(self.jitter) if self.jitter else 0.0
                found.append(message(name, values, EPOCH + on_bus + delay, self.node))
        return found

    def frames(self, tick: int):
        """Names and values of the frames of one tick, as the node would send them."""
        time, counter = tick * 0.01, (self.first_counter + tick) % 256
        true = time / self.skew
        angle, velocity = float(knee_angle(true)), float(knee_velocity(true))
        status = dict.fromkeys(STATUS, 0) | {"FilterReset": int(tick == 0)}
        status |= self.status.get(tick, {})
        yield (
            "EXO_STATE",
            dict(
                Angle=angle,
                AngularVelocity=velocity,
                AngularAcceleration=0.0,
                Counter=counter,
                **status,
            ),
        )
        count = round(angle / (2 * np.pi) * 4096 + 2048) % 4096
        yield (
            "EXO_RAW",
            dict(
                Angle=count * (2 * np.pi / 4096) - np.pi,
                Counter=counter % 16,
                GyroX=0,
                GyroY=velocity,
                GyroZ=0,
            ),
        )
        yield "EXO_ACC", dict(AccelX=9.8, AccelY=0.0, AccelZ=-1.0, Counter=counter, SampleAge=350)
        if tick % 10 == 3:
            device = round((self.device_start + time) * 1e6) % 2**32
            yield (
                "EXO_TIME",
                dict(DeviceTime=device, Counter=counter, MissedTicks=0, ConfigCrc=self.config_crc),
            )
        if tick in self.mountings or (self.mountings and tick % 100 == 0):
            yield from self.told(tick)

    def told(self, tick: int):
        """How it was commissioned, and how it is; nodes without `mountings` do not tell."""
        zero, reversed = self.mountings[max(each for each in self.mountings if each <= tick)]
        yield (
            "EXO_SETTINGS",
            dict(
                Serial=self.serial,
                Zero=zero,
                Reversed=reversed,
                Commissioned=self.commissioned,
                BitRate=500_000,
                Changes=1,
            ),
        )
        version = dict(VersionMajor=1, VersionMinor=2, VersionPatch=3)
        yield "EXO_HEARTBEAT", dict(**version, SupplyVoltage=3.3, LostFrames=0, SensorFault=0)
        yield "EXO_HEALTH", WELL


STATUS = (
    "EncoderFault",
    "MagnetMissing",
    "MagnetStrength",
    "ImuFault",
    "GyroSaturated",
    "StateSaturated",
    "FilterReset",
    "Overrun",
)
WELL = {  # EXO_HEALTH
    "Counter": 0,
    "WatchdogReset": 0,
    "BrownOutReset": 0,
    "OnCan": 1,
    "CanOff": 0,
    "BusReleases": 0,
    "CanStarts": 1,
    "TransmitErrors": 0,
    "ReceiveErrors": 0,
}


def health(timestamp, **told) -> can.Message:
    """EXO_HEALTH of a node that is well but for what is told."""
    return message("EXO_HEALTH", WELL | told, timestamp)


ADULT = (27.4, 6.25, 0.8, -0.5, 0.125)  # ratios in the order of EXO_RATIOS, and friction
SURE = (0.125, 0.25, 0.0078125, 0.25, 0.015625)  # their errors


def learned(timestamp, ratios=ADULT, errors=SURE, node=0, **told) -> list[can.Message]:
    """What a node says it has learned of a leg; four frames."""
    names = "Gravity", "Stiffness", "Damping", "Torque"
    how = dict(Counter=0, Trust=2, Phase=1, Drops=3, Surprise=1.0, LearningCrc=learning_crc())
    values = (dict(zip(names, each[:-1], strict=True)) for each in (ratios, errors))
    friction = {"Friction": ratios[-1], "Error": errors[-1]}
    messages = zip(LEARNED, (*values, friction, how | told), strict=True)
    return [
        message(name, each, timestamp + place * FRAME, node)
        for place, (name, each) in enumerate(messages)
    ]


def message(name, values, timestamp, node=0) -> can.Message:
    definition = codec().get_message_by_name(name)
    return can.Message(
        timestamp=timestamp,
        arbitration_id=definition.frame_id + 16 * node,
        is_extended_id=False,
        data=definition.encode(values, strict=False),
    )


WRITERS = {
    ".blf": can.BLFWriter,
    ".asc": can.ASCWriter,
    ".log": can.CanutilsLogWriter,
    ".trc": can.TRCWriter,
    ".csv": can.CSVWriter,
}


def write_log(path: Path, messages) -> Path:
    """The messages as a log file, in the format of the suffix."""
    writer = mf4_writer(path) if path.suffix == ".mf4" else WRITERS[path.suffix](path)
    for each in messages:
        writer.on_message_received(each)
    writer.stop()
    return path


def mf4_writer(path: Path):
    """A file that begins when the messages do; the writer's own clock would change its bytes."""
    from can.io.mf4 import MF4Writer

    with patch("can.io.mf4.datetime") as clock:
        clock.now.return_value = datetime.fromtimestamp(EPOCH)
        return MF4Writer(path)
