"""The node with the other parts that config.h offers: on this machine and on a Cortex-M0."""

import subprocess

import float32_node
import numpy as np
import pytest
from float32_node import F, Readings
from node_world import TIME, live

from exoid.recordings.can.node.samples import STATUS
from exoid.recordings.loading.can_log import read_can_log

PARTS = ("AS5047P-ICM42688P", "AS5048A-LSM6DS3")
WORLDS = ("node_world", "node_world.elf")
# Scenarios of the sketch that do not ask for an AS5600 or for three frames a tick.
SCENARIOS = (
    *("start", "encoder_nack", "imu_nack", "imu_reset", "strong_magnet", "gyro_saturation"),
    *("blindness", "time_half_a_period_off", "can_without_acknowledgement"),
    *("host_that_does_not_read", "port_that_loses", "clock_held_in_a_transfer"),
    *("busy_with_both_lines_high", "data_held_in_a_transfer", "sensors_that_brown_out"),
    *("controller_that_dies", "controller_that_comes_late", "controller_that_forgets"),
    *("bus_that_is_shorted", "foreign_frames", "timing", "angle_in_full"),
    "zero_in_full",
)
ENCODER_SILENT, IMU_SILENT, NO_MAGNET, _, STRONG_MAGNET, IMU_RESET = (1 << bit for bit in range(6))
FAULTS = {
    "the encoder is torn off": (ENCODER_SILENT, {"EncoderFault"}),
    "the magnet is lost": (NO_MAGNET, {"MagnetMissing", "MagnetStrength"}),
    "the magnet is near": (STRONG_MAGNET, {"MagnetStrength"}),
    "the inertial sensor is dead": (IMU_SILENT, {"ImuFault"}),
    "its supply dips": (IMU_RESET, {"ImuFault"}),
}
BEGIN, END = 1000, 1100  # ms of a fault
SETTLED = 500  # ms


@pytest.mark.parametrize("scenario", SCENARIOS)
@pytest.mark.parametrize("parts", PARTS)
def test_the_sketch_does_with_other_parts_what_the_scenario_asks(build, parts, scenario):
    program = build(f"{parts}/build/sketch")
    done = subprocess.run([program, scenario], capture_output=True, text=True, timeout=60)
    assert done.stdout == f"ok: {scenario}\n", done.stderr


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("parts", PARTS)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_another_part_is_told_and_goes_by(parts, world, fault, tmp_path):
    bits, told = FAULTS[fault]
    events = [(BEGIN, "SENSORS", bits), (END, "SENSORS", 0), (END + 1000, "END", 0)]
    life = live(f"{parts}/build/{world}", events, tmp_path)
    assert life.told(SETTLED) == told
    assert life.told(END + SETTLED) == set()
    assert set(life.signal("EXO_TIME", "MissedTicks")) == {0}


@pytest.mark.parametrize("parts", PARTS)
def test_the_cortex_m0_sends_what_this_machine_sends(parts, tmp_path):
    events = [(BEGIN, "SENSORS", NO_MAGNET), (END, "SENSORS", 0), (3000, "END", 0)]
    here, there = (live(f"{parts}/build/{world}", events, tmp_path) for world in WORLDS)
    np.testing.assert_array_equal(here.records[:-1], there.records[:-1])


def test_a_tick_with_other_parts_stays_within_its_budget(emulate, tmp_path):
    """All that a tick does but for the waiting, with models of the chips: 10 % of it at 48 MHz."""
    given = np.zeros((100, 4), "<u2")
    given[50, 0] = 1  # a host opens USB in the middle
    image = "AS5047P-ICM42688P/build/m0_tick.elf"
    given = bytes(2) + given.tobytes()  # no parameters of a torque
    ticks = emulate(image, given, tmp_path, "-icount", "shift=0")
    cost = np.frombuffer(ticks, np.uint32)[50:] * 62.5  # instructions; the gyro has settled
    print(f"{cost.mean():.0f} instructions a tick, at most {cost.max():.0f}")
    assert cost.mean() > 8_000  # it filtered
    assert cost.max() < 48_000


@pytest.fixture(scope="module")
def life(tmp_path_factory):
    """Three seconds of a node whose encoder is silent and whose magnet is lost for a while."""
    events = [
        (BEGIN, "SENSORS", ENCODER_SILENT),
        (END, "SENSORS", NO_MAGNET),
        (END + 50, "SENSORS", 0),
        (3000, "END", 0),
    ]
    return live("AS5047P-ICM42688P/build/node_world", events, tmp_path_factory.mktemp("life"))


def test_the_filter_run_again_on_the_fine_angle_gives_the_same_states(life, monkeypatch):
    """EXO_FINE holds all that the filter saw of the encoder: the states agree in every bit."""
    turn = 2**16
    monkeypatch.setattr(float32_node, "TURN", turn)
    monkeypatch.setattr(float32_node, "ZERO_COUNT", turn // 2)
    monkeypatch.setattr(float32_node, "ENCODER_STEP", F(2 * np.pi / turn))
    bit = {name: life.signal("EXO_STATE", name).astype(bool) for name in STATUS}
    fine, size = life.signal("EXO_FINE", "Angle"), life.signal("EXO_FINE", "Angle").size
    readings = Readings(
        fine,
        life.signal("EXO_RAW", "GyroY")[:size],
        ~(bit["EncoderFault"] | bit["MagnetMissing"])[:size],
        ~(bit["ImuFault"] | bit["GyroSaturated"])[:size],
        bit["FilterReset"][:size],
    )
    assert size > 290
    assert np.unique(fine % 16).size == 4  # the encoder's own counts, four to one of EXO_RAW
    exact = float32_node.rerun(readings) * (4096, 1024, 32)
    counts = np.copysign(np.floor(np.abs(exact) + 0.5), exact)  # half away from zero, as it sends
    for name, column in zip(
        ("Angle", "AngularVelocity", "AngularAcceleration"), counts.T, strict=True
    ):
        np.testing.assert_array_equal(life.signal("EXO_STATE", name)[:size], column)


def test_its_log_is_read_in_the_encoders_own_counts(life, tmp_path):
    recording, quality = read_can_log(life.log(tmp_path / "leg.log"))
    angle = recording.segments[0].raw_angle
    assert angle is not None
    counts = angle[np.isfinite(angle)] / (2 * np.pi / 2**14)
    np.testing.assert_allclose(counts, np.rint(counts), rtol=0, atol=1e-9)  # of float64's rounding
    assert np.unique(np.rint(counts) % 4).size == 4
    assert recording.sensors.encoder_counts == 2**14
    assert life.frames(TIME).size == 30
    assert all(count.used == count.expected for count in quality.messages)
