"""Faults of wires, chips, supply and hosts: no pass takes two ticks, every fault is told."""

from itertools import pairwise

import numpy as np
import pytest
from node_world import ON_USB, STATE, Event, Life, live

from exoid.recordings.can.node.health import PASSIVE
from exoid.recordings.loading.can_log import read_can_log

WORLDS = ("node_world", "node_world.elf")
TICK = 0.01  # s
BEGIN, AFTER = 1000, 2000  # ms: the fault begins when all has settled, and is watched after its end
SETTLED = 500  # ms
ENCODER_SILENT, IMU_SILENT, NO_MAGNET, WEAK_MAGNET, _, IMU_RESET = (1 << bit for bit in range(6))
SENSORS = {"EncoderFault", "ImuFault"}
DEAD_LOW, DEAD_HIGH = 1, 2
CAN_OFF = 1 << 3  # of the second byte of EXO_HEALTH

# What befalls it, its value, how long [ms] and with what value it ends, and the bits that tell it.
FAULTS = {
    "the encoder is torn off": ("SENSORS", ENCODER_SILENT, 100, 0, {"EncoderFault"}),
    "the magnet is lost": ("SENSORS", NO_MAGNET, 100, 0, {"MagnetMissing"}),
    "the magnet is far": ("SENSORS", WEAK_MAGNET, 100, 0, {"MagnetStrength"}),
    "the inertial sensor is dead": ("SENSORS", IMU_SILENT, 100, 0, {"ImuFault"}),
    "its supply dips": ("SENSORS", IMU_RESET, 10, 0, {"ImuFault"}),
    "both are dead for long": (
        *("SENSORS", ENCODER_SILENT | IMU_SILENT | IMU_RESET, 1000, 0),
        SENSORS | {"FilterReset"},
    ),
    "the clock is held for a moment": ("CLOCK_HELD", 1, 100, 0, SENSORS),
    "the clock is held for long": ("CLOCK_HELD", 1, 1000, 0, SENSORS | {"FilterReset"}),
    "the controller dies, MISO low": ("CONTROLLER", DEAD_LOW, 60, 0, {"Overrun"}),
    "the controller dies, MISO high": ("CONTROLLER", DEAD_HIGH, 60, 0, {"Overrun"}),
    "the controller is dead for long": ("CONTROLLER", DEAD_HIGH, 3000, 0, {"Overrun"}),
    "the cable is pulled": ("ACKNOWLEDGED", 0, 200, 1, {"Overrun"}),
    "the cable is pulled for long": ("ACKNOWLEDGED", 0, 5000, 1, {"Overrun"}),
    "the bus is shorted": ("SHORTED", 1, 500, 0, {"Overrun"}),
    "the bus is shorted and the controller stays off": ("SHORTED", 2, 500, 0, {"Overrun"}),
    "another node sends what nobody knows": ("FOREIGN", 0x123, 10, 0x7FF, set()),
    "another node sends what is nearly a command": ("FOREIGN", 0x201, 10, 0x7FF, set()),
    "another node sends with our identifier": ("FOREIGN", STATE, 10, TICK, set()),
}


def after(kind: str, value: int, length: int, back: int) -> list[Event]:
    """The events of a fault that begins at BEGIN."""
    end = BEGIN + length
    return [(BEGIN, kind, value), (end, kind, int(back)), (end + AFTER, "END", 0)]


def steps(life: Life) -> np.ndarray:
    """Ticks from each EXO_STATE on CAN to the next."""
    return np.diff(life.signal("EXO_STATE", "Counter")) % 256


def assert_it_never_stood_still(life: Life):
    assert life.longest_pass < 2 * TICK
    assert set(life.signal("EXO_TIME", "MissedTicks")) == {0}


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_told_by_its_bits_and_stops_nothing(fault, world, tmp_path):
    kind, value, length, back, bits = FAULTS[fault]
    life = live(world, after(kind, value, length, back), tmp_path)
    assert_it_never_stood_still(life)
    assert life.told(SETTLED) == bits
    assert life.told(BEGIN + length + AFTER - 1000) == set()  # and all is well again
    assert life.restarts.size == 0
    lost = steps(life).max() > 1
    assert lost == ("Overrun" in bits)


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("byte", [1, 2, 3, 5, 8, 13, 21, 30])
def test_a_line_held_in_the_middle_of_a_transfer_costs_its_reading_alone(byte, world, tmp_path):
    """Of the clock until it is let go; of the data until the next transfer has clocked it free."""
    for kind, value, most in (("CLOCK_HELD_AFTER", byte, 2), ("DATA_HELD_AFTER", 16 * byte + 9, 2)):
        end = (BEGIN + 15, "CLOCK_HELD", 0)
        life = live(world, [(BEGIN, kind, value), end, (2000, "END", 0)], tmp_path)
        assert_it_never_stood_still(life)
        assert life.told(SETTLED) <= SENSORS
        for bit in SENSORS:
            settled = life.frames(STATE)["at_ms"] >= SETTLED
            assert life.signal("EXO_STATE", bit)[settled].sum() <= most
        assert set(steps(life)) == {1}


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("has_timeouts", [1, 0])
def test_a_bus_that_looks_busy_is_released_after_one_transfer(has_timeouts, world, tmp_path):
    life = live(world, [(BEGIN, "GLITCH", has_timeouts), (2000, "END", 0)], tmp_path)
    assert_it_never_stood_still(life)
    assert life.told(SETTLED) <= {"EncoderFault"}
    settled = life.frames(STATE)["at_ms"] >= SETTLED
    assert life.signal("EXO_STATE", "EncoderFault")[settled].sum() <= 1


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("level", [DEAD_LOW, DEAD_HIGH])
def test_a_controller_that_gets_its_supply_late_is_found(level, world, tmp_path):
    events = [(0, "CONTROLLER", level), (10_000, "CONTROLLER", 0), (11_000, "END", 0)]
    life = live(world, events, tmp_path)
    assert_it_never_stood_still(life)
    found = life.frames(STATE)["at_ms"][0]
    assert 10_000 < found < 10_060
    assert "Overrun" not in life.told()  # nobody listened before


@pytest.mark.parametrize("world", WORLDS)
def test_a_host_that_stalls_or_is_unplugged_costs_frames_and_no_tick(world, tmp_path):
    events: list[Event] = [(0, "CONTROLLER", DEAD_HIGH), (BEGIN, "TYPED", ord("O"))]
    for at, kind in ((2000, "USB_READS"), (5000, "USB_PLUGGED")):
        events += [(at, kind, 0), (at + 1000, kind, 1)]
    life = live(world, [*events, (8000, "END", 0)], tmp_path)
    assert life.longest_pass < 2 * TICK
    lines = life.text.split("\r")
    frames = [line for line in lines if line.startswith("t") and len(line) == 21]
    states = [bytes.fromhex(line[5:]) for line in frames if line.startswith("t101")]
    gaps = [(two[6] - one[6]) % 256 for one, two in pairwise(states)]
    assert sum(gap > 1 for gap in gaps) == 2
    assert 1 <= sum(state[7] >> 7 for state in states) <= 4  # Overrun, soon after each
    assert {bytes.fromhex(line[5:])[5] for line in frames if line.startswith("t100")} == {0}


@pytest.mark.parametrize("world", WORLDS)
def test_a_program_that_is_killed_costs_neither_who_is_on_can_nor_the_next_one(world, tmp_path):
    killed, next_one = 3000, 6000
    events: list[Event] = [
        *((BEGIN, "TYPED", ord("O")), (killed, "USB_HELD", 0), (next_one, "USB_HELD", 1)),
        (8000, "END", 0),
    ]
    life = live(world, events, tmp_path)
    assert life.longest_pass < 2 * TICK
    assert life.told(BEGIN) == set()
    heard = life.records[life.records["link"] == ON_USB]["at_ms"]
    assert ((heard > BEGIN) & (heard < killed)).sum() > 500  # three frames a tick, some in a packet
    assert heard.max() <= killed


@pytest.mark.parametrize("world", WORLDS)
def test_a_node_without_ticks_is_reset_and_the_host_says_so(world, tmp_path):
    life = live(world, [(3000, "TIMER_STANDS", 0), (8000, "END", 0)], tmp_path)
    (restart,) = life.restarts
    assert restart["at_ms"] - 3000 < 150
    assert life.told(BEGIN) == {"FilterReset"}
    _, quality = read_can_log(life.log(tmp_path / "node.log"))
    assert any("started again 1 time" in line for line in quality.lines())
    assert any("WatchdogReset" in line for line in quality.lines())


@pytest.mark.parametrize("world", WORLDS)
def test_a_supply_that_dips_is_a_new_start_and_a_gap(world, tmp_path):
    life = live(world, [(3000, "BROWN_OUT", 300), (8000, "END", 0)], tmp_path)
    assert life.restarts.size == 1
    assert life.told(BEGIN) == {"FilterReset", "ImuFault"}  # the gyro settles again
    _, quality = read_can_log(life.log(tmp_path / "node.log"))
    assert any("started again 1 time" in line for line in quality.lines())
    assert any("BrownOutReset" in line for line in quality.lines())


def test_the_host_names_the_bits_and_the_loss(tmp_path):
    events: list[Event] = [
        (3000, "CLOCK_HELD", 1),
        (3100, "CLOCK_HELD", 0),
        (4000, "CONTROLLER", DEAD_HIGH),
        (4500, "CONTROLLER", 0),
        (7000, "END", 0),
    ]
    life = live("node_world", events, tmp_path)
    _, quality = read_can_log(life.log(tmp_path / "node.log"))
    named = {name for name, count in quality.faults if count}
    assert {"EncoderFault", "ImuFault", "Overrun"} <= named
    (gap,) = quality.gaps
    assert gap.duration == pytest.approx(0.5, abs=0.1)  # and the controller's new start
    said = "; ".join(quality.lines())
    assert "released its sensors' bus" in said
    assert "set its CAN controller up 2 times" in said


def test_a_host_on_usb_hears_of_a_bus_without_listeners_and_of_one_that_is_shorted(tmp_path):
    """The controller's errors cannot be told on its own bus."""
    events: list[Event] = [
        (0, "TYPED", ord("O")),
        (2000, "ACKNOWLEDGED", 0),
        (4500, "ACKNOWLEDGED", 1),
        (6000, "SHORTED", 1),
        (8500, "SHORTED", 0),
        (12_000, "END", 0),
    ]
    text = live("node_world", events, tmp_path).text
    told = [bytes.fromhex(line[5:]) for line in text.split("\r") if line.startswith("t10F8")]
    states = [(health[6] >= PASSIVE, bool(health[1] & CAN_OFF)) for health in told]
    assert {*states} == {(False, False), (True, False), (False, True)}
    assert states[-1] == (False, False)
