"""The emulated node learns a leg that is let go, and tells it over its serial line."""

import can
import numpy as np
import pytest
from emulated_node import Samples, emulated_node
from learner_runs import TOLD, Ticks, told_by_numpy
from simulated_legs import FINER, Legs, held, joined

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.decode import raw_values
from exoid.recordings.can.node.config_crc import LEARNED, learning_crc

HELD, FALLING = 1.0, 3.0  # s
SAMPLES = 450  # that are listened to: the leg is at rest again
MOVING = 3


@pytest.fixture(scope="module")
def leg():
    return Legs.drawn(1, np.random.default_rng(3))


@pytest.fixture(scope="module")
def heard(leg):
    """Every signal of every message, as it was sent."""
    start = np.array([-0.1])
    drop = leg.drop(start, FALLING)
    motion = joined(held(start, HELD), drop, held(drop[0][-1], 0.5))
    count, gyro = leg.sensed(motion, np.random.default_rng(4))
    with (
        emulated_node(samples(count[:, 0] // FINER, gyro[:, 0])) as channel,
        can.Bus(interface="slcan", channel=channel, bitrate=500_000, sleep_after_open=0) as bus,
    ):
        return signals_of(listen(bus))


def samples(count: np.ndarray, gyro: np.ndarray) -> Samples:
    axes = np.zeros((count.size, 3), int)
    turning = axes.copy()
    turning[:, 1] = -gyro
    return Samples(count, turning, axes, np.zeros(count.size, int))


def listen(bus) -> list[can.Message]:
    """What comes until enough ticks are there; a busy machine's emulator may be slow."""
    state, frames, ticks = exoid_messages()["EXO_STATE"].identifier, [], 0
    while ticks < SAMPLES:
        frames.append(bus.recv(timeout=10))
        assert frames[-1] is not None
        ticks += frames[-1].arbitration_id == state
    return frames


def signals_of(frames) -> dict[str, dict[str, np.ndarray]]:
    found = {}
    for name, plan in exoid_messages().items():
        data = [bytes(frame.data) for frame in frames if frame.arbitration_id == plan.identifier]
        if data:
            table = np.frombuffer(b"".join(data), np.uint8).reshape(-1, 8)
            found[name] = {each.name: raw_values(table, each).astype(int) for each in plan.signals}
    return found


@pytest.fixture(scope="module")
def again(heard) -> np.ndarray:
    """The NumPy learner on the readings that were sent, tick by tick from the node's start."""
    raw, state = heard["EXO_RAW"], heard["EXO_STATE"]
    size = min(raw["Angle"].size, state["Counter"].size)
    assert set(np.diff(state["Counter"][:size]) % 256) == {1}
    seen = ~(state["EncoderFault"] | state["MagnetMissing"])[:size].astype(bool)
    turns = ~(state["ImuFault"] | state["GyroSaturated"])[:size].astype(bool)
    columns = (raw["Angle"] * FINER, raw["GyroY"])
    none = np.zeros(size, int)
    ticks = Ticks(*(each[:size, None] for each in (*columns, seen, turns, none)))
    return told_by_numpy(ticks, every=1)[:, 0]


def told_at(heard, again) -> tuple[np.ndarray, np.ndarray]:
    """Which of the times were told, and by which row of `again`: the counter says it.

    The first may tell of the tick in which the host began to listen: before all that it heard.
    """
    first = heard["EXO_STATE"]["Counter"][0]
    told = np.unwrap(heard["EXO_LEARNING"]["Counter"], period=256)
    rows = (told - told[0]) + (told[0] - first + 128) % 256 - 128
    inside = np.flatnonzero((rows >= 0) & (rows < again.size))
    return inside, rows[inside]


def test_what_it_tells_is_what_numpy_learns_from_its_readings(heard, again):
    """Ten times a second, but where a busy machine leaves the emulator no time between ticks."""
    times, rows = told_at(heard, again)
    assert times.size >= 15
    assert np.diff(rows).min() == 10
    assert (again["phase"][rows] == MOVING).sum() >= 5
    learning = heard["EXO_LEARNING"]
    assert set(learning["LearningCrc"]) == {learning_crc()}
    for name, field in (("Trust", "trust"), ("Phase", "phase"), ("Drops", "drops")):
        np.testing.assert_array_equal(learning[name][times], again[field][rows])
    friction = np.stack([again["ratio"][:, 4], again["error"][:, 4]], axis=1)
    wanted = again["ratio"][:, :4], again["error"][:, :4], friction
    for name, values in zip(LEARNED[:3], wanted, strict=True):
        plan = exoid_messages()[name]
        counts = values[rows] / np.array([each.scale for each in plan.signals], np.float32)
        counts = np.trunc(counts + np.copysign(np.float32(0.5), counts)).clip(-32768, 32767)
        sent = np.stack([heard[name][each.name] for each in plan.signals], axis=1)[times]
        np.testing.assert_array_equal(sent, counts)


def test_the_leg_that_it_learns_is_the_true_one(heard, leg):
    assert MOVING in heard["EXO_LEARNING"]["Phase"]
    assert heard["EXO_LEARNING"]["Drops"][-1] == 1
    values, errors, friction = (
        np.array(
            [heard[name][each.name][-1] * each.scale for each in exoid_messages()[name].signals]
        )
        for name in LEARNED[:3]
    )
    assert errors[0] < 0.04 * values[0]  # 3 s of a drop
    assert np.all(np.abs(values - leg.ratios[:4, 0]) < 4 * errors)
    assert np.abs(friction[0] - leg.ratios[4, 0]) < 4 * friction[1]


def test_no_tick_is_lost_while_it_learns(heard):
    assert set(heard["EXO_TIME"]["MissedTicks"]) == {0}
    assert not heard["EXO_STATE"]["Overrun"].any()


def test_a_record_of_what_is_told_has_no_gap_between_its_fields():
    assert TOLD.itemsize == 4 * (3 + 10 + 10 + 45 + 4 + 11)  # as the firmware writes it
