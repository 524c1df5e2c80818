"""Hours with a fault every two minutes: outside them no tick and no frame is lost."""

import numpy as np
import pytest
from node_world import LONGEST_PASS, ON_CAN, STATE, TIME, Event, live

HOUR = 3_600_000  # ms
EVERY, WATCHED = 120_000, 1000  # ms between the begins of faults; after an end until all is well
LONGEST = 20_000  # ms of a fault
TICK = 0.01  # s
# What befalls it, its value and the one that ends it.
FAULTS = (
    *(("SENSORS", value, 0) for value in (1, 2, 3, 4, 8, 32, 35)),
    *(("CLOCK_HELD", 1, 0), ("GLITCH", 0, 1), ("GLITCH", 1, 1)),
    *(("CONTROLLER", 1, 0), ("CONTROLLER", 2, 0), ("ACKNOWLEDGED", 0, 1)),
    *(("SHORTED", 1, 0), ("SHORTED", 2, 0), ("FOREIGN", STATE, 0x7FF)),
    *(("USB_READS", 0, 1), ("USB_PLUGGED", 0, 1), ("TYPED", ord("O"), ord("C"))),
    *(("CLOCK_HELD_AFTER", 9, 0), ("DATA_HELD_AFTER", 16 * 9 + 5, 0)),
)


def faults_of(hours: int, seed: int) -> list[tuple[int, int, Event, Event]]:
    """Begin, end, and the events of both, of one fault after the other."""
    rng = np.random.default_rng(seed)
    found = []
    for begin in range(EVERY, hours * HOUR, EVERY):
        kind, value, back = FAULTS[rng.integers(len(FAULTS))]
        end = begin + int(np.exp(rng.uniform(np.log(10), np.log(LONGEST))))
        undo = "CLOCK_HELD" if kind == "CLOCK_HELD_AFTER" else kind
        found.append((begin, end, (begin, kind, value), (end, undo, back)))
    return found


def assert_all_is_well_outside_the_faults(hours: int, folder, limit: float):
    faults = faults_of(hours, seed=hours)
    events: list[Event] = [(0, "PASS", 250), (2000, "QUIET", 0)]
    events += [event for fault in faults for event in fault[2:]]
    life = live("node_world_fast", [*events, (hours * HOUR, "END", 0)], folder, limit=limit)
    assert life.restarts.size == 0
    assert life.longest_pass < 2 * TICK
    news = life.records[life.records["link"] == ON_CAN]
    late = news[news["at_ms"] > 3000]  # the first frame that a quiet report hears is news to it
    assert (late["id"] == STATE).sum() > 20 * hours  # faults were told
    assert not (late["id"] == TIME).any()  # MissedTicks stayed at 0
    begins, ends = (np.array([fault[at] for fault in faults]) for at in (0, 1))
    last = np.searchsorted(begins, late["at_ms"], side="right") - 1
    inside = (last >= 0) & (late["at_ms"] <= ends[last] + WATCHED)
    assert inside.all(), late[~inside]
    assert life.records[-1]["link"] == LONGEST_PASS
    ticks = (hours * HOUR // 10 - 1) % 65536  # the last one is just about to come
    assert life.records[-1]["id"] == ticks


def test_an_hour_without_a_lost_tick_outside_the_faults(tmp_path):
    assert_all_is_well_outside_the_faults(1, tmp_path, limit=100)


@pytest.mark.proof
def test_a_day_without_a_lost_tick_outside_the_faults(tmp_path):
    assert_all_is_well_outside_the_faults(24, tmp_path, limit=800)
