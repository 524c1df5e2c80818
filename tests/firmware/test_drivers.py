"""Every driver of a part that config.h offers, on a register model of its data sheet."""

import subprocess

import pytest

SCENARIOS = (
    "every_count",
    "wrong_parity_of_answers",
    "wrong_parity_of_commands",
    "error_flag",
    "lines_that_are_stuck",
    "offsets_not_ready",
    "magnets",
    "the_other_chip",
    "starts",
    "scales",
    "axes",
    "ends_of_the_range",
    "wrong_name",
    "silence",
    "lost_settings",
    "stale_sample",
    "sample_that_comes_while_it_is_read",
    "no_sample_yet",
    "timing_of_the_oscillator",
    "frames_in_their_order",
    "frames_of_others",
    "frame_that_is_put_into_its_mailbox",
    "nobody_acknowledges",
    "bus_that_is_shorted",
    "controller_that_forgets",
    "request_that_is_overlooked",
    "controller_that_is_dead",
)


@pytest.fixture(scope="module")
def played(build):
    """What each scenario came to, and what was said of those that failed."""
    done = subprocess.run([build("drivers")], capture_output=True, text=True, timeout=60)
    verdicts = dict(line.split(": ")[::-1] for line in done.stdout.splitlines())
    return verdicts, done.stderr


def test_every_scenario_is_named_here(played):
    assert tuple(played[0]) == SCENARIOS


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_driver_does_what_the_scenario_asks(played, scenario):
    verdicts, said = played
    assert verdicts[scenario] == "ok", said
