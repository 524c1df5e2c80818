"""The node on a Teensy 4: the sketch on the simulated board, and for its processor."""

import re
import subprocess

import pytest
from firmware_tools import need

SCENARIOS = (
    "motion",
    "watchdog_is_set",
    "bus_without_listener",
    "host_on_usb",
    "program_that_is_killed",
    "clock_that_is_held",
    "data_that_is_held",
    "sensors_that_are_silent",
    "read_that_is_refused",
    "clock_that_falls_in_a_transfer",
    "settings_that_cannot_be_stored",
    "bit_rates_of_the_oscillator",
)


@pytest.fixture(scope="module")
def played(build):
    """What each scenario came to, and what was said of those that failed."""
    done = subprocess.run([build("teensy4")], capture_output=True, text=True, timeout=120)
    verdicts = dict(line.split(": ")[::-1] for line in done.stdout.splitlines())
    return verdicts, done.stderr


def test_every_scenario_is_named_here(played):
    assert tuple(played[0]) == SCENARIOS


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_sketch_does_on_a_teensy_what_the_scenario_asks(played, scenario):
    verdicts, said = played
    assert verdicts[scenario] == "ok", said


def test_its_controller_has_the_clocks_and_pins_that_it_needs(build):
    subprocess.run([build("host_teensy4")], check=True, timeout=10)


def test_the_sketch_compiles_for_its_processor_and_leaves_only_the_core_to_link(build):
    need("arm-none-eabi-nm")
    symbols = subprocess.run(
        ["arm-none-eabi-nm", "-C", "--undefined-only", build("m7_sketch.o")],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    missing = {line.split(" U ")[1].split("(")[0] for line in symbols.splitlines()}
    own = {name for name in missing if name.startswith("exoid::")}
    assert own == set()
    assert "IntervalTimer::begin" in missing


def test_no_product_is_fused_with_its_sum_under_the_cores_own_flags(build):
    """The filter is then the host's to the bit, whatever the IDE compiles it with."""
    need("arm-none-eabi-objdump")
    listed = subprocess.run(
        ["arm-none-eabi-objdump", "-d", build("m7_core.o")],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert "vmul.f32" in listed
    assert not re.findall(r"vfn?m[as]\.f32", listed)
