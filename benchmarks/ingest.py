"""Times reading an hour of the node's frames from a BLF file into a Recording, part by part.

python benchmarks/ingest.py [--hours 1] [--keep FILE]
"""

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import can
import numpy as np

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.device_clock import PERIOD
from exoid.recordings.can.logs.blf import read_blf
from exoid.recordings.can.node.log import read_exo
from exoid.recordings.loading.can_log import read_can_log
from exoid.recordings.loading.load import load

EPOCH = 1_750_000_000.0  # s, of the host's clock
FRAME = 270e-6  # s of one frame on the bus
TICKS_PER_TIME = 10
CYCLE, LIFT = 8.0, 1.0  # s from drop to drop, of which the leg is lifted
REPETITIONS = 3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hours", type=float, default=1.0)
    parser.add_argument("--keep", type=Path, help="write the log there and keep it")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = given.keep or Path(folder) / "hour.blf"
        count = write_hours(path, given.hours)
        size = path.stat().st_size / 1e6
        print(f"{given.hours:g} h of the node: {count} frames, {size:.1f} MB")
        report(path)


def report(path: Path) -> None:
    log = read_blf(path)
    parts = {
        "file to frames (exoid's BLF reader)": lambda: read_blf(path),
        "frames to samples on the node's clock": lambda: read_exo(log),
        "file to Recording (both, and its checks)": lambda: read_can_log(path),
        "the same, cut into movements (exoid.load)": lambda: load(path),
    }
    for name, task in parts.items():
        print(f"{best(task):8.2f} s  {name}")
    print(f"{once(lambda: iterate(path)):8.2f} s  python-can's BLF reader alone, for comparison")


def iterate(path: Path) -> int:
    with can.BLFReader(path) as reader:
        return sum(1 for _ in reader)


def best(task: Callable[[], object]) -> float:
    return min(once(task) for _ in range(REPETITIONS))


def once(task: Callable[[], object]) -> float:
    begin = time.perf_counter()
    task()
    return time.perf_counter() - begin


def write_hours(path: Path, hours: float) -> int:
    """A log of a leg that is dropped again and again; how many frames it holds."""
    tick = np.arange(round(hours * 3600 / PERIOD))
    moment = tick * PERIOD
    sent = []
    for place, (name, values) in enumerate(ticks(tick).items(), start=1):
        data = packed(exoid_messages()[name], values)
        sent.append((moment + place * FRAME, np.full(tick.size, identifier(name)), data))
    some = tick[::TICKS_PER_TIME]
    clock = {"DeviceTime": some * PERIOD * 1e6, "Counter": some % 256}
    data = packed(exoid_messages()["EXO_TIME"], clock)
    sent.append((moment[some] + PERIOD / 2, np.full(some.size, identifier("EXO_TIME")), data))
    at, who, what = (np.concatenate(column) for column in zip(*sent, strict=True))
    with can.BLFWriter(path) as writer:
        for number in np.argsort(at, kind="stable").tolist():
            writer.on_message_received(
                can.Message(
                    timestamp=EPOCH + at[number],
                    arbitration_id=int(who[number]),
                    is_extended_id=False,
                    data=what[number].tobytes(),
                )
            )
    return at.size


def ticks(tick: np.ndarray) -> dict[str, dict[str, np.ndarray]]:
    """What the frames of all ticks say."""
    swing = tick * PERIOD % CYCLE - LIFT
    lifted = 0.5 * (1 + np.cos(np.pi * swing / LIFT))
    free = np.exp(-0.9 * swing) * np.cos(5.0 * swing)
    angle = -np.pi / 2 + 1.2 * np.where(swing < 0, lifted, free)
    rate = np.gradient(angle, PERIOD)
    state = {"Angle": angle, "AngularVelocity": rate, "Counter": tick % 256}
    raw = {"Angle": angle, "GyroY": rate, "Counter": tick % 16}
    force = {"AccelX": np.full(tick.size, 9.8), "Counter": tick % 256}
    return {"EXO_STATE": state, "EXO_RAW": raw, "EXO_ACC": force}


def identifier(name: str) -> int:
    return exoid_messages()[name].identifier


def packed(plan: MessagePlan, values: dict[str, np.ndarray]) -> np.ndarray:
    """One row of 8 bytes per value, by the layout of exoid.dbc; a signal not given is 0."""
    words = np.zeros(next(iter(values.values())).size, dtype=np.uint64)
    for name, value in values.items():
        signal = plan.signal(name)
        counts = np.rint((value - signal.offset) / signal.scale).astype(np.int64)
        mask = np.uint64((1 << signal.length) - 1)
        words |= (counts.view(np.uint64) & mask) << np.uint64(signal.start)
    return words.view(np.uint8).reshape(-1, 8)


if __name__ == "__main__":
    main()
