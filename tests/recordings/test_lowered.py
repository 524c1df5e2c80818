"""What a hand lowers is no drop, beside drops of the same leg that swing: Eq. 9 by SciPy, and a
hand's minimum-jerk movements.
"""

from dataclasses import replace

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.conventions.apply import understand
from exoid.recordings.conventions.lowered import lowered
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import cut_table
from legs import ADULT, BODY, balance_of, fall, recording

NOISE, RATE = 8e-4, 100
REST = balance_of(ADULT)


def moved(start, end, lasting) -> np.ndarray:
    share = np.linspace(0, 1, int(lasting * RATE))
    return start + (end - start) * (10 * share**3 - 15 * share**4 + 6 * share**5)


def still(angle, lasting) -> np.ndarray:
    return np.full(int(lasting * RATE), angle)


def sensed(*parts, noise=NOISE) -> Segment:
    angle = np.concatenate(parts)
    noisy = angle + noise * np.random.default_rng(0).standard_normal(angle.size)
    return Segment(np.arange(angle.size) / RATE, raw_angle=noisy)


def log(*parts, noise=NOISE) -> Recording:
    sensors = Sensors(angle_noise=noise)
    return Recording((sensed(*parts, noise=noise),), BODY, Protocol(), sensors)


def lifted(start, begin=REST) -> list[np.ndarray]:
    return [still(begin, 1.0), moved(begin, start, 1.4), still(start, 1.0)]


def dropped(start, begin=REST) -> list[np.ndarray]:
    return [*lifted(start, begin), fall(start=start, duration=9.0)[1]]


@pytest.mark.parametrize("noise", [NOISE, 5e-3])
@pytest.mark.parametrize(("far", "lasting"), [(0.45, 0.8), (0.6, 1.0), (0.8, 1.2)])
def test_a_leg_that_is_lowered_half_way_and_lifted_again_refuses_no_log(noise, far, lasting):
    half = -0.3 - far
    again = [*lifted(-0.3), moved(-0.3, half, lasting), *dropped(-0.2, begin=half)]
    found, notes = understand(log(*dropped(-0.3), *again, noise=noise), cut_table)
    starts = [each.best_angle[:20].mean() for each in found.segments]
    np.testing.assert_allclose(starts, [-0.3, -0.2], atol=0.01)
    assert any("left out, for the leg moves slower than it falls" in each for each in notes)


@pytest.mark.parametrize("lasting", [0.8, 1.2, 2.0])
def test_lowerings_do_not_make_the_drops_those_of_another_leg(lasting):
    down = [*lifted(-0.5), moved(-0.5, REST, lasting), still(REST, 1.0)]
    found, notes = understand(log(*dropped(-0.3), *down, *dropped(-0.2), *down), cut_table)
    assert len(found.segments) == 2
    assert not any("another leg" in note for note in notes)
    assert all(drop.measured for drop in measure_drops(found).drops)


def test_segments_that_were_told_keep_their_numbers_and_a_lowered_one_is_no_drop():
    swung = [sensed(still(at, 0.5), fall(start=at, duration=9.0)[1]) for at in (-0.3, -0.2)]
    down = sensed(still(-0.5, 0.5), moved(-0.5, REST, 1.2), still(REST, 2.0))
    found, notes = understand(recording(swung[0], down, swung[1]), cut_table)
    assert len(found.segments) == 3
    assert any(note.startswith("segment 1 moves slower than this leg falls") for note in notes)
    first, second, third = measure_drops(found).drops
    assert first.measured
    assert third.measured
    assert "lowers the leg" in (second.reason or "")


@pytest.mark.parametrize("caught", [0.2, 0.35, 0.6])
def test_a_drop_that_is_caught_in_its_fall_is_none_that_was_lowered(caught):
    time, angle, speed = fall(start=-0.3, duration=9.0)
    at = int(caught * RATE)
    share = np.linspace(0, 1, int(0.2 * RATE))
    halt = angle[at] + speed[at] * 0.2 * (share - share**2 + share**3 / 3)
    stopped = sensed(still(-0.3, 0.5), angle[:at], halt, still(halt[-1], 1.0))
    swung = sensed(still(-0.3, 0.5), angle)
    assert time.size == angle.size
    assert lowered(recording(swung, stopped)) == ()
    assert lowered(recording(swung, slowed(stopped))) == (1,)


def test_beside_one_that_was_pushed_none_that_fell_by_itself_is_said_to_be_lowered():
    angle = fall(start=-0.3, duration=9.0)[1]
    begin = int(np.argmax(angle < -0.9))  # a push: it has the speed of a fall from higher up
    pushed = sensed(still(angle[begin], 0.5), angle[begin:])
    caught = sensed(still(-0.3, 0.5), angle[:45], still(angle[45], 1.0))
    assert lowered(recording(pushed, caught)) == ()


def slowed(segment: Segment) -> Segment:
    return replace(segment, time=2 * segment.time)
