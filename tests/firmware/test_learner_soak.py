"""A node that learns the same leg for a day: nothing wears out, nothing is believed too much."""

import subprocess
import threading

import numpy as np
import pytest
from learner_runs import EVERY, TOLD, Ticks
from simulated_legs import TICK, Legs, session

from exoid.recordings.filter.learning import LEARNING

DROPS = 40
HOUR = 3600  # s
LIKELY = 5.0  # standard errors: the worst of a day of drops, all of which count
MOST_DROPS = 255
GOOD, ENOUGH = 2, 3


def drops_of(legs: Legs) -> bytes:
    """The ticks of an hour's quarter, with losses."""
    rng = np.random.default_rng(21)
    ticks = Ticks.sound(*legs.sensed(session(legs, rng, DROPS), rng))
    ticks.sees_angle[:] = rng.random(ticks.count.shape) > 1e-4
    ticks.missed[rng.integers(0, len(ticks.count), 3)] = 1
    records = np.frombuffer(ticks.records(), "<i4").reshape(-1, 6).copy()
    records[:, -1] = 0  # it never forgets
    return records.tobytes()


def learned_of(program, records: bytes, times: int) -> np.ndarray:
    """What is told of the same ticks, so many times one after the other."""
    command = [program, "/dev/stdin", "/dev/stdout"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as running:
        assert running.stdout is not None
        feeding = threading.Thread(target=feed, args=(running.stdin, records, times))
        feeding.start()
        told = running.stdout.read()
        feeding.join()
    assert running.returncode == 0
    return np.frombuffer(told, TOLD)


def feed(pipe, records: bytes, times: int) -> None:
    for _ in range(times):
        pipe.write(records)
    pipe.close()


def assert_it_stays_true(build, hours: float) -> None:
    legs = Legs.drawn(1, np.random.default_rng(20))
    records = drops_of(legs)
    ticks = len(records) // 24
    times = round(hours * HOUR / TICK / ticks) + 1
    told = learned_of(build("host_learner"), records, times)
    assert told.size == ticks * times // EVERY
    moved = told[told["counted"] > 0]
    assert np.all(moved["variance"] > 1e-12)
    for name in ("mean", "upper", "ratio", "error", "surprise"):
        assert np.all(np.isfinite(told[name])), name
    assert np.all(told["error"] >= np.array(LEARNING.least_error, np.float32))
    known = told[told["drops"] > 0]
    assert known.size > 0.98 * told.size
    off = np.abs(known["ratio"] - legs.ratios[:, 0]) / known["error"]
    assert off.max() < LIKELY
    last = known[-1]
    assert last["drops"] == min(MOST_DROPS, last["drops"]) > DROPS / 2
    assert last["trust"] in (GOOD, ENOUGH)
    assert last["error"][0] < 0.003 * last["ratio"][0]


def test_an_hour_of_drops_leaves_errors_that_are_true(build):
    assert_it_stays_true(build, 1)


@pytest.mark.proof
def test_a_day_of_drops_leaves_errors_that_are_true(build):
    assert_it_stays_true(build, 24)
