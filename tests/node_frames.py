"""The CAN frames with which the node sends a session, as a host on the same bus logs them."""

from collections.abc import Iterator
from itertools import accumulate

import numpy as np
from cantools.database import load_file
from cantools.database.can import Database

from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.measured.segment import Segment

TICK_US = 10_000  # us of the device clock between samples
TICKS_PER_TIME = 10  # EXO_TIME comes every tenth tick, half a tick after it
FRAME_TIME = 270e-6  # s that one frame takes at 500 kbit/s
SAMPLE_AGE = 350  # us from the tick to the end of the inertial sensor's read-out
TURNED_ON = 3_218_400  # us, device time of the first sample
Values = dict[str, float | int]  # by signal, in its unit
CLOCK_WRAP = 2**32  # us
COUNTER, RAW_COUNTER = 256, 16  # values of the counters
REQUIRED = (
    "angle",
    "angular_velocity",
    "angular_acceleration",
    "raw_angle",
    "raw_angular_velocity",
    "raw_acceleration_x",
    "raw_acceleration_z",
)


def frames(
    log: Segment, generator: np.random.Generator, *, epoch: float, jitter: float, config_crc: int
) -> Iterator[tuple[float, int, bytes]]:
    """Host time [s], identifier and data of every frame, in the order of the bus.

    The host reads its clock, `epoch` at the first sample, up to a few `jitter` [s] after a frame
    arrived. The node's own clock counts 10 ms per sample whatever the log's time says.
    """
    database = load_file(EXOID_DBC)
    assert isinstance(database, Database)
    sent = sorted(bus(log, database, config_crc), key=lambda frame: frame[0])
    late = generator.exponential(jitter, len(sent))
    arrived = accumulate((t + d for (t, *_), d in zip(sent, late, strict=True)), max)
    for time, (_, identifier, data) in zip(arrived, sent, strict=True):
        yield epoch + time, identifier, data


def bus(log: Segment, database: Database, config_crc: int) -> Iterator[tuple[float, int, bytes]]:
    """The frames of all ticks with the time [s] at which each is complete on the bus."""
    missing = [name for name in REQUIRED if getattr(log, name) is None]
    if missing:
        raise ValueError(f"the node sends {', '.join(missing)}, which this log does not have.")
    half = float(np.median(np.diff(log.time))) / 2
    for tick, time in enumerate(log.time.tolist()):
        for place, (name, values) in enumerate(tick_values(log, tick), start=1):
            yield time + place * FRAME_TIME, *encoded(database, name, values)
        if tick % TICKS_PER_TIME == 0:
            values = clock_values(tick, config_crc)
            yield time + half + FRAME_TIME, *encoded(database, "EXO_TIME", values)


def encoded(database: Database, name: str, values: Values) -> tuple[int, bytes]:
    """Identifier and data of one frame; a signal that is not named is 0."""
    message = database.get_message_by_name(name)
    silent = {signal.name: 0 for signal in message.signals}
    return message.frame_id, message.encode(silent | values)


def clock_values(tick: int, config_crc: int) -> Values:
    time = (TURNED_ON + tick * TICK_US) % CLOCK_WRAP
    return {"DeviceTime": time, "Counter": tick % COUNTER, "ConfigCrc": config_crc}


def tick_values(log: Segment, tick: int) -> Iterator[tuple[str, Values]]:
    """What the three frames of a tick say, by message and signal."""
    at = {name: float(getattr(log, name)[tick]) for name in REQUIRED}
    fault = bool(np.isnan(at["raw_angle"]))
    counter = tick % COUNTER
    yield (
        "EXO_STATE",
        {
            "Angle": at["angle"],
            "AngularVelocity": at["angular_velocity"],
            "AngularAcceleration": at["angular_acceleration"],
            "Counter": counter,
            "EncoderFault": fault,
            "FilterReset": tick == 0,
        },
    )
    turned = 0.0 if fault else (at["raw_angle"] + np.pi) % (2 * np.pi) - np.pi
    raw = {"Angle": turned, "Counter": tick % RAW_COUNTER, "GyroY": at["raw_angular_velocity"]}
    yield "EXO_RAW", raw
    force = {"AccelX": at["raw_acceleration_x"], "AccelZ": at["raw_acceleration_z"]}
    yield "EXO_ACC", force | {"Counter": counter, "SampleAge": SAMPLE_AGE}
