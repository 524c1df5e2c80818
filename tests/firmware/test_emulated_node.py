"""The firmware on an emulated microcontroller, heard by python-can over its serial line."""

import can
import float32_node
import numpy as np
import pytest
from emulated_node import (
    ENCODER_SILENT,
    IMU_RESET,
    IMU_SILENT,
    MAGNET_MISSING,
    Samples,
    emulated_node,
    samples_of,
)
from float32_node import ENCODER_STEP, GYRO_STEP, TURN, ZERO_COUNT, Readings
from motions import measured

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.decode import raw_values
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.can.node.samples import STATUS
from exoid.recordings.measured.segment import Segment

SAMPLED = (0x101, 0x102, 0x103)  # the frames of one tick
FRAMES = 300  # of these, in one second
FAULTY = {20: ENCODER_SILENT, 21: MAGNET_MISSING, 30: IMU_SILENT, 40: IMU_RESET}  # by sample
BLIND = slice(64, 92)  # longer than the filter predicts


def swinging_leg() -> Samples:
    """A fast swing with faults, more than the test listens to."""
    angle, rate = (column[2000:2400] for column in measured(3000, seed=5))
    gyro = np.zeros((angle.size, 3), int)
    gyro[:, 1] = -np.rint(rate / GYRO_STEP)
    gyro[60:63, 1] = 32767
    accel = np.arange(3 * angle.size).reshape(-1, 3)
    faults = np.zeros(angle.size, int)
    for sample, fault in FAULTY.items():
        faults[sample] = fault
    faults[BLIND] = ENCODER_SILENT | IMU_SILENT
    count = (np.rint(angle / ENCODER_STEP).astype(int) + ZERO_COUNT) % TURN
    return Samples(count, gyro, accel, faults)


@pytest.fixture(scope="module")
def leg():
    return swinging_leg()


@pytest.fixture(scope="module")
def heard(leg):
    """The data of the frames that came, by message, and what the node says of itself."""
    with (
        emulated_node(leg) as channel,
        can.Bus(interface="slcan", channel=channel, bitrate=500_000, sleep_after_open=0) as bus,
    ):
        frames = first_second(bus)
        version = bus.get_version(timeout=5)
    return sorted_out(frames), [frame.arbitration_id for frame in frames], version


def first_second(bus):
    """What comes until all frames of a hundred ticks are there."""
    frames = []
    while sum(frame.arbitration_id in SAMPLED for frame in frames) < FRAMES:
        frames.append(bus.recv(timeout=10))
        assert frames[-1] is not None
    return frames


def sorted_out(frames):
    """Every signal of every message as it was sent, by message and signal."""
    assert all(len(frame.data) == 8 for frame in frames)
    found = {}
    for name, plan in exoid_messages().items():
        if not any(frame.arbitration_id == plan.identifier for frame in frames):
            continue
        data = [frame.data for frame in frames if frame.arbitration_id == plan.identifier]
        table = np.frombuffer(b"".join(data), np.uint8).reshape(-1, 8)
        found[name] = {each.name: raw_values(table, each).astype(int) for each in plan.signals}
    return found


def test_no_frame_is_lost_and_three_come_each_tick_in_order(heard):
    found, identifiers, _ = heard
    for name, wrap in {"EXO_STATE": 256, "EXO_RAW": 16, "EXO_ACC": 256}.items():
        assert set(np.diff(found[name]["Counter"]) % wrap) == {1}
    sampled = [identifier for identifier in identifiers if identifier in SAMPLED]
    assert sampled == list(SAMPLED) * 100
    assert not found["EXO_STATE"]["Overrun"].any()


def test_the_clock_comes_ten_times_a_second_with_the_hosts_own_crc(heard):
    time = heard[0]["EXO_TIME"]
    assert time["DeviceTime"].size in (9, 10, 11)
    assert set(np.diff(time["DeviceTime"])) == {100_000}
    assert set(np.diff(time["Counter"]) % 256) == {10}
    assert set(time["ConfigCrc"]) == {config_crc()}
    assert set(time["MissedTicks"]) == {0}


def test_the_readings_are_what_the_sensors_were_exposed_to(heard, leg):
    raw, acc, state = (heard[0][name] for name in ("EXO_RAW", "EXO_ACC", "EXO_STATE"))
    size = raw["Angle"].size
    seen = ~state["EncoderFault"].astype(bool)[:size]
    np.testing.assert_array_equal(raw["Angle"][seen], leg.count[:size][seen])
    moved = ~state["ImuFault"].astype(bool)[:size]
    np.testing.assert_array_equal(raw["GyroY"][moved], -leg.gyro[:size, 1][moved])
    np.testing.assert_array_equal(acc["AccelZ"], np.where(moved, leg.accel[:size, 2], 0)[:size])


def test_every_fault_is_told_at_its_own_sample(heard):
    state = heard[0]["EXO_STATE"]
    told = {bit: np.flatnonzero(state[bit]).tolist() for bit in STATUS}
    # After its settings are lost the gyro takes eight reads to settle; after a silence, none.
    assert told == {
        "EncoderFault": [20, *range(64, 92)],
        "MagnetMissing": [21],
        "MagnetStrength": [],
        "ImuFault": [30, *range(40, 50), *range(64, 92)],
        "GyroSaturated": [60, 61, 62],
        "StateSaturated": [],
        "FilterReset": [0, 92],
        "Overrun": [],
    }


def test_the_filter_run_again_on_the_readings_gives_the_same_states(heard):
    raw, state = heard[0]["EXO_RAW"], heard[0]["EXO_STATE"]
    size = raw["Angle"].size
    bit = {name: state[name].astype(bool)[:size] for name in STATUS}
    again = float32_node.rerun(
        Readings(
            raw["Angle"],
            raw["GyroY"],
            ~(bit["EncoderFault"] | bit["MagnetMissing"]),
            ~(bit["ImuFault"] | bit["GyroSaturated"]),
            bit["FilterReset"],
        )
    )
    names = ("Angle", "AngularVelocity", "AngularAcceleration")
    counts = np.rint(again * (4096, 1024, 32))
    for name, column in zip(names, counts.T, strict=True):
        np.testing.assert_array_equal(state[name][:size], column)


def test_the_node_answers_what_host_programs_ask(heard):
    assert heard[2] == (1, 1)


def test_the_registers_behind_a_log_show_its_raw_channels():
    log = Segment(
        np.arange(3) * 0.01,
        raw_angle=np.array([-np.pi / 2, np.nan, 0.1]),
        raw_angular_velocity=np.array([1.0, 0.0, -60.0]),
        raw_acceleration_x=np.array([9.81, 0.0, 0.0]),
        raw_acceleration_z=np.array([0.0, 0.0, -9.81]),
    )
    samples = samples_of(log)
    assert samples.count.tolist() == [1024, 2048, 2048 + 65]  # 0.1 rad are 65.2 counts
    assert samples.faults.tolist() == [0, ENCODER_SILENT, 0]
    assert samples.gyro[:, 1].tolist() == [-819, 0, 32767]  # positive in flexion, and limited
    assert samples.accel[:, [0, 2]].tolist() == [[8200, 0], [0, 0], [0, -8200]]
    assert len(samples.stream()) == 3 * 16
