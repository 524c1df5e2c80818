"""The sketch's own body on a simulated board, under the address and the behaviour sanitiser."""

import subprocess

import pytest

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
    "zero_here",
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


def test_settings_survive_a_power_cut_at_every_byte(build):
    subprocess.run([build("host_settings")], check=True, timeout=60)


def test_the_flash_is_written_as_its_controller_wants_it(build):
    subprocess.run([build("host_flash")], check=True, timeout=10)
