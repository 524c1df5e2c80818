"""The sketch's own body on a simulated board, under the address and the behaviour sanitiser."""

import subprocess

import pytest
from firmware_tools import FIRMWARE, need

SCENARIOS = (
    "motion",
    "start",
    "encoder_nack",
    "imu_nack",
    "imu_reset",
    "stuck_bus",
    "missing_magnet",
    "weak_magnet",
    "strong_magnet",
    "gyro_saturation",
    "blindness",
    "saturation",
    "can_order",
    "time_half_a_period_off",
    "can_without_acknowledgement",
    "slcan_fallback",
    "host_that_does_not_read",
    "host_that_comes_back",
    "program_that_is_killed",
    "usb_beside_can",
    "port_that_loses",
    "loss_where_the_count_wraps",
    "clock_held_in_a_transfer",
    "clock_held_for_minutes",
    "busy_with_both_lines_high",
    "data_held_in_a_transfer",
    "stop_in_progress",
    "one_byte_and_more",
    "sensors_that_brown_out",
    "controller_that_dies",
    "controller_that_comes_late",
    "controller_that_forgets",
    "bus_that_is_shorted",
    "cable_that_is_pulled",
    "foreign_frames",
    "frames_that_are_understood",
    "timing",
    "zero_here",
    "flash_at_any_time",
    "zero_at_an_angle",
    "zero_without_an_angle",
    "not_a_command",
    "node_id",
    "bit_rate",
    "flash_that_fails",
    "told_once_a_second",
    "errors_told",
    "blinks",
    "over_usb",
    "commands_by_both",
    "loss_of_what_is_told_beside",
    "angle_in_full",
    "zero_in_full",
    "nobody_asks",
    "parameters_that_come_whole",
    "parameters_that_do_not",
    "a_part_that_is_sent_twice",
    "flash_that_is_damaged",
    "flash_that_takes_none",
    "gravity_is_taken_off",
    "limits_are_kept",
    "sensor_faults_cut",
    "a_silent_host_cuts",
    "commands_cut",
    "an_encoder_that_hangs_cuts",
)


@pytest.fixture(scope="module")
def played(build):
    """What each scenario came to, and what was said of those that failed."""
    done = subprocess.run([build("sketch")], capture_output=True, text=True, timeout=120)
    verdicts = dict(line.split(": ")[::-1] for line in done.stdout.splitlines())
    return verdicts, done.stderr


def test_every_scenario_is_named_here(played):
    assert tuple(played[0]) == SCENARIOS


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_sketch_does_what_the_scenario_asks(played, scenario):
    verdicts, said = played
    assert verdicts[scenario] == "ok", said


def test_the_timer_is_set_to_a_hundred_ticks_a_second(build):
    subprocess.run([build("host_timer")], check=True, timeout=10)


def test_the_supply_is_measured_to_a_count_of_the_converter(build):
    subprocess.run([build("host_supply")], check=True, timeout=10)


@pytest.mark.parametrize(
    ("crystal", "rate", "is_possible"),
    [
        (8_000_000, 500_000, True),
        (16_000_000, 1_000_000, True),
        (8_000_000, 1_000_000, False),  # four quanta; the chip needs five
        (8_000_000, 300_000, False),  # not a whole number of quanta
    ],
)
def test_a_bit_rate_that_the_crystal_cannot_do_does_not_compile(
    crystal, rate, is_possible, tmp_path
):
    need("g++")
    source = tmp_path / "timing.cpp"
    source.write_text(
        f'#include "can_timing.h"\nauto quanta = exoid::CanTiming<{crystal}, {rate}>::QUANTA;\n'
    )
    sources = FIRMWARE / "exoid_node" / "src"
    command = ["g++", "-std=c++11", "-fsyntax-only", f"-I{sources}", source]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode == 0) == is_possible
    if not is_possible:
        assert "the crystal of the MCP2515 cannot do this bit rate" in done.stderr


def test_settings_survive_a_power_cut_at_every_byte(build):
    subprocess.run([build("host_settings")], check=True, timeout=60)


def test_the_flash_is_written_as_its_controller_wants_it(build):
    subprocess.run([build("host_flash")], check=True, timeout=10)
